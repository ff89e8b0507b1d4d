# SPDX-License-Identifier: GPL-3.0-or-later
"""Motions that were not made for a benchmark: simulations, and recordings from files."""

from pathlib import Path

from .measure import audits, in_order, limits, middle

HEAD = ["| | n | spacings a step | came or went a step | rebuild / auto | of runs | `Moving_mesh` | with view | must "
        "| reached | aim | median of steps | auto, ns | rebuild, ns "
        "| most expensive step, in rebuilds | rebuilt | audit |",
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"]
SIMULATED, RECORDED = (0.95, 1.1), (2, 3)  # must and aim


def row(name, runs, must, aim):
    """Steps are not alike here, so the ratio is that of the sums."""
    runs = in_order(runs, "whole")
    one = middle(runs)
    auto = one["auto"]
    return (f"| {name} | {one['points']} | {one['displacement']:.3g} | "
            f"{one['came_and_went'] / max(one['steps'], 1):.1f} | {auto['whole']:.2f} "
            f"| {runs[0]['auto']['whole']:.2f} to {runs[-1]['auto']['whole']:.2f} "
            f"| {one['auto:mesh']['whole']:.2f} | {one['auto:view']['whole']:.2f} | {limits(auto['whole'], must, aim)} "
            f"| {auto['ratio']:.2f} | {auto['ns']:.0f} | {one['cgal_ns']:.0f} | "
            f"{max(r['auto']['most expensive'] for r in runs):.2f} "
            f"| {100 * auto['rebuilt']:.0f} % | {audits(runs)} |")


def simulations(bench):
    steps = 8 if bench.quick else 48
    yield from ["## Simulated motions", "",
                "A Lennard-Jones liquid in a container (one step of integration is 0.005 of its units of time), and "
                "two streams of people in a corridor (one step",
                "is 0.02 s), who leave at its ends while others arrive: `bench/motions/dynamics.h`, `crowd.h`. "
                "Time steps are so many steps of integration apart. Ratios are of sums.", "", *HEAD]
    for every in (1, 10, 100):
        yield row(f"molecular dynamics, each {every}", bench_runs(bench, "dynamics", 3, 2000, every, steps), *SIMULATED)
    for every in (1, 5, 20):
        yield row(f"crowd, each {every}", bench_runs(bench, "crowd", 2, 1000, every, steps), *SIMULATED)
    yield ""


def bench_runs(bench, motion, d, points, every, steps):
    return bench.motion(motion=motion, dimension=d, points=points, every=every, steps=steps, warm=12)


def recorded(bench, names):
    """Sections of files that `annulus replay` reads."""
    yield from ["## Recorded motions", ""]
    files = []
    for name in map(Path, names):
        files += (sorted(f for f in name.iterdir() if f.name.endswith((".xyz", ".csv", ".xyz.gz", ".csv.gz")))
                  if name.is_dir() else [name])
    if not files:
        yield from ["None was given: `--recordings FILE_OR_DIRECTORY ...`, or their names in `ANNULUS_RECORDINGS` "
                    "(none is kept here: they have other licences).", ""]
        return
    steps = 40 if bench.quick else 400
    yield from [f"At most {steps} time steps of each, around its fullest frame. A spacing is that of this frame in its "
                "box. Ratios are of sums.", "", *HEAD]
    for file in files:
        yield row(file.name, [bench.call("annulus-recordings", file, steps=steps)[0] for _ in range(bench.repeat)],
                  *RECORDED)
    yield ""
