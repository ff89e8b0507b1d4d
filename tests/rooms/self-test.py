#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plants one violation at a time and expects tools/check-rooms to name it. usage: self-test.py CHECK_ROOMS"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK_ROOMS = sys.argv.pop(1)
SPDX = "// SPDX-License-Identifier: GPL-3.0-or-later\n"
HEADER = SPDX + "#pragma once\n"

CLEAN = {
    "src/annulus/arithmetic/exact.h": HEADER + "#include <gmpxx.h>\n",
    "src/annulus/certificate/bounds.h": HEADER + "#include <annulus/arithmetic/exact.h>\n",
    "src/annulus/cgal/build.cpp": SPDX + "#include <CGAL/Object.h>\n#include <annulus/certificate/bounds.h>\n",
    "src/annulus/cgal/flips.h": HEADER + "#include <CGAL/Object.h>\n",
    "src/annulus/moving.h": HEADER + "#include <CGAL/Object.h>\n#include <annulus/report/report.h>\n",
    "src/annulus/report/report.h": HEADER + "/*\n#include <annulus/cli/never.h>\n*/\n// #include <annulus/cli/never.h>\n",
    "src/annulus/c/mesh.cpp": SPDX + "#include <annulus/moving.h>\n",
    "src/annulus/cli/main.cpp": SPDX + "#include <annulus/moving.h>\n#include <annulus/report/report.h>\n",
    "tests/exact_test.cpp": SPDX + '#include "common.h"\n#include <CGAL/Object.h>\n',
}


class CheckRooms(unittest.TestCase):
    def check(self, planted):
        with tempfile.TemporaryDirectory() as root:
            for name, text in {**CLEAN, **planted}.items():
                path = Path(root, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return subprocess.run([CHECK_ROOMS, root], capture_output=True, text=True, check=False)

    def rejects(self, name, text, line):
        result = self.check({name: text})
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertIn(f"{name}:{line}: ", result.stdout)
        self.assertIn(" 1 violations", result.stdout)

    def test_clean_tree_passes(self):
        result = self.check({})
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("0 violations, 0 warnings", result.stdout)

    def test_room_below(self):
        self.rejects("src/annulus/arithmetic/up.h", HEADER + "\n#include <annulus/certificate/bounds.h>\n", 4)
        self.rejects("src/annulus/formats/deep/er.cpp", SPDX + "  #  include <annulus/cli/x.h>\n", 2)

    def test_line_after_a_block_comment(self):
        self.rejects("src/annulus/formats/x.h", HEADER + "/* one\ntwo */\n#include <annulus/cli/x.h>\n", 5)

    def test_public_header_from_a_room(self):
        self.rejects("src/annulus/motion/lloyd.h", HEADER + "#include <annulus/moving.h>\n", 3)

    def test_clients_from_a_public_header_and_from_one_another(self):
        self.rejects("src/annulus/other.h", HEADER + "#include <annulus/cli/x.h>\n", 3)
        self.rejects("src/annulus/other.h", HEADER + "#include <annulus/c/x.h>\n", 3)
        self.rejects("src/annulus/cli/x.cpp", SPDX + "#include <annulus/c/x.h>\n", 2)
        self.rejects("src/annulus/c/x.cpp", SPDX + "#include <annulus/cli/x.h>\n", 2)

    def test_quoted_include(self):
        self.rejects("src/annulus/certificate/x.cpp", SPDX + '#include "../cli/x.h"\n', 2)

    def test_cgal_where_it_may_not_be(self):
        for room in ("arithmetic", "certificate", "mesh", "engine", "statistics", "formats", "report", "c", "cli"):
            self.rejects(f"src/annulus/{room}/x.cpp", SPDX + "#include <CGAL/Object.h>\n", 2)

    def test_unknown_room(self):
        self.rejects("src/annulus/attic/x.cpp", SPDX, 1)
        self.rejects("src/annulus/formats/x.cpp", SPDX + "#include <annulus/attic/x.h>\n", 2)

    def test_pragma_once_and_licence(self):
        self.rejects("src/annulus/formats/x.h", SPDX, 1)
        self.rejects("src/annulus/formats/x.h", SPDX + "// #pragma once\n", 1)
        self.rejects("src/annulus/formats/x.h", "#pragma once\n", 1)
        self.rejects("tests/x.cpp", "int x;\n", 1)
        self.rejects("tests/x.c", "int x;\n", 1)

    def test_long_file_is_a_warning(self):
        result = self.check({"src/annulus/formats/long.cpp": SPDX + "\n" * 400})
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("src/annulus/formats/long.cpp:401: warning: 401 lines", result.stdout)


if __name__ == "__main__":
    unittest.main()
