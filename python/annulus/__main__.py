# SPDX-License-Identifier: GPL-3.0-or-later
"""``python -m annulus ARGUMENTS``: runs the command-line tool ``annulus`` with these arguments, if it is installed."""

import os
import shutil
import sys


def main() -> int:
    tool = shutil.which("annulus")
    if tool is None:
        print("python -m annulus: the command-line tool annulus is not on PATH; the module itself has MovingDelaunay, "
              "degeneracy, counterexample, lloyd and nodt", file=sys.stderr)
        return 2
    os.execv(tool, [tool, *sys.argv[1:]])
    return 0


if __name__ == "__main__":
    sys.exit(main())
