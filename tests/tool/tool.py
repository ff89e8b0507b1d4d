# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared by all tests of the built tool: running it in a separate directory, and checking its output."""

import atexit
import base64
import functools
import json
import os
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
import zlib
from pathlib import Path

OPTIONS = {}  # from the command line; "tool" is always given
# The seed of all random cases, the same every time; ANNULUS_TEST_SEED gives others (tools/explore).
SEED = int(os.environ.get("ANNULUS_TEST_SEED")
           or (Path(__file__).resolve().parents[1] / "seed").read_text(encoding="ascii"))
HANGING = 1800  # seconds: no call takes a hundredth of it, and a machine may be very busy
STRATEGIES = ["auto", "rebuild", "relocate", "relocate-flips", "in-place", "tolerances", "tolerances-each", "paper",
              "paper-hybrid"]
RUN_FILES = {"summary.json", "iterations.csv", "final.mesh", "final.vtu", "report.html"}
SUMMARY = {
    "seconds": {"triangulation", "motion", "total"},
    "moves": {"asked", "within_tolerance", "kept_in_place", "flipped", "reinserted", "rebuilt"},
    "arithmetic": {"filter", "interval", "exact"},
    "audit": {"checked", "failed"},
}
SUMMARY_PLAIN = {"command", "dimension", "vertices", "iterations", "strategy", "tolerance", "threads", "seed"}

TRIANGLE = [(0, 0), (1, 0), (0, 1)]
GRID = [(x, y) for x in range(6) for y in range(6)]
SPREAD = [(0, 0), (1, 0.125), (0.25, 1), (0.75, 0.875), (0.5, 0.375)]


def vtu_values(file, name):
    """The values of a DataArray of a .vtu file: base64 of the header, and of the packed blocks."""
    root = xml.etree.ElementTree.parse(file).getroot()
    assert root.get("compressor") == "vtkZLibDataCompressor" and root.get("header_type") == "UInt64"
    array = next(a for a in root.iter("DataArray") if a.get("Name") == name)
    text = array.text.strip()
    blocks, size, last = struct.unpack("<3Q", base64.b64decode(text[:32])[:24])
    length = (8 * (3 + blocks) + 2) // 3 * 4
    lengths = struct.unpack(f"<{blocks}Q", base64.b64decode(text[:length])[24:])
    packed = base64.b64decode(text[length:])
    out = b""
    for i, n in enumerate(lengths):
        block = zlib.decompress(packed[:n])
        packed = packed[n:]
        assert len(block) == (last if i == blocks - 1 and last else size)
        out += block
    code = {"Float64": "d", "Int64": "q", "UInt64": "Q", "UInt8": "B"}[array.get("type")]
    return struct.unpack(f"<{len(out) // struct.calcsize(code)}{code}", out)


@functools.cache
def at_call():
    """at_call.c as a library to be preloaded."""
    where = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, where)
    library = os.path.join(where, "at_call.so")
    subprocess.run([os.environ.get("CC") or "cc", "-shared", "-fPIC", "-O1", "-o", library,
                    str(Path(__file__).with_name("at_call.c")), "-ldl"], check=True)
    return library


def at(number, count, call, part="", rank=None):
    """The environment in which the tool sends itself this signal before its `count`-th `call` on a file with `part` in
    its path (at_call.c): at a point of the program, independent of the clock and the load of the machine."""
    ranks = {} if rank is None else {"ANNULUS_AT_RANK": str(rank)}
    return {**os.environ, **ranks, "LD_PRELOAD": at_call(), "ANNULUS_AT": f"{int(number)} {count} {call} {part}"}


def with_threads(n):
    """The environment in which the tool gets at most this many threads at once besides its first one."""
    return {**os.environ, "LD_PRELOAD": at_call(), "ANNULUS_THREADS": str(n)}


def until_it_stops(run):
    """Waits for a child process that a SIGSTOP of at() stops."""
    _, status = os.waitpid(run.pid, os.WUNTRACED)
    if not os.WIFSTOPPED(status):
        run.returncode = os.waitstatus_to_exitcode(status)
        raise AssertionError(f"it ended with {run.returncode} instead of stopping")


class ToolTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.here = Path(scratch.name)

    def run_tool(self, *words, **more):
        return subprocess.run([OPTIONS["tool"], *map(str, words)], cwd=self.here, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=HANGING, check=False,
                              **more)

    def succeed(self, *words):
        done = self.run_tool(*words)
        self.assertEqual(done.returncode, 0, f"{words}: {done.stderr}")
        return done

    def refuse(self, status, *words):
        """Exit status, nothing on standard output, exactly one line on standard error; returns that line."""
        before = self.listing()
        try:
            done = self.run_tool(*words)
        except subprocess.TimeoutExpired:
            self.fail(f"{words}: still running after {HANGING} s, expected exit status {status}")
        self.assertEqual(done.returncode, status, f"{words}: {done.stdout}{done.stderr}")
        self.assertEqual(done.stdout, "", words)
        self.assertRegex(done.stderr, r"\Aannulus: [^\n]+\n\Z", words)
        self.assertEqual(self.listing(), before, f"{words} left something behind")
        return done.stderr.rstrip("\n")

    def listing(self):
        return sorted(str(p.relative_to(self.here)) for p in self.here.rglob("*"))

    def write(self, name, content):
        path = self.here / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content, encoding="utf-8")
        return name

    def xyz(self, name, points):
        return self.write(name, "".join(" ".join(repr(c) for c in p) + "\n" for p in points))

    def summary(self, directory):
        return json.loads((self.here / directory / "summary.json").read_text(encoding="utf-8"))

    def mesh(self, directory):
        """Points and triangles of final.mesh."""
        words = (self.here / directory / "final.mesh").read_text(encoding="utf-8").split()
        at = words.index("Vertices")
        count = int(words[at + 1])
        points = [(float(words[at + 2 + 3 * i]), float(words[at + 3 + 3 * i])) for i in range(count)]
        at = words.index("Triangles")
        cells = [tuple(int(w) - 1 for w in words[at + 2 + 4 * i:at + 5 + 4 * i]) for i in range(int(words[at + 1]))]
        return points, cells


def main(usage, *more):
    """Takes --tool=PATH and a --NAME=PATH for each name of `more`. The rest goes to unittest."""
    names = ("tool", *more)
    ours = tuple(f"--{name}=" for name in names)
    OPTIONS.update(a[2:].split("=", 1) for a in sys.argv[1:] if a.startswith(ours))
    if set(OPTIONS) != set(names):
        print(usage, file=sys.stderr)
        sys.exit(2)
    OPTIONS.update({name: os.path.abspath(path) for name, path in OPTIONS.items()})
    # The caller of the tests may ignore these signals, as nohup and shells do for background processes, and child
    # processes would inherit this.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)
    unittest.main(argv=[sys.argv[0]] + [a for a in sys.argv[1:] if not a.startswith(ours)])
