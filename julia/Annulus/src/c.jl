# SPDX-License-Identifier: GPL-3.0-or-later
"""
The functions, structs and constants of annulus.h as they are: indices from 0, a status as the result.
`annulus/annulus.h` documents them.
"""
module C

const library = "libannulus_c.so.0"

# ANNULUS_INTERFACE of the header that this file was written for; `annulus_interface` returns the library's.
const INTERFACE = 8

# annulus_status
const OK = 0
const NULL_POINTER = 1
const USAGE = 2
const WRONG_SIZE = 3
const NOT_FINITE = 4
const OUT_OF_DOMAIN = 5
const DUPLICATE_POINT = 6
const UNKNOWN_VERTEX = 7
const ENVIRONMENT = 8
const TOO_LARGE = 9
const NO_MEMORY = 10
const NO_TRIANGULATION = 11
const INTERNAL = 12

# annulus_fault_kind
const UNKNOWN_POINT = 0
const FLAT_CELL = 1
const OVERLAP = 2
const UNUSED_POINT = 3
const EQUAL_POINTS = 4
const NOT_DELAUNAY = 5
const HULL_NOT_CONVEX = 6
const HULL_BROKEN = 7
const NOT_FLAT = 8

struct Options
    size::Csize_t
    strategy::Ptr{UInt8}
    tolerance::Ptr{UInt8}
    second_look::Ptr{UInt8}
    threads::Int32
    merge_duplicates::Int32
    report_changes::Int32
    reserved::Int32
    seed::UInt64
end

struct Report
    size::Csize_t
    asked::UInt64
    within_tolerance::UInt64
    kept_in_place::UInt64
    flipped::UInt64
    reinserted::UInt64
    rebuilt::UInt64
    evaluated::UInt64
    by_filter::UInt64
    by_intervals::UInt64
    by_integers::UInt64
    flips::UInt64
    tolerance_steps::UInt64
    sign_steps::UInt64
    rebuild_steps::UInt64
    changed::UInt64
    cost::Cdouble
end

struct AuditResult
    size::Csize_t
    delaunay::Int32
    reserved::Int32
    inverted_cells::UInt64
    violated_facets::UInt64
    concave_ridges::UInt64
    topological_faults::UInt64
    degenerate_facets::UInt64
    first_fault::NTuple{232,UInt8}
end

struct Sign
    tolerance::Cdouble
    width_lower::Cdouble
    width_upper::Cdouble
    theta::Cdouble
    sign::Int32
    stage::Int32
end

struct Fault
    cells::NTuple{2,Int64}
    vertices::NTuple{5,Int32}
    kind::Int32
end

"All members 0, but for the size, which is the first."
zeroed(::Type{Report}) = Report(sizeof(Report), ntuple(_ -> 0, 15)..., 0.0)
zeroed(::Type{AuditResult}) = AuditResult(sizeof(AuditResult), ntuple(_ -> 0, 7)..., ntuple(_ -> 0x00, 232))

function annulus_create(mesh, dimension, points, coordinates, options)
    return ccall((:annulus_create, library), Cint, (Ptr{Ptr{Cvoid}}, Cint, Csize_t, Ptr{Cdouble}, Ptr{Options}),
                 mesh, dimension, points, coordinates, options)
end

function annulus_destroy(mesh)
    return ccall((:annulus_destroy, library), Cvoid, (Ptr{Ptr{Cvoid}},), mesh)
end

function annulus_message(mesh, buffer, capacity)
    return ccall((:annulus_message, library), Csize_t, (Ptr{Cvoid}, Ptr{UInt8}, Csize_t),
                 mesh, buffer, capacity)
end

function annulus_error_vertices(mesh, capacity, vertices)
    return ccall((:annulus_error_vertices, library), Csize_t, (Ptr{Cvoid}, Csize_t, Ptr{Int32}),
                 mesh, capacity, vertices)
end

function annulus_message_vertices(mesh, vertices)
    return ccall((:annulus_message_vertices, library), Csize_t, (Ptr{Cvoid}, Ptr{Int32}), mesh, vertices)
end

function annulus_status_name(status)
    return ccall((:annulus_status_name, library), Ptr{UInt8}, (Cint,), status)
end

function annulus_version()
    return ccall((:annulus_version, library), Ptr{UInt8}, ())
end

function annulus_interface()
    return ccall((:annulus_interface, library), Cint, ())
end

function annulus_move_all(mesh, points, coordinates, report)
    return ccall((:annulus_move_all, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}, Ptr{Report}),
                 mesh, points, coordinates, report)
end

function annulus_move(mesh, count, indices, coordinates, report)
    return ccall((:annulus_move, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Cdouble}, Ptr{Report}),
                 mesh, count, indices, coordinates, report)
end

function annulus_insert(mesh, count, coordinates, indices, inserted, report)
    return ccall((:annulus_insert, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}, Ptr{Int32}, Ptr{Csize_t}, Ptr{Report}),
                 mesh, count, coordinates, indices, inserted, report)
end

function annulus_remove(mesh, count, indices, removed, report)
    return ccall((:annulus_remove, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Csize_t}, Ptr{Report}),
                 mesh, count, indices, removed, report)
end

function annulus_recompute_tolerances(mesh, report)
    return ccall((:annulus_recompute_tolerances, library), Cint, (Ptr{Cvoid}, Ptr{Report}), mesh, report)
end

function annulus_dimension(mesh, dimension)
    return ccall((:annulus_dimension, library), Cint, (Ptr{Cvoid}, Ptr{Cint}), mesh, dimension)
end

function annulus_affine_dimension(mesh, dimension)
    return ccall((:annulus_affine_dimension, library), Cint, (Ptr{Cvoid}, Ptr{Cint}), mesh, dimension)
end

function annulus_vertex_count(mesh, count)
    return ccall((:annulus_vertex_count, library), Cint, (Ptr{Cvoid}, Ptr{Csize_t}), mesh, count)
end

function annulus_index_bound(mesh, bound)
    return ccall((:annulus_index_bound, library), Cint, (Ptr{Cvoid}, Ptr{Csize_t}), mesh, bound)
end

function annulus_is_vertex(mesh, index, answer)
    return ccall((:annulus_is_vertex, library), Cint, (Ptr{Cvoid}, Int32, Ptr{Cint}), mesh, index, answer)
end

function annulus_strategy(mesh, name)
    return ccall((:annulus_strategy, library), Cint, (Ptr{Cvoid}, Ptr{Ptr{UInt8}}), mesh, name)
end

function annulus_points(mesh, capacity, coordinates)
    return ccall((:annulus_points, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}),
                 mesh, capacity, coordinates)
end

function annulus_tolerances(mesh, capacity, lengths)
    return ccall((:annulus_tolerances, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}),
                 mesh, capacity, lengths)
end

function annulus_displacements(mesh, capacity, lengths)
    return ccall((:annulus_displacements, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}),
                 mesh, capacity, lengths)
end

function annulus_voronoi(mesh, capacity, volumes, neighbour_counts)
    return ccall((:annulus_voronoi, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}, Ptr{Int32}),
                 mesh, capacity, volumes, neighbour_counts)
end

function annulus_voronoi_cells(mesh, lower, upper, capacity, volumes, centroids)
    return ccall((:annulus_voronoi_cells, library), Cint,
                 (Ptr{Cvoid}, Ptr{Cdouble}, Ptr{Cdouble}, Csize_t, Ptr{Cdouble}, Ptr{Cdouble}),
                 mesh, lower, upper, capacity, volumes, centroids)
end

function annulus_voronoi_gradient(mesh, capacity, weights, gradient)
    return ccall((:annulus_voronoi_gradient, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}, Ptr{Cdouble}),
                 mesh, capacity, weights, gradient)
end

function annulus_vertex_of_input(mesh, capacity, indices, count)
    return ccall((:annulus_vertex_of_input, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, capacity, indices, count)
end

function annulus_cells(mesh, capacity, vertices, neighbours, count)
    return ccall((:annulus_cells, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, capacity, vertices, neighbours, count)
end

function annulus_neighbours(mesh, vertex, capacity, vertices, count)
    return ccall((:annulus_neighbours, library), Cint, (Ptr{Cvoid}, Int32, Csize_t, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, vertex, capacity, vertices, count)
end

function annulus_neighbour_lists(mesh, begins, from, capacity, vertices, count)
    return ccall((:annulus_neighbour_lists, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Csize_t, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, begins, from, capacity, vertices, count)
end

function annulus_voronoi_facets(mesh, capacity, measures, centroids, count)
    return ccall((:annulus_voronoi_facets, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}, Ptr{Cdouble}, Ptr{Csize_t}),
                 mesh, capacity, measures, centroids, count)
end

function annulus_convex_hull(mesh, capacity, vertices, count)
    return ccall((:annulus_convex_hull, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, capacity, vertices, count)
end

function annulus_find_cells(mesh, points, coordinates, cells)
    return ccall((:annulus_find_cells, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}, Ptr{Int32}),
                 mesh, points, coordinates, cells)
end

function annulus_changed(mesh, capacity, vertices, count)
    return ccall((:annulus_changed, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, capacity, vertices, count)
end

function annulus_audit(mesh, result)
    return ccall((:annulus_audit, library), Cint, (Ptr{Cvoid}, Ptr{AuditResult}), mesh, result)
end

function annulus_orient_2d(count, coordinates, signs)
    return ccall((:annulus_orient_2d, library), Cint, (Csize_t, Ptr{Cdouble}, Ptr{Sign}),
                 count, coordinates, signs)
end

function annulus_orient_3d(count, coordinates, signs)
    return ccall((:annulus_orient_3d, library), Cint, (Csize_t, Ptr{Cdouble}, Ptr{Sign}),
                 count, coordinates, signs)
end

function annulus_in_circle(count, coordinates, signs)
    return ccall((:annulus_in_circle, library), Cint, (Csize_t, Ptr{Cdouble}, Ptr{Sign}),
                 count, coordinates, signs)
end

function annulus_in_sphere(count, coordinates, signs)
    return ccall((:annulus_in_sphere, library), Cint, (Csize_t, Ptr{Cdouble}, Ptr{Sign}),
                 count, coordinates, signs)
end

function annulus_audit_cells(dimension, points, coordinates, cells, vertices, result, capacity, faults, count)
    return ccall((:annulus_audit_cells, library), Cint,
                 (Cint, Csize_t, Ptr{Cdouble}, Csize_t, Ptr{Int32}, Ptr{AuditResult}, Csize_t, Ptr{Fault},
                  Ptr{Csize_t}),
                 dimension, points, coordinates, cells, vertices, result, capacity, faults, count)
end

function annulus_gone(mesh, capacity, vertices, count)
    return ccall((:annulus_gone, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, capacity, vertices, count)
end

function annulus_edges_made(mesh, capacity, vertices, count)
    return ccall((:annulus_edges_made, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, capacity, vertices, count)
end

function annulus_edges_broken(mesh, capacity, vertices, count)
    return ccall((:annulus_edges_broken, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, capacity, vertices, count)
end

# Periodic boxes

function annulus_t1(mesh, capacity, vertices, count)
    return ccall((:annulus_t1, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, capacity, vertices, count)
end

function annulus_periodic_create(mesh, dimension, points, coordinates, box, options)
    return ccall((:annulus_periodic_create, library), Cint,
                 (Ptr{Ptr{Cvoid}}, Cint, Csize_t, Ptr{Cdouble}, Ptr{Cdouble}, Ptr{Options}),
                 mesh, dimension, points, coordinates, box, options)
end

function annulus_periodic_destroy(mesh)
    return ccall((:annulus_periodic_destroy, library), Cvoid, (Ptr{Ptr{Cvoid}},),
                 mesh)
end

function annulus_periodic_message(mesh, buffer, capacity)
    return ccall((:annulus_periodic_message, library), Csize_t, (Ptr{Cvoid}, Ptr{UInt8}, Csize_t),
                 mesh, buffer, capacity)
end

function annulus_periodic_error_vertices(mesh, capacity, vertices)
    return ccall((:annulus_periodic_error_vertices, library), Csize_t, (Ptr{Cvoid}, Csize_t, Ptr{Int32}),
                 mesh, capacity, vertices)
end

function annulus_periodic_move_all(mesh, points, coordinates, box, report)
    return ccall((:annulus_periodic_move_all, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}, Ptr{Cdouble}, Ptr{Report}),
                 mesh, points, coordinates, box, report)
end

function annulus_periodic_move(mesh, count, indices, coordinates, report)
    return ccall((:annulus_periodic_move, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Cdouble}, Ptr{Report}),
                 mesh, count, indices, coordinates, report)
end

function annulus_periodic_recompute_tolerances(mesh, report)
    return ccall((:annulus_periodic_recompute_tolerances, library), Cint, (Ptr{Cvoid}, Ptr{Report}), mesh, report)
end

function annulus_periodic_insert(mesh, count, coordinates, indices)
    return ccall((:annulus_periodic_insert, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}, Ptr{Int32}),
                 mesh, count, coordinates, indices)
end

function annulus_periodic_remove(mesh, count, indices)
    return ccall((:annulus_periodic_remove, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Int32}),
                 mesh, count, indices)
end

function annulus_periodic_dimension(mesh, dimension)
    return ccall((:annulus_periodic_dimension, library), Cint, (Ptr{Cvoid}, Ptr{Cint}),
                 mesh, dimension)
end

function annulus_periodic_vertex_count(mesh, count)
    return ccall((:annulus_periodic_vertex_count, library), Cint, (Ptr{Cvoid}, Ptr{Csize_t}),
                 mesh, count)
end

function annulus_periodic_index_bound(mesh, bound)
    return ccall((:annulus_periodic_index_bound, library), Cint, (Ptr{Cvoid}, Ptr{Csize_t}),
                 mesh, bound)
end

function annulus_periodic_is_vertex(mesh, index, answer)
    return ccall((:annulus_periodic_is_vertex, library), Cint, (Ptr{Cvoid}, Int32, Ptr{Cint}),
                 mesh, index, answer)
end

function annulus_periodic_box(mesh, box)
    return ccall((:annulus_periodic_box, library), Cint, (Ptr{Cvoid}, Ptr{Cdouble}),
                 mesh, box)
end

function annulus_periodic_points(mesh, capacity, coordinates)
    return ccall((:annulus_periodic_points, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}),
                 mesh, capacity, coordinates)
end

function annulus_periodic_tolerances(mesh, capacity, tolerances)
    return ccall((:annulus_periodic_tolerances, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}),
                 mesh, capacity, tolerances)
end

function annulus_periodic_voronoi(mesh, capacity, volumes)
    return ccall((:annulus_periodic_voronoi, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}),
                 mesh, capacity, volumes)
end

function annulus_periodic_voronoi_cells(mesh, capacity, volumes, surfaces, centroids)
    return ccall((:annulus_periodic_voronoi_cells, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}, Ptr{Cdouble}, Ptr{Cdouble}),
                 mesh, capacity, volumes, surfaces, centroids)
end

function annulus_periodic_voronoi_gradient(mesh, capacity, weights, gradient)
    return ccall((:annulus_periodic_voronoi_gradient, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}, Ptr{Cdouble}),
                 mesh, capacity, weights, gradient)
end

function annulus_periodic_vertex_of_input(mesh, capacity, indices, count)
    return ccall((:annulus_periodic_vertex_of_input, library), Cint, (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, capacity, indices, count)
end

function annulus_periodic_cells(mesh, capacity, vertices, offsets, neighbours, translations, count)
    return ccall((:annulus_periodic_cells, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Int32}, Ptr{Int32}, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, capacity, vertices, offsets, neighbours, translations, count)
end

function annulus_periodic_neighbours(mesh, capacity, first, second, shifts, vectors, distances, areas, count)
    return ccall((:annulus_periodic_neighbours, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Int32}, Ptr{Int32}, Ptr{Cdouble}, Ptr{Cdouble},
                  Ptr{Cdouble}, Ptr{Csize_t}),
                 mesh, capacity, first, second, shifts, vectors, distances, areas, count)
end

function annulus_periodic_voronoi_facets(mesh, capacity, first, second, shifts, measures, centroids, count)
    return ccall((:annulus_periodic_voronoi_facets, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Int32}, Ptr{Int32}, Ptr{Cdouble}, Ptr{Cdouble},
                  Ptr{Csize_t}),
                 mesh, capacity, first, second, shifts, measures, centroids, count)
end

function annulus_periodic_voronoi_corners(mesh, begins, from, capacity, vertices, shifts, count)
    return ccall((:annulus_periodic_voronoi_corners, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Csize_t, Ptr{Int32}, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, begins, from, capacity, vertices, shifts, count)
end

function annulus_periodic_voronoi_vertices(mesh, capacity, coordinates, count)
    return ccall((:annulus_periodic_voronoi_vertices, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}, Ptr{Csize_t}),
                 mesh, capacity, coordinates, count)
end

function annulus_periodic_find_cells(mesh, points, coordinates, cells, shifts)
    return ccall((:annulus_periodic_find_cells, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Cdouble}, Ptr{Int32}, Ptr{Int32}),
                 mesh, points, coordinates, cells, shifts)
end

function annulus_periodic_pairs_made(mesh, capacity, first, second, shifts, count)
    return ccall((:annulus_periodic_pairs_made, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Int32}, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, capacity, first, second, shifts, count)
end

function annulus_periodic_pairs_broken(mesh, capacity, first, second, shifts, count)
    return ccall((:annulus_periodic_pairs_broken, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Int32}, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, capacity, first, second, shifts, count)
end

function annulus_periodic_changed(mesh, capacity, vertices, offsets, count)
    return ccall((:annulus_periodic_changed, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, capacity, vertices, offsets, count)
end

function annulus_periodic_gone(mesh, capacity, vertices, offsets, count)
    return ccall((:annulus_periodic_gone, library), Cint,
                 (Ptr{Cvoid}, Csize_t, Ptr{Int32}, Ptr{Int32}, Ptr{Csize_t}),
                 mesh, capacity, vertices, offsets, count)
end

function annulus_periodic_audit(mesh, result)
    return ccall((:annulus_periodic_audit, library), Cint, (Ptr{Cvoid}, Ptr{AuditResult}),
                 mesh, result)
end

end
