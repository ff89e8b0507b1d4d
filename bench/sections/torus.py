# SPDX-License-Identifier: GPL-3.0-or-later
"""Periodic boxes beside open boundaries."""

from .measure import limits

REBUILD = {10000: (2, 1.3), 100000: (1.6, 1.2)}  # periodic over open, 3D: must and aim
CGAL = (6, 10)                                   # CGAL's periodic triangulation over ours
SIGNS = (1.15, 1.05)


def torus(bench):
    yield from ["## Periodic boxes", "",
                "`Periodic_mesh` in a cube or square, and `Moving_mesh` of the same uniform points, whose boundaries "
                "are open, in turn; medians. \"Moved\": all points are elsewhere, and both rebuild (the open one by "
                "the strategy `rebuild`). \"Anew\": both constructors. CGAL's is the insertion of a range into "
                "`Periodic_3_Delaunay_triangulation_3`, for many points.", "",
                "| | periodic / open | of repetitions | must | reached | aim | open, ns | periodic, ns "
                "| CGAL Periodic_3 / ours | must | reached | aim | right |",
                "|---|---|---|---|---|---|---|---|---|---|---|---|---|"]
    for d in (3, 2):
        for n in (10000,) if bench.quick else (10000, 100000):
            must, aim = REBUILD[n] if d == 3 else (None, None)
            options = {"cgal": True} if d == 3 else {}
            r = bench.call("annulus-torus", dimension=d, points=n, repeat=3 if bench.quick or n > 10000 else 9,
                           **options)[0]
            for name, open_, ours in (("moved", "open", "periodic"), ("anew", "open anew", "periodic anew")):
                ratio = r[ours]["ratio"] / r[open_]["ratio"]
                spread = f"{r[ours]['ratio_low']:.2f} to {r[ours]['ratio_high']:.2f}" if open_ == "open" else ""
                cgal = r["cgal"]["ns"] / r[ours]["ns"] if "cgal" in r else None
                beside = "| | | " if cgal is None else f"{cgal:.1f} | {limits(cgal, *CGAL)}"
                yield (f"| rebuild, {name}, {d}D, {n} | {ratio:.2f} | {spread} | {limits(ratio, must, aim, False)} "
                       f"| {r[open_]['ns']:.0f} | {r[ours]['ns']:.0f} | {beside} "
                       f"| {'yes' if r['right'] else '**WRONG**'} |")
    for d in (3, 2):
        for s in (0.001, 0.01):
            r = bench.call("annulus-torus", dimension=d, points=10000, spacings=s, repeat=9 if bench.quick else 31)[0]
            ratio = r["periodic"]["ratio"]
            yield (f"| step of signs, {d}D, s = {s:g} | {ratio:.2f} | {r['periodic']['ratio_low']:.2f} to "
                   f"{r['periodic']['ratio_high']:.2f} | {limits(ratio, *SIGNS, False)} | {r['open']['ns']:.0f} "
                   f"| {r['periodic']['ns']:.0f} | | | | | {'yes' if r['right'] else '**WRONG**'} |")
    yield from ["| NPT, strain 1e-5 a step: expired certificates | no tolerances on the torus | | 1 % | **no** | 0.5 % "
                "| | | | | | | |", ""]
