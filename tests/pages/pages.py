# SPDX-License-Identifier: GPL-3.0-or-later
"""Every kind of page that the tool writes, one per line. A new line is enough to test a new kind."""

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Kind:
    name: str  # of its directory
    command: str  # its words; DIR is replaced by the directory, MOTION and GRID by files (test_pages.py)
    page: str = "report.html"
    shows: list = field(default_factory=list)  # headings that must be there
    sliders: int = 0  # <input type=range> whose `input` event changes a picture
    sorted_tables: int = 0
    status: int = 0
    links: bool = False  # it leads to other pages


KINDS = [
    Kind("lloyd", "lloyd --points 300 --density x2 --iterations 30", shows=["The triangulation", "Convergence"]),
    Kind("lloyd-window", "lloyd --points 20000 --iterations 1", shows=["The triangulation"]),
    Kind("lloyd-box", "lloyd --points 300 --box 2,0,0.5,1 --iterations 10 --voronoi",
         shows=["The triangulation", "Convergence"]),
    Kind("lloyd-box-3", "lloyd --points 100 --box 1,1,1 --iterations 5", shows=["The triangulation", "Convergence"]),
    Kind("nodt", "nodt --sphere --vertices 300 --iterations 10 --lock 10", shows=["The mesh", "Convergence"]),
    Kind("replay", "replay MOTION --strategy tolerances", shows=["The triangulation", "What a step costs"], sliders=1),
    Kind("compare-replay", "compare --strategies rebuild,auto -- replay MOTION", shows=["Strategies compared"],
         sorted_tables=1),
    Kind("compare", "compare --strategies rebuild,relocate,auto,paper:floating -- lloyd --points 300 --iterations 30",
         shows=["Strategies compared", "Cumulative time"], sorted_tables=1),
    Kind("compare-nodt", "compare --strategies rebuild,tolerances -- nodt --sphere --vertices 200 --iterations 5",
         shows=["Strategies compared", "The triangulation"], sorted_tables=1),
    Kind("degeneracy", "degeneracy GRID", "degeneracy.html", ["Degenerate, exactly and nearly", "Quantiles"]),
    Kind("degeneracy-3", "degeneracy POINTS", "degeneracy.html", ["Distributions", "What arithmetic decides"]),
    Kind("degeneracy-motion", "degeneracy MOTION --every 2", "degeneracy.html"),
    Kind("sweep", "sweep SPEC", "sweep.html", ["What was found", "Distributions", "Which arithmetic decides"],
         sorted_tables=1),
    Kind("reproduce", "reproduce --quick --iterations 4 --only fig5,fig10", "index.html", ["Claims", "Figures", "Runs"],
         links=True),
    Kind("reproduce-figure", "reproduce --quick --iterations 20 --only fig6,fig10,fig11", "figure-11.html",
         ["Claims", "Notes"], links=True),
    Kind("reproduce-speed", "reproduce --quick --iterations 20 --only fig12", "figure-12.html", ["Speed-up"],
         links=True),
    Kind("reproduce-plane", "reproduce --quick --iterations 30 --only fig7", "figure-7.html", ["Cumulated times"],
         links=True),
    Kind("reproduce-unsound", "reproduce --quick --iterations 4 --only fig10", "unsound.html",
         ["Five points", "Every run"], links=True),
    Kind("degeneracy-flat", "degeneracy LINE", "degeneracy.html"),
]
