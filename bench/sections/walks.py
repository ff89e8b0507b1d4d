# SPDX-License-Identifier: GPL-3.0-or-later
"""Random walks, families of points, other motions, the dearest step, numbers of points, two threads."""

import statistics

from .measure import HEAD, audits, limits, number, reached, row

MUST = {3: {0.001: 15, 0.01: 10, 0.03: 5, 0.1: 2.8, 0.3: 2.8, 1: 2.8},
        2: {0.001: 20, 0.01: 8, 0.03: 6, 0.1: 4, 0.3: 4, 1: 4}}
AIM = {3: {0.001: 25, 0.01: 16, 0.03: 7, 0.1: 4, 0.3: 4, 1: 4},
       2: {0.001: 30, 0.01: 14, 0.03: 8, 0.1: 5.5, 0.3: 5.5, 1: 5.5}}
FAMILIES_MUST = {3: {"sphere": 4, "slab": 3, "clusters": 3, "faces": 2.5, "lattice": 3.3, "ball": 3,
                     "jittered": 3, "integers": 1.8},
                 2: {"sphere": 1.8, "slab": 4, "clusters": 4, "lattice": 2.5, "ball": 4, "jittered": 2.5,
                     "integers": 2.5}}
FAMILIES_AIM = {3: {"sphere": 6, "slab": 4.5, "clusters": 3.8, "faces": 3.5, "lattice": 4.5, "ball": 4.5,
                    "jittered": 4.5, "integers": 2.5},
                2: {"sphere": 2.4, "slab": 5.5, "clusters": 5.5, "lattice": 3.5, "ball": 5.5, "jittered": 3.5,
                    "integers": 3.5}}


def steps(bench):
    return 8 if bench.quick else 24


def walks(bench):
    for d, n in ((3, 8000), (2, 10000)):
        yield from [f"## Random walk, uniform points, {d}D, {n} points", "", *HEAD]
        for s in (1e-6, 1e-5, 1e-4, 1e-3, 0.003, 0.01, 0.03, 0.1, 0.3, 1):
            yield row(f"s = {s:g}", MUST[d].get(s, 0.95), AIM[d].get(s, 1.0),
                      bench.motion(dimension=d, points=n, spacings=s, steps=steps(bench), warm=12))
        yield ""


def families(bench):
    for d, n in ((3, 4000), (2, 10000)):
        yield from [f"## Other families, walk, {d}D, {n} points (sphere in space: 1,000)", "", *HEAD]
        for family in ("sphere", "slab", "clusters", "faces", "lattice", "ball", "jittered", "integers"):
            for s in (1e-3, 0.01):
                few = (family, d) == ("sphere", 3)
                yield row(f"{family}, s = {s:g}", FAMILIES_MUST[d].get(family, 0.9), FAMILIES_AIM[d].get(family, 1.0),
                          bench.motion(dimension=d, family=family, points=1000 if few else n, spacings=s,
                                       steps=steps(bench), warm=8))
        yield ""


def motions(bench):
    yield from ["## Other motions, uniform points, 3D, 8000 points", "", *HEAD]
    for motion in ("drift", "shear", "few", "burst"):
        for s in (1e-3, 0.1):
            yield row(f"{motion}, s = {s:g}", 0.95, 1.0,
                      bench.motion(dimension=3, motion=motion, points=8000, spacings=s, steps=steps(bench), warm=12))
    yield ""


# Those whose steps cost most in PROFILES.md: dimension, family, motion, spacings.
DEAREST = ((3, "uniform", "walk", 0.03), (3, "ball", "walk", 0.03), (3, "slab", "walk", 0.003),
           (3, "slab", "walk", 0.01), (3, "slab", "burst", 0.008), (3, "clusters", "walk", 0.003),
           (3, "clusters", "walk", 0.01), (3, "clusters", "walk", 0.03), (2, "uniform", "walk", 0.1),
           (2, "slab", "walk", 0.05), (2, "clusters", "walk", 0.2), (2, "lattice", "shear", 0.01))


def least(runs, strategy):
    """The least time of each step, of runs that take the same steps: a pause of the machine hits one of them."""
    return [min(same) for same in zip(*(r[strategy]["each"] for r in runs))]


def dearest(bench):
    """The dearest single step, in rebuilds of ours."""
    yield from ["## The dearest step, 3,000 points in 3D, 5,000 in 2D", "",
                "`Moving_mesh` with `auto`, all steps of all runs, in units of the median rebuild of `Moving_mesh` "
                "with the strategy `rebuild`; each step, and each rebuild, by the least of five runs of the same "
                "steps.", "",
                "| | dearest, in rebuilds | must | reached | aim | median step, in rebuilds | audit |",
                "|---|---|---|---|---|---|---|"]
    for d, family, motion, s in DEAREST:
        most, usual, runs = 0.0, [], []
        for seed in range(1, bench.repeat + 1):
            same = [bench.call("annulus-motions", dimension=d, family=family, motion=motion,
                               points=3000 if d == 3 else 5000, spacings=s, steps=8 if bench.quick else 40, warm=0,
                               seed=seed, strategies="auto:mesh,rebuild:mesh", each_step=True)[0] for _ in range(5)]
            steps, rebuild = least(same, "auto:mesh"), statistics.median(least(same, "rebuild:mesh"))
            most = max(most, max(steps) / rebuild)
            usual.append(statistics.median(steps) / rebuild)
            runs += same
        yield (f"| {family}, {motion}, {d}D, s = {s:g} | {most:.2f} | {limits(most, 1.5, 1.2, False)} "
               f"| {statistics.median(usual):.2f} | {audits(runs, ('auto:mesh', 'rebuild:mesh'))} |")
    yield ""


def sizes(bench):
    if bench.quick:
        return
    yield from ["## Number of points, walk of 0.003 spacings, 3D", "", *HEAD]
    ns = {}
    for n in (1000, 8000, 64000, 512000):
        runs = bench.motion(dimension=3, points=n, spacings=0.003, steps=8, warm=10)
        ns[n] = min(r["auto"]["ns"] for r in runs)
        yield row(f"{n} points", 3 if n == 512000 else None, 5 if n == 512000 else None, runs)
    grows = ns[512000] / ns[8000]
    yield from ["",
                f"A vertex and step of 512,000 points costs {grows:.2f} times what one of 8,000 does: must 1.5 at "
                "most, reached: "
                f"{reached(grows, 1.5, False)}, aim 1.2.", ""]


def threads(bench):
    n = 20000 if bench.quick else 1000000
    cgal = {t: bench.call("annulus-parallel-cgal", points=n, threads=t)[0]["ns"] for t in (1, 2)}
    yield from ["## Two threads", "",
                "By the clock. CGAL's parallel insertion is the least of three; it is made for many points.", "",
                "| | one, ns | two, ns | one / two | must | reached | aim |", "|---|---|---|---|---|---|---|"]
    for d, s, must, aim in ((3, 1e-3, 1.5, 1.8), (2, 3e-3, None, None)):
        one, two = (
            min(r["auto"]["ns"] for r in bench.motion(repeat=1, dimension=d, points=n, spacings=s, steps=8, warm=4,
                                                      threads=t))
            for t in (1, 2))
        yield (f"| walk, {d}D, s = {s:g}, {n} points | {one:.0f} | {two:.0f} | {one / two:.2f} | {number(must)} "
               f"| {reached(one / two, must)} | {number(aim)} |")
        if d == 3:
            ours = {1: one, 2: two}
    for r in bench.call("annulus-costs", n, threads=2):
        yield (f"| construction, `{r['what']}`, {n} points | {r['one_ns']:.0f} | {r['ns']:.0f} | {r['ratio']:.2f} | | "
               "| |")
    half = n // 2
    for r in bench.call("annulus-costs", half, threads=2, rebuilds=True):
        yield (f"| rebuild, `Moving_mesh<3>`, {half} points | {r['one_ns']:.0f} | {r['ns']:.0f} | {r['ratio']:.2f} "
               f"| {limits(r['ratio'], 1.5, 1.8)} |")
    yield (f"| CGAL's parallel insertion, 3D, {n} points | {cgal[1]:.0f} | {cgal[2]:.0f} | {cgal[1] / cgal[2]:.2f} | | "
           "| |")
    yield from ["",
                f"In space CGAL's parallel insertion takes {cgal[2] / ours[2]:.1f} times as long as the step, both "
                f"with two threads, and {cgal[1] / ours[1]:.1f} times with one.", ""]
