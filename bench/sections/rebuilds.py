# SPDX-License-Identifier: GPL-3.0-or-later
"""Rebuilds and first constructions beside CGAL, and beside HXT and geogram where the build has them (bench/peers)."""

from .measure import limits

# Families by dimension: must and aim of CGAL's time over that of a warm rebuild.
LIMITS = {3: {"uniform": (3, 4.5), "ball": (3, 4.5), "slab": (3, 4.5), "jittered": (3, 4.5), "clusters": (3, 3.8),
              "faces": (2.5, 3.5), "sphere": (4, 6), "lattice": (3.3, 4.5), "integers": (1.8, 2.5)},
          2: {"uniform": (4, 5.5), "sphere": (1.8, 2.4), "lattice": (2.5, 3.5), "integers": (2.5, 3.5)}}
NAMES = {"sphere": {3: "sphere of 1,000", 2: "circle of 1,000"}, "jittered": {3: "jittered lattice"},
         "lattice": {3: "ulp lattice", 2: "ulp lattice"}, "integers": {3: "integer lattice", 2: "integer lattice"},
         "faces": {3: "cube faces"}}
LARGE = (2.7, 3.7)   # 1,000,000 points in 3D
FIRST = (1.5, 3)     # constructions in memory that the process has not touched
HXT = (1.3, 1.9)     # HXT's time over that of a rebuild, which `auto` makes from 0.1 spacings a step on
PEAK = (400, 300)    # bytes a point while building, 3D
OTHERS = {"hxt": "HXT", "hxt-reordering": "HXT, reordering", "geogram": "geogram"}


def name_of(family, d, points):
    return f"{NAMES.get(family, {}).get(d, family)}, {d}D, {points}"


def others(r):
    """HXT and geogram: their time over ours; empty where the build has neither."""
    return "; ".join(f"{title} {r[key]['ratio']:.2f}" for key, title in OTHERS.items() if "ratio" in r.get(key, {}))


def rebuilds(bench):
    """Every row of warm rebuilds, of first constructions, and of memory while building."""
    n = 2000 if bench.quick else 10000
    repeat = 3 if bench.quick else 9
    rows = []
    for d, families in LIMITS.items():
        for family, limit in families.items():
            points = 1000 if family == "sphere" else n
            words = {"dimension": d, "points": points, "families": family, "orders": "random", "repeat": repeat}
            rows.append((name_of(family, d, points), limit, bench.call("annulus-peers", first=0, **words)[0]))
    large = 20000 if bench.quick else 1000000
    first = {}
    for d in (3, 2):
        first[d] = bench.call("annulus-peers", dimension=d, points=large // 10, families="uniform", orders="random",
                              repeat=1, first=repeat)[0]
    huge = bench.call("annulus-peers", points=large, families="uniform", orders="random",
                      repeat=1 if bench.quick else 2, first=0)[0]
    rows.insert(len(LIMITS[3]), (name_of("uniform", 3, large), LARGE, huge))
    yield from ["## Rebuilds beside CGAL", "",
                "`Moving_mesh` with the strategy `rebuild`, whose arrays are kept, and CGAL's insertion of a range, in "
                "turn, of the same points in random order, other points in each repetition; medians, with 10 % and 90 "
                "%. HXT and geogram are there where the build has them: `bench/peers`.", "",
                "| | CGAL / ours | of repetitions | must | reached | aim | ours, ns | CGAL, ns | others / ours |",
                "|---|---|---|---|---|---|---|---|---|"]
    for name, limit, r in rows:
        cgal = r["cgal"]
        yield (f"| {name} | {cgal['ratio']:.2f} | {cgal['ratio_low']:.2f} to {cgal['ratio_high']:.2f} "
               f"| {limits(cgal['ratio'], *limit)} | {r['annulus']['ns']:.0f} | {cgal['ns']:.0f} | {others(r)} |")
    uniform = rows[0][2]
    if "ratio" in uniform.get("hxt", {}):
        value = uniform["hxt"]["ratio"]
        yield f"| HXT / `auto` from s = .1 on, 3D | {value:.2f} | | {limits(value, *HXT)} | | | |"
    else:
        yield f"| HXT / `auto` from s = .1 on, 3D | not in this build | | {HXT[0]} | | {HXT[1]} | | | |"
    yield from ["", "### First construction, uniform points, memory that is new to the process", "",
                "Each in a process of its own, in turn; peak memory is by how much that process grows.", "",
                "| | CGAL / ours | must | reached | aim | ours, ns | CGAL, ns | peak, bytes a point | must | reached "
                "| aim | CGAL's peak |", "|---|---|---|---|---|---|---|---|---|---|---|---|"]
    for d, r in first.items():
        ours, cgal = r["annulus"], r["cgal"]
        peak = PEAK if d == 3 else (None, None)
        yield (f"| {d}D, {r['points']} | {cgal['first_ratio']:.2f} | {limits(cgal['first_ratio'], *FIRST)} "
               f"| {ours['first_ns']:.0f} | {cgal['first_ns']:.0f} | {ours['bytes']:.0f} "
               f"| {limits(ours['bytes'], *peak, False)} | {cgal['bytes']:.0f} |")
    yield ""
