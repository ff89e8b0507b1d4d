# SPDX-License-Identifier: GPL-3.0-or-later
"""Periodic boxes beside open meshes: the tables of docs/periodic.md."""


def number(value):
    """Two digits."""
    return f"{value:.0f}" if value >= 100 else f"{value:#.2g}".rstrip(".")


def periodic(bench):
    """Moves, builds, insertions and removals of uniform random points in a square or cube, and what is computed from
    the cells."""
    points, times = (2000, 3) if bench.quick else (10000, 21)
    lines = bench.call("annulus-periodic", points, times=times)

    def of(what, dimension):
        return [r for r in lines if r["what"] == what and r["dimension"] == dimension]

    wrong = any(not r.get("audit", True) for r in lines)
    yield from [f"## Periodic boxes, {points} points", "",
                f"Microseconds a point, medians of {times}, uniform random points in a square or cube. Moves: all "
                "points by up to `s` mean spacings along each axis; the open mesh has the strategy `auto`, too, the "
                f"ratio is the median of those of steps.{' **WRONG**' if wrong else ''}", "",
                "| `s` | 2D: periodic | open | ratio | periodic build | rebuilt "
                "| 3D: periodic | open | ratio | periodic build | rebuilt |",
                "|---|---|---|---|---|---|---|---|---|---|---|"]
    for two, three in zip(of("move", 2), of("move", 3)):
        cells = [f"{two['spacings']:g}"]
        for r in (two, three):
            cells += [number(r["periodic_us"]), number(r["open_us"]), number(r["ratio"]) if r["spacings"] else "",
                      number(r["build_us"]), f"{100 * r['rebuilt']:.0f} %"]
        yield f"| {' | '.join(cells)} |"
    yield from ["", "Builds, beside an open mesh with the strategy `rebuild`:", "",
                "| points | open, rebuild | periodic | ratio | copies a point |", "|---|---|---|---|---|"]
    for d in (2, 3):
        for r in of("build", d):
            yield (f"| {r['points']:,} in {d}D | {number(r['open_us'])} | {number(r['periodic_us'])} | "
                   f"{number(r['ratio'])} | {r['copies']:.2f} |")
    yield from ["", "Insertions and removals, microseconds each:", "", "| points | `insert(p)` | `remove(i)` |",
                "|---|---|---|"]
    for d in (2, 3):
        for r in of("edit", d):
            yield f"| {r['points']:,} in {d}D | {number(r['insert_us'])} | {number(r['remove_us'])} |"
    yield from ["", "What is computed from the cells, microseconds a point:", "",
                "| | neighbours | Voronoi volumes | their gradient | audit |", "|---|---|---|---|---|"]
    for d in (2, 3):
        for r in of("measures", d):
            yield (f"| {d}D | {number(r['neighbours_us'])} | {number(r['volumes_us'])} | {number(r['gradient_us'])} | "
                   f"{number(r['audit_us'])} |")
    yield ""
