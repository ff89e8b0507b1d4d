# SPDX-License-Identifier: GPL-3.0-or-later
"""
Delaunay triangulations in 2D and 3D that are kept exactly right while their vertices move.

    using Annulus
    mesh = MovingMesh(rand(3, 1000))        # a column for each point
    report = move!(mesh, x)
    volumes = voronoi_volumes(mesh)

Points are columns of a matrix of 2 or 3 rows. Every number of a vertex, a cell or a place in a list is one more than in
C: vertices and cells count from 1, 0 is no cell or the vertex at infinity, -1 is the padding of cells whose points are
in a plane or on a line. Arrays by vertex have a column or an element for each index, NaN at free ones. A call that is
refused throws an [`AnnulusError`](@ref). `annulus/annulus.h` has what each call takes, costs and refuses, and
docs/julia.md is the guide.

The shared library is `libannulus_c.so.0` where the loader finds it, or the file that the environment variable
`ANNULUS_LIBRARY` names when the package is loaded.

Threads: functions without `!` may run at the same time on one mesh, while no function with `!` does.
"""
module Annulus

import Libdl

export MovingMesh, AnnulusError
export move!, recompute_tolerances!
export affine_dimension, dimension, index_bound, is_vertex, strategy, vertex_count, vertex_of_input
export displacements, points, tolerances
export neighbour_counts, voronoi_cells, voronoi_facets, voronoi_gradient, voronoi_volumes
export audit, cells, convex_hull, find_cells, neighbour_lists, neighbours
export changed, edges_broken, edges_made, gone, t1
export audit_cells, in_circle, in_sphere, orient_2d, orient_3d

include("c.jl")
include("errors.jl")
include("mesh.jl")
include("queries.jl")
include("without_mesh.jl")

function __init__()
    # A library that is loaded is found by its soname afterwards.
    path = get(ENV, "ANNULUS_LIBRARY", "")
    isempty(path) || Libdl.dlopen(path)
    return nothing
end

end
