# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls that concern some vertices, sets of points that are hard on a motion, and calm steps in Python."""

import json
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from .measure import ROOT, audits, limits

GROWTH = 1.5                              # must; and microseconds of an insertion, must and aim
MICROSECONDS = {2: (15, 8), 3: (40, 20)}


def edits(bench):
    """Few vertices that move, and insertions one by one."""
    n = 4000 if bench.quick else 20000
    yield from [f"## A few vertices move by one spacing, 3D, {n} points", "",
                "One call of `Moving_mesh::move(indices, points)`, and CGAL's `move_if_no_collision` for each. Times "
                "are a vertex that moves; medians.", "",
                "| vertices that move | CGAL / auto | must | reached | aim | auto, us | CGAL, us | audit |",
                "|---|---|---|---|---|---|---|---|"]
    for movers in (200, 20, 1):
        r = bench.call("annulus-edits", what="few", points=n, movers=movers,
                       repeat=11 if bench.quick else 301 if movers == 1 else 61)[0]
        yield (f"| {movers} | {r['ratio']:.2f} | {limits(r['ratio'], 1, 2)} | {r['ns'] / 1000:.1f} "
               f"| {r['cgal_ns'] / 1000:.1f} | {'right' if r['audit'] else '**WRONG**'} |")
    sizes = (10000, 40000) if bench.quick else (10000, 100000, 1000000)
    yield from ["", "### Insertions one by one at random places", "",
                "`Moving_mesh::insert` and CGAL's `insert` without a hint, in turn; medians of batches of 20. Growth "
                f"is that of the time from {sizes[0]} points to {sizes[-1]}.", "",
                "| | ours, us | must | reached | aim | CGAL, us | growth | must | reached | audit |",
                "|---|---|---|---|---|---|---|---|---|---|"]
    for d in (2, 3):
        runs = [bench.call("annulus-edits", what="insertion", dimension=d, points=n, repeat=51)[0] for n in sizes]
        for r in runs:
            last = r is runs[-1]
            us = r["ns"] / 1000
            growth = r["ns"] / runs[0]["ns"]
            grown = f"{growth:.2f} | {limits(growth, GROWTH, None, False).rsplit(' |', 1)[0]}" if last else " | |"
            yield (f"| {d}D, {r['points']} points | {us:.1f} "
                   f"| {limits(us, *(MICROSECONDS[d] if last else (None, None)), False)} | {r['cgal_ns'] / 1000:.1f} "
                   f"| {grown} | {'right' if r['audit'] else '**WRONG**'} |")
    yield ""


def hard(bench):
    """Outliers, hubs, points in convex position: what a step costs beside CGAL's rebuild."""
    yield from ["## Outliers, hubs, points in convex position", "",
                "What a call costs over CGAL's insertion of all points, `Moving_mesh` with `auto`. Outliers: one point "
                "in a hundred is some 1,000 times as far away as the others are wide. Hubs: eight vertices with "
                "thousands of neighbours. Convex position: a 64th of the points of a sphere or circle move on it "
                "in one call, by index.", "",
                "| | cost over CGAL's rebuild | must | reached | aim | most expensive | ours, ns | CGAL, ns | audit |",
                "|---|---|---|---|---|---|---|---|---|"]
    for d, n in ((3, 8000), (2, 20000)):
        n = n // 4 if bench.quick else n
        for family in ("outliers", "hubs"):
            for s in (0.01, 1):
                run = bench.call("annulus-motions", dimension=d, family=family, points=n, spacings=s,
                                 steps=8 if bench.quick else 24, warm=3, strategies="auto:mesh")[0]
                mesh = run["auto:mesh"]
                cost = 1 / mesh["ratio"]
                yield (f"| {family}, {d}D, {n}, s = {s:g} | {cost:.3f} | {limits(cost, 1, 0.5, False)} "
                       f"| {mesh['most expensive']:.2f} | {mesh['ns']:.0f} | {run['cgal_ns']:.0f} "
                       f"| {audits([run], ('auto:mesh',))} |")
    for d, n in ((3, 4000), (2, 16000)):
        n = n // 4 if bench.quick else n
        for pace in (1e-5, 0.01):
            r = bench.call("annulus-edits", what="convex", dimension=d, points=n, movers=n // 64, pace=pace,
                           repeat=5 if bench.quick else 15)[0]
            yield (f"| convex position, {d}D, {n}, pace {pace:g} | {r['ratio']:.3f} "
                   f"| {limits(r['ratio'], 1, 0.5, False)} | {r['most expensive']:.2f} | {r['ns']:.0f} "
                   f"| {r['cgal_ns']:.0f} | {'right' if r['audit'] else '**WRONG**'} |")
    yield ""


def interpreter(build):
    """One that can import the build's module and NumPy; None where there is none."""
    environment = {**os.environ, "PYTHONPATH": str(build / "python")}
    for name in ("/usr/bin/python3", "python3"):
        path = shutil.which(name)
        if path and subprocess.run([path, "-c", "import annulus, numpy"], env=environment, capture_output=True,
                                   check=False).returncode == 0:
            return path, environment
    return None


def python(bench):
    """Calm steps in Python with and without reports of changes."""
    yield from ["## Calm steps in Python", ""]
    found = interpreter(bench.build)
    if found is None or bench.program("annulus-python-peer") is None:
        yield from ["Not measured: the build has no Python module, or no `annulus-python-peer` "
                    "(`-DANNULUS_BUILD_PYTHON=ON`, targets `annulus-python` and `annulus-python-peer`).", ""]
        return
    path, environment = found
    with tempfile.TemporaryDirectory() as place:
        file = Path(place) / "overhead.json"
        words = ["--points", 10000, "--steps", 20 if bench.quick else 60, "--repeat", 2 if bench.quick else 5,
                 "--kinds", "rest", "1e-4", "--json", file]
        command = [path, ROOT / "python/bench/overhead", "--peer", bench.program("annulus-python-peer"), *words]
        subprocess.run([str(w) for w in command], env=environment, check=True, stdout=subprocess.DEVNULL)
        lines = [json.loads(line) for line in file.read_text().splitlines()]
    yield from ["10,000 points that rest, or walk by 1e-4 spacings. Sums over the steps of the least times of each; "
                "`python/bench/overhead`.", "",
                "| | with reports / without | must | reached | aim | Python / C++, both with | both without | C++, us "
                "a step |", "|---|---|---|---|---|---|---|---|"]
    for r in lines:
        ratio = r["python"] / r["bare"]
        yield (f"| {r['dimension']}D, {r['kind']} | {ratio:.3f} | {limits(ratio, 1.05, 1, False)} "
               f"| {r['python'] / r['peer']:.2f} | {r['bare'] / r['bare peer']:.2f} | {1e6 * r['peer']:.1f} |")
    yield ""
