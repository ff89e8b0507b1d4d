#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plants one violation at a time and expects tools/check-modules to name it. usage: self-test.py CHECK_MODULES"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK_MODULES = sys.argv.pop(1)
SPDX = "// SPDX-License-Identifier: GPL-3.0-or-later\n"
HEADER = SPDX + "#pragma once\n"
STANDARD = "#include <annulus/types.h>\n"

CLEAN = {
    "src/annulus/annulus.h": HEADER,
    "src/annulus/types.h": HEADER,
    "src/annulus/arithmetic/exact.h": HEADER + STANDARD + "#include <gmpxx.h>\n",
    "src/annulus/predicate/bounds.h": HEADER + "#include <annulus/arithmetic/exact.h>\n",
    "src/annulus/internal/build.cpp": SPDX + "#include <CGAL/Object.h>\n#include <annulus/predicate/bounds.h>\n",
    "src/annulus/internal/flips.h": HEADER + STANDARD + "#include <CGAL/Object.h>\n",
    "src/annulus/moving.h": HEADER + "#include <CGAL/Object.h>\n#include <annulus/internal/flips.h>\n",
    "src/apps/cli/x.h": HEADER,
    "src/apps/report/report.h": HEADER + "#include <nlohmann/json.hpp>\n#include <annulus/predicate/bounds.h>\n"
    + "/*\n#include <apps/cli/never.h>\n*/\n// #include <apps/cli/never.h>\n",
    "src/annulus/c/mesh.cpp": SPDX + "#include <annulus/moving.h>\n",
    "src/apps/cli/main.cpp": SPDX + "#include <annulus/moving.h>\n#include <apps/report/report.h>\n",
    "tests/exact_test.cpp": SPDX + '#include "common.h"\n#include <CGAL/Object.h>\n',
}


class CheckModules(unittest.TestCase):
    def check(self, planted):
        with tempfile.TemporaryDirectory() as root:
            for name, text in {**CLEAN, **planted}.items():
                path = Path(root, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return subprocess.run([CHECK_MODULES, root], capture_output=True, text=True, check=False)

    def rejects(self, name, text, line):
        result = self.check({name: text})
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertIn(f"{name}:{line}: ", result.stdout)
        self.assertIn(" 1 violations", result.stdout)

    def test_clean_tree_passes(self):
        result = self.check({})
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("0 violations, 0 warnings", result.stdout)

    def test_module_below(self):
        self.rejects("src/annulus/arithmetic/up.h", HEADER + "\n#include <annulus/predicate/bounds.h>\n", 4)
        self.rejects("src/apps/formats/deep/er.cpp", SPDX + "  #  include <apps/cli/x.h>\n", 2)

    def test_line_after_a_block_comment(self):
        self.rejects("src/apps/formats/x.h", HEADER + "/* one\ntwo */\n#include <apps/cli/x.h>\n", 5)

    def test_public_header_from_a_module(self):
        self.rejects("src/apps/motion/lloyd.h", HEADER + "#include <annulus/moving.h>\n", 3)
        self.assertEqual(self.check({"src/annulus/version.h": HEADER, "src/apps/motion/lloyd.cpp": SPDX
                                     + "#include <annulus/version.h>\n"}).returncode, 0)

    def test_plain_header(self):
        self.rejects("src/annulus/error.h", HEADER + STANDARD + "#include <annulus/moving.h>\n", 4)
        self.rejects("src/annulus/error.h", HEADER + STANDARD + "#include <annulus/predicate/bounds.h>\n", 4)
        self.rejects("src/annulus/mesh/x.h", HEADER + "#include <annulus/options.h>\n", 3)
        self.rejects("src/annulus/space/x.h", HEADER + "#include <annulus/internal/index.h>\n", 3)
        self.rejects("src/annulus/internal/index.h", HEADER + "#include <annulus/predicate/bounds.h>\n", 3)
        self.assertEqual(self.check({"src/annulus/options.h": HEADER + STANDARD, "src/annulus/engine/x.h": HEADER
                                     + "#include <annulus/options.h>\n"}).returncode, 0)

    def test_clients_from_a_public_header_and_from_one_another(self):
        self.rejects("src/annulus/other.h", HEADER + "#include <annulus/c/x.h>\n", 3)
        self.rejects("src/apps/cli/x.cpp", SPDX + "#include <annulus/c/x.h>\n", 2)
        self.rejects("src/annulus/c/x.cpp", SPDX + "#include <apps/cli/x.h>\n", 2)

    def test_library_without_programs(self):
        self.rejects("src/annulus/other.h", HEADER + STANDARD + "#include <apps/report/report.h>\n", 4)
        self.rejects("src/annulus/other.h", HEADER + STANDARD + "#include <apps/cli/x.h>\n", 4)
        self.rejects("src/annulus/measure/x.cpp", SPDX + "#include <apps/motion/x.h>\n", 2)
        self.rejects("src/annulus/measure/x.cpp", SPDX + "#include <nlohmann/json.hpp>\n", 2)
        self.rejects("src/annulus/x.cpp", SPDX + "#include <png.h>\n", 2)
        self.rejects("src/annulus/c/x.cpp", SPDX + "#include <zlib.h>\n", 2)
        self.rejects("src/annulus/x.cpp", SPDX + "#include <jpeglib.h>\n", 2)

    def test_namespace_without_a_version(self):
        self.rejects("src/annulus/predicate/x.cpp", SPDX + "\nnamespace annulus {\n}\n", 3)
        self.rejects("src/apps/formats/x.cpp", SPDX + "namespace annulus::detail {\n}\n", 2)
        good = SPDX + "namespace annulus::inline v1::detail {\n}\nnamespace annulus::inline v1 {\n}\n"
        other = SPDX + "namespace annulus {\n}\n"
        self.assertEqual(self.check({"src/annulus/predicate/x.cpp": good, "tests/x.cpp": other}).returncode, 0)

    def test_quoted_include(self):
        self.rejects("src/annulus/predicate/x.cpp", SPDX + '#include "../cli/x.h"\n', 2)

    def test_cgal_where_it_may_not_be(self):
        for module in ("annulus/arithmetic", "annulus/space", "annulus/predicate", "annulus/mesh", "annulus/engine",
                       "annulus/measure", "annulus/c", "apps/formats", "apps/report", "apps/cli"):
            self.rejects(f"src/{module}/x.cpp", SPDX + "#include <CGAL/Object.h>\n", 2)

    def test_unknown_module(self):
        self.rejects("src/annulus/attic/x.cpp", SPDX, 1)
        self.rejects("src/annulus/motion/x.cpp", SPDX, 1)  # in the other part
        self.rejects("src/apps/measure/x.cpp", SPDX, 1)
        self.rejects("src/apps/x.cpp", SPDX, 1)
        self.rejects("src/attic/x.cpp", SPDX, 1)
        self.rejects("src/apps/formats/x.cpp", SPDX + "#include <annulus/attic/x.h>\n", 2)
        self.rejects("src/apps/formats/x.cpp", SPDX + "#include <annulus/motion/x.h>\n", 2)
        self.rejects("src/apps/formats/x.cpp", SPDX + "#include <apps/mesh/x.h>\n", 2)
        self.rejects("src/apps/formats/x.cpp", SPDX + "#include <apps/x.h>\n", 2)

    def test_catch_by_another_way(self):
        self.rejects("tests/exact_test.cpp", SPDX + "#include <vector>\n#include <catch2/catch.hpp>\n", 3)
        self.rejects("tests/support/more.h", HEADER + "#include <catch2/catch_test_macros.hpp>\n", 3)
        self.rejects("fuzz/common/x.h", HEADER + "#include <catch2/catch_all.hpp>\n", 3)
        self.rejects("src/annulus/mesh/x.cpp", SPDX + "#include <catch2/catch.hpp>\n", 2)
        for name, text in (("tests/support/catch.h", HEADER + "#include <catch2/catch.hpp>\n"),
                           ("tests/exact_test.cpp", SPDX
                            + "#include <support/catch.h>\n// #include <catch2/catch.hpp>\n")):
            self.assertEqual(self.check({name: text}).returncode, 0, name)

    # Each with its constraint on the line given by the second element, from 1.
    DECLARED = (
        ("template <int d>\nrequires(d == 2)\nint f(int x);", 2),
        ("template <class T> requires std::integral<T> void f(T x);", 1),
        ("template <class T>\nvoid f(T x)\n    requires std::integral<T> && (sizeof(T) > 1);", 3),
        ("struct A {\n    int size() const requires(d == 3);\n    int other() { return 1; }\n};", 2),
        ("template <class T> requires requires(T t) { t.f(); t.g(); } void f(T x, int y = 2);", 1),
        ("template <class T>\nrequires B<T>\nbool operator==(T, T);", 2),
        ("template <class T> requires B<T> A(T x) noexcept;", 1),
        ("const char* x = \"a; {\";  // one; {\ntemplate <class T> requires /* { */ B<T> void f(T);", 2),
    )
    DEFINED = (
        "template <int d>\nrequires(d == 2)\nint f(int x) { return x; }",
        "template <class T> void f(T x) requires std::integral<T> { g(x); }",
        "template <class T> requires requires(T t) { t.f(); } void f(T x) { x.f(); }",
        "template <class T> requires B<T> A(T x) : x_{x}, y_(1) { g(); }",
        "template <class T> concept C = B<T> && requires(T t) { t.f(); };\nvoid f(int x);",
        "template <class T> concept C = requires { typename T::x; };",
        "template <class T> requires B<T> struct A;",
        "template <class T> requires B<T> inline constexpr int a = 3;",
        "struct A {\n    A() requires(d == 2) = default;\n};",
        "template <class T> void f(T t) { if constexpr (requires { t.f(); }) t.f(); }\nvoid g();",
        "// what it requires;\n/* requires x; */\nconst char* x = \"requires B<T> void f();\";\nconst char* y = "
        "R\"(requires \"B)\";",
    )

    def test_constraints_of_what_has_no_body(self):
        names = {f"src/annulus/mesh/declared{i}.h": code for i, code in enumerate(self.DECLARED)}
        result = self.check({name: HEADER + STANDARD + code + "\n" for name, (code, _) in names.items()})
        self.assertEqual(result.returncode, 1)
        said = [line.split(": ")[0] for line in result.stdout.splitlines() if "(`requires`)" in line]
        self.assertEqual(said, [f"{name}:{3 + line}" for name, (_, line) in names.items()])
        self.assertIn(f" {len(names)} violations", result.stdout)
        code = self.DECLARED[0][0] + "\n"
        result = self.check({f"src/annulus/mesh/defined{i}.h": HEADER + STANDARD + text + "\n"
                             for i, text in enumerate(self.DEFINED)} |
                            {"src/annulus/mesh/x.cpp": SPDX + code, "tests/x.h": HEADER + code})
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_an_older_standard_would_not_be_told(self):
        self.rejects("src/annulus/internal/x.h", HEADER + "#include <span>\n", 1)
        self.rejects("src/annulus/internal/x.h", HEADER + "/*\n" + STANDARD + "*/\n", 1)
        self.rejects("src/annulus/other.h", HEADER, 1)
        self.assertEqual(self.check({"src/apps/formats/x.h": HEADER + "#include <span>\n",
                                     "src/annulus/mesh/x.h": HEADER + "#include <span>\n"}).returncode, 0)

    def test_pragma_once_and_licence(self):
        self.rejects("src/apps/formats/x.h", SPDX + STANDARD, 1)
        self.rejects("src/apps/formats/x.h", SPDX + "// #pragma once\n" + STANDARD, 1)
        self.rejects("src/apps/formats/x.h", "#pragma once\n" + STANDARD, 1)
        self.rejects("tests/x.cpp", "int x;\n", 1)
        self.rejects("tests/x.c", "int x;\n", 1)

    def test_long_file_is_a_warning(self):
        result = self.check({"src/apps/formats/long.cpp": SPDX + "\n" * 400})
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("src/apps/formats/long.cpp:401: warning: 401 lines", result.stdout)


if __name__ == "__main__":
    unittest.main()
