# SPDX-License-Identifier: GPL-3.0-or-later
"""Periodic boxes beside open boundaries."""

from .measure import limits

REBUILD = {10000: (2, 1.3), 100000: (1.6, 1.2)}  # periodic over open, 3D: must and aim
CGAL = (6, 10)                                   # CGAL's periodic triangulation over ours
SIGNS = (1.15, 1.05)
EXPIRED = (1, 0.5)  # percent of the certificates a step, where the box is strained by 1e-5 alike


def torus(bench):
    yield from ["## Periodic boxes", "",
                "`Periodic_mesh` in a cube or square, and `Moving_mesh` of the same uniform points, whose boundaries "
                "are open, in turn; medians. \"Moved\": all points are elsewhere, and both rebuild (the open one by "
                "the strategy `rebuild`). \"Constructed\": both constructors. CGAL's is the insertion of a range into "
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
            for name, open_, ours in (("moved", "open", "periodic"),
                                      ("constructed", "open constructor", "periodic constructor")):
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
    yield from ["", "A box that moves, with 10,000 points that follow it and jitter, by so many spacings a step (`npt` "
                "strained by 1e-5 in all directions alike, `shear` by 1e-4). Certificates that expire in a step, with "
                "those that are computed again because the box has changed too much; nanoseconds a point by "
                "tolerances, by all signs, and by what `auto` chooses.", "",
                "| box | jitter | expired | must | reached | aim | tolerances, ns | signs, ns | auto, ns | right |",
                "|---|---|---|---|---|---|---|---|---|---|"]
    for box, strain, jitter in (("npt", 1e-5, 1e-5), ("npt", 1e-5, 1e-4), ("shear", 1e-4, 1e-5),
                                ("shear", 1e-4, 1e-4)):
        for d in (2, 3):
            r = bench.call("annulus-torus", dimension=d, points=10000, box=box, strain=strain, spacings=jitter,
                           repeat=31 if bench.quick else 201)[0]
            expired = 100 * r["tolerances"]["expired"]
            must, aim = EXPIRED if box == "npt" else (None, None)
            yield (f"| {box}, {strain:g} a step, {d}D | {jitter:g} | {expired:.2f} % "
                   f"| {limits(expired, must, aim, False)} | {r['tolerances']['ns']:.0f} | {r['signs']['ns']:.0f} "
                   f"| {r['auto']['ns']:.0f} | {'yes' if r['right'] else '**WRONG**'} |")
    yield ""
