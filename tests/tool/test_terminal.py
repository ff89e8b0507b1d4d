#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The progress line on a terminal. usage: test_terminal.py --tool=PATH [CLASS[.METHOD]...]"""

import fcntl
import os
import pty
import struct
import subprocess
import termios
import threading

import tool
from tool import OPTIONS, ToolTest


class Screen:
    """A terminal with this many columns, as far as the progress line needs one: it counts rows that begin by
    wrapping."""

    def __init__(self, columns):
        self.columns, self.column, self.wrapped, self.widest = columns, 0, 0, 0
        self.row, self.rows = "", []

    def feed(self, text):
        i = 0
        while i < len(text):
            if text.startswith("\033[K", i):
                self.row = self.row[:self.column]
                i += 3
                continue
            c = text[i]
            i += 1
            if c == "\r":
                if self.row:
                    self.rows.append(self.row)
                self.column = 0
            elif c == "\n":
                self.row, self.column = "", 0
            else:
                assert " " <= c <= "~", repr(c)
                if self.column == self.columns:
                    self.wrapped += 1
                    self.row, self.column = "", 0
                self.row = self.row[:self.column] + c
                self.column += 1
                self.widest = max(self.widest, self.column)


class ProgressLine(ToolTest):
    def drawn(self, columns, *words, environment=(), rows=24):
        """The tool's standard error on a terminal with this many columns; 0: unknown."""
        ours, theirs = pty.openpty()
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", rows if columns else 0, columns, 0, 0))
        env = {k: v for k, v in os.environ.items() if k not in ("COLUMNS", "TERM")} | {"TERM": "xterm"} | dict(
            environment)
        end = b"\0"
        with subprocess.Popen([OPTIONS["tool"], *map(str, words)], cwd=self.here, stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=theirs, env=env) as process:
            # A terminal may lose its last output when it is closed. So it stays open, and the test writes a last byte.
            closing = threading.Thread(target=lambda: (process.wait(), os.write(theirs, end)))
            closing.start()
            text = b""
            while not text.endswith(end):
                text += os.read(ours, 65536)
            closing.join()
        os.close(theirs)
        os.close(ours)
        self.assertEqual(process.returncode, 0, text)
        return text.removesuffix(end).decode("utf-8")

    # The last step is always drawn, independently of the clock.
    LLOYD = ("lloyd", "--points", "300", "--iterations", "40")

    def test_fits_whatever_the_width(self):
        for columns in (1, 2, 5, 10, 20, 39, 40, 52, 60, 79, 80, 81, 100, 120, 300):
            for words in (self.LLOYD, ("nodt", "--sphere", "--vertices", "60", "--iterations", "3"),
                          ("compare", "--strategies", "paper-hybrid:certified,rebuild", "--", *self.LLOYD)):
                with self.subTest(columns=columns, words=words):
                    text = self.drawn(columns, *words)
                    screen = Screen(columns)
                    screen.feed(text)
                    self.assertEqual(screen.wrapped, 0)
                    self.assertLess(screen.widest, max(columns, 2))
                    self.assertTrue(text.endswith("\r\033[K"), repr(text))  # nothing is left
                    if columns >= 40:
                        self.assertTrue(any(row.startswith(words[0] + " ") for row in screen.rows), repr(text))

    def test_says_everything_where_there_is_room(self):
        screen = Screen(120)
        screen.feed(self.drawn(120, *self.LLOYD))
        self.assertRegex(screen.rows[-1], r"\Alloyd #{30} 100 %  40/40  \d+ steps/s  [\d.]+ % within tolerance\Z")
        screen = Screen(80)
        screen.feed(self.drawn(80, *self.LLOYD))
        self.assertRegex(screen.rows[-1], r"\Alloyd #{5,29} 100 %  40/40  \d+ steps/s  [\d.]+ % within tolerance\Z")

    def test_leaves_out_whole_parts_where_there_is_not(self):
        """The news first, then the rate: no part is cut."""
        for columns, expected in ((60, r"lloyd (#+ )?100 %  40/40  \d+ steps/s(  [\d.]+ % within tolerance)?"),
                                  (40, r"lloyd (#{5,} )?100 %  40/40  \d+ steps/s"), (25, r"lloyd #{5} 100 %  40/40"),
                                  (24, r"lloyd 100 %  40/40"), (19, r"lloyd 100 %  40/40"), (12, r"lloyd 100 %")):
            with self.subTest(columns=columns):
                screen = Screen(columns)
                screen.feed(self.drawn(columns, *self.LLOYD))
                self.assertRegex(screen.rows[-1], rf"\A{expected}\Z")

    def test_the_environment_says_how_wide_where_the_terminal_does_not(self):
        for environment, columns in (({"COLUMNS": "33"}, 33), ({}, 80), ({"COLUMNS": "wide"}, 80),
                                     ({"COLUMNS": "0"}, 80)):
            screen = Screen(columns)
            screen.feed(self.drawn(0, *self.LLOYD, environment=environment))
            self.assertEqual(screen.wrapped, 0, environment)
            self.assertGreater(screen.widest, columns - 30, environment)
        screen = Screen(50)
        screen.feed(self.drawn(50, *self.LLOYD, environment={"COLUMNS": "200"}))
        self.assertEqual(screen.wrapped, 0)

    def test_nothing_is_drawn(self):
        for terminal in ("dumb", ""):
            self.assertEqual(self.drawn(80, *self.LLOYD, environment={"TERM": terminal}), "")
        self.assertEqual(self.drawn(80, *self.LLOYD, "--quiet"), "")
        self.assertEqual(self.run_tool(*self.LLOYD).stderr, "")  # no terminal


if __name__ == "__main__":
    tool.main(__doc__)
