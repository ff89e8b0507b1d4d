# SPDX-License-Identifier: GPL-3.0-or-later
"""The tool's own motions, which the paper measured: Lloyd iterations, natural ODT."""

import subprocess

from .measure import ROOT, reached

# Scene, its name in the tool, vertices, the required value of rebuild / auto and the desired one.
MESHES = (("sphere", ["--sphere"], 13000, 40, 60), ("bunny", ["--surface", "bunny00.off"], 13000, 14, 30),
          ("man", ["--surface", "man.off", "--allow-crossing"], 8000, 14, 30),
          ("liver", ["--surface", "liver.inr.gz"], 10000, 14, 30))
HEAD = ["| | vertices | spacings a step | CGAL's / auto | must | reached | aim | `rebuild` / auto | CGAL's, s | auto, "
        "s | motion, s | motion / CGAL's | must | reached | aim "
        "| certified / plain double | must | reached | audits |",
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"]
WHAT = ["Seconds are of all iterations. \"CGAL's\" is its insertion of a range, timed at each 20th time step; "
        "`rebuild` is the strategy, which inserts in the order of its last sort.",
        "\"Motion\" is the time to compute where vertices go; \"certified / plain double\" is strategy `paper` over "
        "`paper:floating`."]


def row(name, run, must, aim, motion_must, motion_aim):
    """One run of annulus-relaxations as a row."""
    seconds = {s: run[s]["seconds"] for s in run if isinstance(run[s], dict)}
    ratio = seconds["cgal"] / seconds["auto"]
    motion = run["motion"] / seconds["cgal"]
    certified = round(seconds["paper"] / seconds["paper:floating"], 2)
    right = run["agree"] and all(run[s]["audit"] for s in seconds if s != "cgal")
    return (f"| {name} | {run['points']} | {run['displacement']:.2g} | {ratio:.1f} | {must} | {reached(ratio, must)} | "
            f"{aim} | {seconds['rebuild'] / seconds['auto']:.1f} "
            f"| {seconds['cgal']:.2f} | {seconds['auto']:.3f} | {run['motion']:.2f} | {motion:.2f} | {motion_must} | "
            f"{reached(motion, motion_must, False)} | {motion_aim} "
            f"| {certified:.2f} | 1 | {reached(certified, 1.0, False)} | {'right' if right else '**WRONG**'} |")


def lloyd(bench):
    iterations = 100 if bench.quick else 1000
    yield from [f"## Lloyd, 10,000 points, {iterations} iterations", "", *WHAT, "", *HEAD]
    for density in ("one", "x2+y2", "x2", "sin2"):
        run = bench.call("annulus-relaxations", "lloyd", "--points", 10000, "--density", density, "--iterations",
                         iterations, strategies="cgal@20,rebuild,auto,tolerances,paper,paper:floating")[0]
        yield row(density, run, 25, 50, 0.3, 0.15)
    yield ""


def nodt(bench):
    """Both tables from one run for each mesh."""
    iterations = 40 if bench.quick else 1000
    meshes = ROOT / "build/meshes"
    subprocess.run([ROOT / "tools/meshes", meshes], check=True)
    yield from [f"## Natural ODT, {iterations} iterations", "", *WHAT, "", *HEAD]
    single = []
    for name, words, vertices, must, aim in MESHES[:2] if bench.quick else MESHES:
        words = [meshes / w if "." in w else w for w in words]
        run = bench.call("annulus-relaxations", "nodt", *words, "--vertices", 1500 if bench.quick else vertices,
                         "--iterations", iterations,
                         strategies="cgal@20,rebuild@4,auto,tolerances,paper,paper:floating,tolerances-each,"
                                    "relocate@20")[0]
        yield row(name, run, must, aim, 0.5, 0.2)
        each = run["tolerances-each"]["seconds"]
        ratios = [run[s]["seconds"] / each for s in ("cgal", "rebuild", "relocate")]
        single.append(f"| {name} | {ratios[0]:.1f} | 6 | {reached(ratios[0], 6)} | 10 | {ratios[1]:.1f} | "
                      f"{ratios[2]:.0f} | 40 | {reached(ratios[2], 40)} | 80 "
                      f"| {run['tolerances-each']['ns']:.0f} | {run['relocate']['ns']:.0f} | "
                      f"{'right' if run['tolerances-each']['audit'] else '**WRONG**'} |")
    yield from ["", "### One vertex at a time", "",
                "The same motion. `relocate` takes so long that it follows each 20th time step only: its vertices go "
                "twenty times as far at once, which costs it little.", "Nanoseconds are a vertex and step.", "",
                "| | CGAL's / tolerances-each | must | reached | aim | `rebuild` / tolerances-each "
                "| relocate / tolerances-each | must | reached | aim | tolerances-each, ns | relocate, ns | audit |",
                "|---|---|---|---|---|---|---|---|---|---|---|---|---|", *single, ""]
