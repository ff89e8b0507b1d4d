#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests that tools/check-docs finds the faults of a page. usage: self-test.py CHECK_DOCS"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK = sys.argv.pop(1)

RIGHT = """# A page

[itself](#what-it-does), [the other](other.md#a-b), `[no](link)`

## What it does?

```sh
echo done > file
```

```sh
test "$(cat file)" = done
```

<!-- file: program.c -->
```c
int x;
```

<!-- not-run: why not -->
```sh
false
```
"""


class CheckDocs(unittest.TestCase):
    def check(self, page, *more):
        with tempfile.TemporaryDirectory() as root:
            Path(root, "docs").mkdir()
            Path(root, "docs", "page.md").write_text(page)
            Path(root, "docs", "other.md").write_text("# A, b\n")
            Path(root, "program.c").write_text("/* head */\n    /* [docs] */\n    int x;\n    /* [docs] */\n")
            return subprocess.run([CHECK, f"--root={root}", *(more or ["docs/page.md"])], check=False,
                                  capture_output=True, text=True)

    def wrong(self, old, new, complaint, *more):
        self.assertIn(old, RIGHT)
        done = self.check(RIGHT.replace(old, new, 1), *more)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertRegex(done.stdout + done.stderr, complaint)

    def test_right(self):
        done = self.check(RIGHT)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("2 blocks run, 1 blocks compared, 1 blocks not run; 0 wrong", done.stdout)

    def test_command_that_fails(self):
        self.wrong("= done", "= undone", r"docs/page.md:11: exit status 1")

    def test_program_that_differs(self):
        self.wrong("int x;", "int y;", r"docs/page.md:17: differs from program.c")

    def test_program_of_no_file(self):
        self.wrong("<!-- file: program.c -->\n", "", r"stands in no file")

    def test_marker_without_reason(self):
        self.wrong("not-run: why not", "not-run:", r"says nothing")

    def test_marker_that_is_none(self):
        self.wrong("<!-- not-run: why not -->", "<!-- not run -->", r"not a marker")

    def test_links(self):
        for more in [(), ("--links",)]:
            self.wrong("other.md#a-b", "absent.md", r"docs/page.md:3: there is no absent.md", *more)
            self.wrong("other.md#a-b", "other.md#b", r"other.md has no heading #b", *more)
            self.wrong("(#what-it-does)", "(#what)", r"has no heading #what", *more)

    def test_open_block(self):
        self.wrong("false\n```", "false", r"is not closed")


if __name__ == "__main__":
    unittest.main()
