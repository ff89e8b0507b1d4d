# SPDX-License-Identifier: GPL-3.0-or-later
"""Costs that do not depend on a motion."""

from .measure import reached

MUST = {"Moving_delaunay_3": 800, "Moving_mesh<3>": 900}


def costs(bench):
    """Costs of both classes in both dimensions, with tolerances (steps of 1e-5 spacings) and without (1e-3)."""
    points = 20000 if bench.quick else 100000
    yield from [f"## Costs, {points} points", "",
                "Nanoseconds and bytes (malloc's own count) a vertex; the move of one vertex by 0.01 spacings in "
                "nanoseconds, a median of 1,000. \"Above CGAL's\" is of `Moving_delaunay`, whose",
                "triangulation is CGAL's; of a mesh all there is counts. In space must and aim are 1.5 and 1.1 for "
                "construction, 800 and 500 bytes (900 and 500 of a",
                "mesh), 10 and 3 microseconds for a move; in both 2 and 1.3 for a step in which all pass.", "",
                "| | tolerances | construction / CGAL's | reached | bytes | reached | a step in which all pass / "
                "reading the arrays | reached | one move | reached |", "|---|---|---|---|---|---|---|---|---|---|"]
    for r in bench.call("annulus-costs", points):
        mesh = r["what"].startswith("Moving_mesh")
        space = r["dimension"] == 3
        size = r["bytes"] if mesh else r["bytes"] - r["cgal_bytes"]
        text = f"{size:.0f}" if mesh else f"{size:.0f} above CGAL's {r['cgal_bytes']:.0f}"
        build = r["construction_ns"] / r["cgal_construction_ns"]
        passing = r["pass_ns"] / r["arrays_ns"]
        yield (f"| `{r['what']}` | {'kept' if r['spacings'] < 1e-4 else 'not kept'} | {build:.2f} | "
               f"{reached(build, 1.5 if space else None, False)} | {text} "
               f"| {reached(size, MUST.get(r['what']), False)} | {r['pass_ns']:.1f} / {r['arrays_ns']:.1f} = "
               f"{passing:.1f} | {reached(passing, 2, False)} "
               f"| {r['one_move_ns']:.0f} | {reached(r['one_move_ns'], 10000 if space else None, False)} "
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
    yield ""


def derived(bench):
    """Areas with a gradient, facets, pairs and events, beside the move before them."""
    points = 10000 if bench.quick else 50000
    yield from [f"## What is computed after each step, walk of 0.01 spacings, {points} points", "",
                "Each has a `Moving_mesh` of its own, which makes the same steps. Nanoseconds a vertex and step, "
                "medians of nine, and the median of the ratios to the move in the same step. Events are what a "
                "move with `report_changes` and `edge_changes` take above a move without.", "",
                "| | move, ns | after it, ns | after it / move | must | reached | audit |",
                "|---|---|---|---|---|---|---|"]
    for r in bench.call("annulus-derived", points, spacings=0.01):
        must = 3 if r["what"] == "areas with gradient" else None
        yield (f"| {r['what']}, {r['dimension']}D | {r['move_ns']:.0f} | {r['work_ns']:.0f} | {r['ratio']:.2f} "
               f"| {must or ''} | {reached(r['ratio'], must, False)} | {'right' if r['audit'] else '**WRONG**'} |")
    yield ""
