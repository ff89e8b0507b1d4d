# SPDX-License-Identifier: GPL-3.0-or-later
"""Every kind of page that the tool writes, one per line. A new line is enough to test a new kind."""

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Kind:
    name: str  # of its directory
    command: str  # its words; DIR is replaced by the directory, MOTION and GRID by files (test_pages.py)
    page: str = "report.html"
    shows: list = field(default_factory=list)  # headings that must be there
    says: list = field(default_factory=list)  # parts of what it says was found, at its head
    sliders: int = 0  # <input type=range> whose `input` event changes a picture
    sorted_tables: int = 0
    status: int = 0
    links: bool = False  # it leads to other pages


KINDS = [
    Kind("lloyd", "lloyd --points 300 --density x2 --iterations 30",
         shows=["Voronoi cells by number of neighbours", "How regular it became", "The triangulation", "Convergence"],
         says=["six neighbours at the end", "least angle of a triangle rose", "the energy is",
               "In 30 iterations points moved"]),
    Kind("lloyd-start", "lloyd --points 300 --iterations 0", shows=["The triangulation"],
         says=["There was no iteration.", "inner vertices have six neighbours ("]),
    Kind("lloyd-once", "lloyd --points 300 --iterations 1", shows=["Convergence", "What an iteration costs"],
         says=["In 1 iteration points moved by"]),
    Kind("lloyd-window", "lloyd --points 20000 --iterations 1", shows=["The triangulation"],
         says=["six neighbours at the end"]),
    Kind("lloyd-box", "lloyd --points 300 --box 2,0,0.5,1 --iterations 10 --voronoi",
         shows=["Voronoi cells by number of neighbours", "The triangulation", "Convergence"],
         says=["of the 300 vertices have six neighbours", "the energy is"]),
    Kind("lloyd-box-3", "lloyd --points 100 --box 1,1,1 --iterations 5",
         shows=["How regular it became", "The triangulation", "Convergence"],
         says=["The volumes of the Voronoi cells differ from their mean", "In 5 iterations points moved by"]),
    Kind("stippling", "lloyd --points 400 --density PICTURE --iterations 5", shows=["The picture and its dots"],
         says=["six neighbours"]),
    Kind("nodt", "nodt --sphere --vertices 300 --iterations 10 --lock 10",
         shows=["The mesh, cut open", "The mesh", "Convergence"],
         says=["The least dihedral angle of the mesh", "the number of slivers"]),
    Kind("nodt-finish", "nodt --sphere --vertices 200 --iterations 3 --finish", shows=["The mesh"],
         says=["degrees at the start, ", " after 3 iterations, ", " after the finish. The number of slivers is"]),
    Kind("replay", "replay MOTION --strategy tolerances",
         shows=["Voronoi cells by number of neighbours", "The triangulation", "What a frame costs"], sliders=1,
         says=["inner vertices have six neighbours", "In the 24 frames after the first, points moved by"]),
    # Which diagonal of a square is an edge does not matter: a facet that is exactly empty makes no neighbours.
    Kind("replay-lattice", "replay LATTICE", shows=["Voronoi cells by number of neighbours"], sliders=1,
         says=["All 16 inner vertices have four or fewer neighbours at the end (100 % at the start)"]),
    Kind("replay-box", "replay MOTION --box 3,2", shows=["Over time", "The triangulation"], sliders=1,
         says=["vertices have six neighbours", "In the 24 frames after the first, points moved by"]),
    Kind("replay-clip", "replay MOTION --clip 0.2,0.2,0.8,0.8 --voronoi", sliders=1,
         shows=["Voronoi cells by number of neighbours", "Voronoi cells over time"], says=["inner vertices"]),
    Kind("compare-once", "compare --strategies rebuild,tolerances,paper:floating -- lloyd --points 300 --iterations 1",
         shows=["Strategies compared"], sorted_tables=1),
    Kind("compare-replay", "compare --strategies rebuild,auto -- replay MOTION", shows=["Strategies compared"],
         sorted_tables=1, says=["2 strategies", "of processor time"]),
    Kind("compare", "compare --strategies rebuild,relocate,auto,paper:floating -- lloyd --points 300 --iterations 30",
         shows=["Strategies compared", "Cumulative time"], sorted_tables=1),
    Kind("compare-nodt", "compare --strategies rebuild,tolerances -- nodt --sphere --vertices 200 --iterations 5",
         shows=["Strategies compared", "The mesh, cut open"], sorted_tables=1),
    Kind("degeneracy", "degeneracy GRID", "degeneracy.html", ["Degenerate, exactly and nearly", "Quantiles"],
         says=["121 of the 341 bi-cells are exactly degenerate"]),
    Kind("degeneracy-3", "degeneracy POINTS", "degeneracy.html", ["Distributions", "What arithmetic decides"],
         says=["None of the", "the narrowest annulus is"]),
    Kind("degeneracy-motion", "degeneracy MOTION --every 2", "degeneracy.html",
         says=["None of the", "The median certified tolerance"]),
    Kind("sweep", "sweep SPEC", "sweep.html",
         ["What was found", "Distributions in 2D", "Distributions in 3D", "Which arithmetic decides in 3D"],
         sorted_tables=1, says=["In 2D none of 10,371 bi-cells is exactly degenerate", "In 3D none of", "The paper's"]),
    Kind("sweep-boxes", "sweep BOXES", "sweep.html",
         ["What was found", "Distributions in periodic boxes in 2D",
          "Which arithmetic decides in periodic boxes in 3D"],
         sorted_tables=1, says=["In periodic boxes in 2D none of", "In periodic boxes in 3D none of", "The paper's"]),
    Kind("reproduce", "reproduce --quick --iterations 4 --only fig5,fig10", "index.html", ["Claims", "Figures", "Runs"],
         links=True, says=["claims of the paper"]),
    Kind("reproduce-figure", "reproduce --quick --iterations 20 --only fig6,fig10,fig11", "figure-11.html",
         ["Claims", "Notes"], links=True, says=["Here: ", "claims of the paper on this page"]),
    Kind("reproduce-speed", "reproduce --quick --iterations 20 --only fig12", "figure-12.html", ["Speed-up"],
         links=True),
    Kind("reproduce-plane", "reproduce --quick --iterations 30 --only fig7", "figure-7.html", ["Cumulated times"],
         links=True, says=["The paper: Filtering Lloyd iterations is up to"]),
    Kind("reproduce-unsound", "reproduce --quick --iterations 4 --only fig10", "unsound.html",
         ["Five points", "Every run"], links=True, says=["an adversary made", "The claim is wrong."]),
    Kind("degeneracy-flat", "degeneracy LINE", "degeneracy.html"),
]
