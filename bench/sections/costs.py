# SPDX-License-Identifier: GPL-3.0-or-later
"""Costs that do not depend on a motion."""

from .measure import limits, reached

# Of a vertex in 3D, with tolerances and without: must and aim.
BYTES, BYTES_WITHOUT = (800, 500), (280, 230)


def costs(bench):
    """Costs of both classes in both dimensions, with tolerances (steps of 1e-5 spacings) and without (1e-3)."""
    points = 20000 if bench.quick else 100000
    yield from [f"## Costs, {points} points", "",
                "Nanoseconds and bytes (malloc's own count) a vertex; the move of one vertex by 0.01 spacings in "
                "nanoseconds, a median of 1,000. `Moving_delaunay` makes CGAL's object when that is requested, "
                "which nothing does here.",
                f"Must and aim are 1.5 and 3 for construction; in 3D {BYTES[0]} and {BYTES[1]} bytes with tolerances, "
                f"{BYTES_WITHOUT[0]} and {BYTES_WITHOUT[1]} without; 8 and 3 microseconds for a move in 3D; 2 and 1.3 "
                "for a step in which all pass.", "",
                "| | tolerances | CGAL's / construction | reached | bytes | CGAL's | reached | a step in which all "
                "pass / reading the arrays | reached | one move | reached |",
                "|---|---|---|---|---|---|---|---|---|---|---|"]
    for r in bench.call("annulus-costs", points):
        keeps = r["spacings"] < 1e-4
        must = (BYTES if keeps else BYTES_WITHOUT)[0] if r["dimension"] == 3 else None
        build = r["cgal_construction_ns"] / r["construction_ns"]
        passing = r["pass_ns"] / r["arrays_ns"]
        yield (f"| `{r['what']}` | {'kept' if keeps else 'not kept'} | {build:.2f} | {reached(build, 1.5)} "
               f"| {r['bytes']:.0f} | {r['cgal_bytes']:.0f} | {reached(r['bytes'], must, False)} "
               f"| {r['pass_ns']:.1f} / {r['arrays_ns']:.1f} = {passing:.1f} | {reached(passing, 2, False)} "
               f"| {r['one_move_ns']:.0f} "
               f"| {reached(r['one_move_ns'], 8000 if r['dimension'] == 3 else None, False)} "
               f"|{'' if r['audit'] else ' **WRONG**'}")
    yield ""


def volumes(bench):
    """Voronoi volumes that a mesh keeps, after steps of one vertex, some, and all."""
    points = 20000 if bench.quick else 100000
    yield from [f"## Voronoi volumes after small steps, {points} points", "",
                "Vertices move a hundredth of a spacing. `Moving_mesh::voronoi_volumes`, which computes what that "
                "concerns, and `voronoi_volumes` of all cells, which are listed beforehand, in turn:",
                "nanoseconds a vertex of the mesh, medians of nine steps, and the median of the ratios of the same "
                "step.", "",
                "| vertices that move | kept, ns | fresh, ns | fresh / kept | same bits |", "|---|---|---|---|---|"]
    for r in bench.call("annulus-costs", points, volumes=True):
        yield (f"| {r['movers']}, {r['dimension']}D | {r['kept_ns']:.1f} | {r['fresh_ns']:.0f} | {r['ratio']:.1f} "
               f"| {'yes' if r['same'] else '**WRONG**'} |")
    points = 4000 if bench.quick else 10000
    yield from ["", f"### After steps of all vertices, 3D, {points} points", "",
                "\"Fresh\" lists the cells and computes all volumes; Voro++ fills its container, a box around the "
                "points, and computes all, beside the step and the volumes that a mesh keeps. Medians "
                "of nine steps.", "",
                "| | step, ns | kept, ns | fresh, ns | fresh / kept | Voro++, ns | Voro++ / (step and kept) | must "
                "| reached | aim | volumes |", "|---|---|---|---|---|---|---|---|---|---|---|"]
    for s, must, aim in ((0.001, 10, 30), (0.03, 3, 5)):
        r = bench.call("annulus-voronoi", points, spacings=s)[0]
        right = r["right"] and r.get("difference", 0.0) < 1e-9
        voro = (f"{r['voro_ns']:.0f} | {r['voro_ratio']:.1f} | {limits(r['voro_ratio'], must, aim)}"
                if "voro_ns" in r else f"not installed | | {must} | | {aim}")
        yield (f"| s = {s:g} | {r['move_ns']:.0f} | {r['kept_ns']:.0f} | {r['fresh_ns']:.0f} | {r['fresh_ratio']:.1f} "
               f"| {voro} | {'agree' if right else '**WRONG**'} |")
    yield ""


def derived(bench):
    """Areas with a gradient, facets, pairs and events, beside the move before them."""
    points = 10000 if bench.quick else 50000
    yield from [f"## What is computed after each step, walk of 0.01 spacings, {points} points", "",
                "Each has a `Moving_mesh` of its own, which makes the same steps. Nanoseconds a vertex and step, "
                "medians of nine, and the median of the ratios to the move in the same step. Events are what a "
                "move with `report_changes` and `edge_changes` take above a move without.", "",
                "| | move, ns | after it, ns | after it / move | must | reached | aim | audit |",
                "|---|---|---|---|---|---|---|---|"]
    for r in bench.call("annulus-derived", points, spacings=0.01):
        must, aim = (3, 1) if r["what"] == "areas with gradient" else (None, None)
        yield (f"| {r['what']}, {r['dimension']}D | {r['move_ns']:.0f} | {r['work_ns']:.0f} | {r['ratio']:.2f} "
               f"| {limits(r['ratio'], must, aim, False)} | {'right' if r['audit'] else '**WRONG**'} |")
    yield ""
