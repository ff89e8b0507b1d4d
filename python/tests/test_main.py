# SPDX-License-Identifier: GPL-3.0-or-later
"""``python -m annulus``."""

import os
import stat
import subprocess
import sys


def run(path, *arguments):
    return subprocess.run([sys.executable, "-m", "annulus", *arguments], capture_output=True, text=True,
                          env={**os.environ, "PATH": str(path)}, check=False)


def test_runs_the_tool_with_the_same_arguments(tmp_path):
    tool = tmp_path / "annulus"
    tool.write_text('#!/bin/sh\nprintf "%s|" "$@"\nexit 3\n', encoding="utf-8")
    tool.chmod(tool.stat().st_mode | stat.S_IXUSR)
    done = run(tmp_path, "lloyd", "--points", "a b")
    assert (done.returncode, done.stdout, done.stderr) == (3, "lloyd|--points|a b|", "")


def test_says_that_there_is_no_tool(tmp_path):
    done = run(tmp_path, "--version")
    assert done.returncode == 2 and done.stdout == ""
    assert done.stderr.startswith("python -m annulus: ") and done.stderr.count("\n") == 1
