#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the headers that are installed. usage: check.py ROOT | check.py --self-test

cmake/annulus-headers.cmake has two lists: headers without CGAL, which include only each other, and those of CGAL's
view, which include only headers of both. The lists have every header in src/annulus and src/annulus/internal, and no
other; the first has at most 12, both together at most 45. No header without CGAL includes anything of it, or of Boost,
TBB and GMP. In the public headers, and those of the class behind moving_delaunay_2.h and _3.h, the comment of every
member that returns a span says how long it is valid. Prints each fault, and exits with 1 if there is any.
"""

import re
import sys
import tempfile
import unittest
from pathlib import Path

MOST_PLAIN = 12
MOST = 45
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"\n]+)[>"]', re.MULTILINE)
LIST = re.compile(r"^set\((annulus_plain_headers|annulus_view_headers)\s+([^)]*)\)", re.MULTILINE)
SPAN = re.compile(r"((?:^[ \t]*///[^\n]*\n)*)^[ \t]*\[\[nodiscard\]\] std::span<[^\n(]*> (\w+)\(", re.MULTILINE)
OTHERS = ("CGAL/", "boost/", "tbb/", "oneapi/", "gmp", "mpfr")


def faults(root):
    source = root / "src" / "annulus"
    lists = {name: words.split() for name, words in
             LIST.findall((root / "cmake" / "annulus-headers.cmake").read_text(encoding="utf-8"))}
    plain, view = lists["annulus_plain_headers"], lists["annulus_view_headers"]
    if len(plain) > MOST_PLAIN:
        yield f"{len(plain)} headers without CGAL are installed, more than {MOST_PLAIN}"
    if len(plain) + len(view) > MOST:
        yield f"{len(plain) + len(view)} headers are installed, more than {MOST}"
    present = {path.relative_to(source).as_posix() for folder in (source, source / "internal")
               for path in folder.glob("*.h")}
    listed = [*plain, *view]
    for name in sorted(present - set(listed)):
        yield f"{name} is not in cmake/annulus-headers.cmake"
    for name in sorted(set(listed)):
        if listed.count(name) > 1:
            yield f"{name} is listed twice"
        if name not in present:
            yield f"{name} is listed and is not in src/annulus or its internal/"
            continue
        allowed = plain if name in plain else listed
        for included in INCLUDE.findall((source / name).read_text(encoding="utf-8")):
            if included.startswith("annulus/") and included.removeprefix("annulus/") not in allowed:
                yield f"{name} includes <{included}>, which is not " + (
                    "installed" if name in view else "one of the headers without CGAL")
            if name in plain and included.startswith(OTHERS):
                yield f"{name} includes <{included}>"
        if "/" in name and name != "internal/moving_delaunay.h":
            continue
        for comment, member in SPAN.findall((source / name).read_text(encoding="utf-8")):
            if "valid" not in comment.lower():
                yield f"{name}: {member}() returns a span, and its comment does not say how long that is valid"


class Faults(unittest.TestCase):
    RIGHT = {"cmake/annulus-headers.cmake": "set(annulus_plain_headers\n    a.h\n    b.h)\n"
                                            "set(annulus_view_headers\n    internal/v.h)\n",
             "src/annulus/a.h": "#include <vector>\n",
             "src/annulus/b.h": "#include <annulus/a.h>\n",
             "src/annulus/internal/v.h": "#include <CGAL/V.h>\n#include <annulus/b.h>\n",
             "src/annulus/mesh/m.h": ""}

    def found(self, planted):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**self.RIGHT, **planted}.items():
                path = Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return list(faults(Path(folder)))

    def test_right(self):
        self.assertEqual(self.found({}), [])
        span = "/// Valid until the next call.\n[[nodiscard]] std::span<const int> all() const;\n"
        self.assertEqual(self.found({"src/annulus/a.h": span}), [])

    def test_each_fault(self):
        for name, text, word in (
                ("src/annulus/c.h", "", "c.h is not in"),
                ("src/annulus/internal/w.h", "", "internal/w.h is not in"),
                ("src/annulus/internal/v.h", "#include <annulus/mesh/m.h>\n", "not installed"),
                ("src/annulus/a.h", "#include <annulus/internal/v.h>\n", "without CGAL"),
                ("src/annulus/a.h", "# include <CGAL/V.h>\n", "<CGAL/V.h>"),
                ("src/annulus/b.h", "#include <gmpxx.h>\n", "<gmpxx.h>"),
                ("src/annulus/b.h", "    /// All.\n    [[nodiscard]] std::span<const int> all() const;\n", "all()"),
                ("src/annulus/b.h", "[[nodiscard]] std::span<const int> all(int k) const;\n", "all()")):
            with self.subTest(name=name, text=text):
                found = self.found({name: text})
                self.assertEqual(len(found), 1, found)
                self.assertIn(word, found[0])

    def test_too_many(self):
        for plain, view, expected in ((12, 33, 0), (13, 1, 1), (12, 34, 1)):
            names = [f"h{i}.h" for i in range(plain)], [f"internal/v{i}.h" for i in range(view)]
            planted = {f"src/annulus/{name}": "" for part in names for name in part}
            lists = "set(annulus_plain_headers {})\nset(annulus_view_headers {})\n".format(
                " ".join(["a.h", "b.h", *names[0][2:]]), " ".join(["internal/v.h", *names[1][1:]]))
            for unused in (names[0][0], names[0][1], names[1][0]):
                del planted[f"src/annulus/{unused}"]
            found = self.found({**planted, "cmake/annulus-headers.cmake": lists})
            self.assertEqual(len(found), expected, found)

    def test_twice_and_absent(self):
        lists = "set(annulus_plain_headers a.h b.h a.h)\nset(annulus_view_headers internal/v.h mesh/m.h)\n"
        self.assertEqual(len(self.found({"cmake/annulus-headers.cmake": lists})), 2)


def main():
    if sys.argv[1] == "--self-test":
        return unittest.main(argv=sys.argv[:1])
    found = list(faults(Path(sys.argv[1])))
    print("\n".join([*found, f"installed headers: {len(found)} faults"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
