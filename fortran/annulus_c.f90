! SPDX-License-Identifier: GPL-3.0-or-later
!
! Module annulus_c: the functions of annulus.h as they are, for Fortran 2018. Indices count from 0 here, as in C, and a
! status is the result of each function; annulus/annulus.h documents them. Most programs use the module annulus, which
! is built on this one.
!
! An argument that may be NULL in C is optional here. Arrays are of assumed size: coordinates(d, n) and
! vertices(d + 1, cells), in Fortran's order, have the layout of C's. A count that is written is intent(inout), so that
! the same variable may be the capacity of that call, by value.
module annulus_c
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_int32_t, c_ptr, c_size_t
    use annulus_types
    implicit none
    private :: c_char, c_double, c_int, c_int32_t, c_ptr, c_size_t

    interface
        ! Creating and destroying a mesh, error messages.
        integer(c_int) function annulus_create(mesh, dimension, points, coordinates, options) bind(c)
            import
            type(c_ptr), intent(out) :: mesh
            integer(c_int), value :: dimension
            integer(c_size_t), value :: points
            real(c_double), intent(in), optional :: coordinates(*)
            type(annulus_options), intent(in), optional :: options
        end function
        subroutine annulus_destroy(mesh) bind(c)
            import
            type(c_ptr), intent(inout) :: mesh
        end subroutine
        integer(c_size_t) function annulus_message(mesh, buffer, capacity) bind(c)
            import
            type(c_ptr), value :: mesh
            character(kind=c_char), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
        end function
        integer(c_size_t) function annulus_error_vertices(mesh, capacity, vertices) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: vertices(*)
        end function
        integer(c_size_t) function annulus_message_vertices(mesh, vertices) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_int32_t), intent(inout) :: vertices(2)
        end function
        ! Strings of C, never NULL.
        type(c_ptr) function annulus_status_name(status) bind(c)
            import
            integer(c_int), value :: status
        end function
        type(c_ptr) function annulus_version() bind(c)
            import
        end function
        integer(c_int) function annulus_interface() bind(c)
            import
        end function
        ! Changing a mesh.
        integer(c_int) function annulus_move_all(mesh, points, coordinates, report) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: points
            real(c_double), intent(in) :: coordinates(*)
            type(annulus_report), intent(inout), optional :: report
        end function
        integer(c_int) function annulus_move(mesh, count, indices, coordinates, report) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: count
            integer(c_int32_t), intent(in) :: indices(*)
            real(c_double), intent(in) :: coordinates(*)
            type(annulus_report), intent(inout), optional :: report
        end function
        integer(c_int) function annulus_insert(mesh, count, coordinates, indices, inserted, report) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: count
            real(c_double), intent(in) :: coordinates(*)
            integer(c_int32_t), intent(inout) :: indices(*)
            integer(c_size_t), intent(inout), optional :: inserted
            type(annulus_report), intent(inout), optional :: report
        end function
        integer(c_int) function annulus_remove(mesh, count, indices, removed, report) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: count
            integer(c_int32_t), intent(in) :: indices(*)
            integer(c_size_t), intent(inout), optional :: removed
            type(annulus_report), intent(inout), optional :: report
        end function
        integer(c_int) function annulus_recompute_tolerances(mesh, report) bind(c)
            import
            type(c_ptr), value :: mesh
            type(annulus_report), intent(inout), optional :: report
        end function
        ! Queries.
        integer(c_int) function annulus_dimension(mesh, dimension) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_int), intent(out) :: dimension
        end function
        integer(c_int) function annulus_affine_dimension(mesh, dimension) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_int), intent(out) :: dimension
        end function
        integer(c_int) function annulus_vertex_count(mesh, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_index_bound(mesh, bound) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), intent(inout) :: bound
        end function
        integer(c_int) function annulus_is_vertex(mesh, index, answer) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: index
            integer(c_int), intent(out) :: answer
        end function
        ! name: a string of C.
        integer(c_int) function annulus_strategy(mesh, name) bind(c)
            import
            type(c_ptr), value :: mesh
            type(c_ptr), intent(out) :: name
        end function
        ! Arrays by vertex index.
        integer(c_int) function annulus_points(mesh, capacity, coordinates) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            real(c_double), intent(inout) :: coordinates(*)
        end function
        integer(c_int) function annulus_tolerances(mesh, capacity, lengths) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            real(c_double), intent(inout) :: lengths(*)
        end function
        integer(c_int) function annulus_displacements(mesh, capacity, lengths) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            real(c_double), intent(inout) :: lengths(*)
        end function
        integer(c_int) function annulus_voronoi(mesh, capacity, volumes, neighbour_counts) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            real(c_double), intent(inout), optional :: volumes(*)
            integer(c_int32_t), intent(inout), optional :: neighbour_counts(*)
        end function
        integer(c_int) function annulus_voronoi_cells(mesh, lower, upper, capacity, volumes, centroids) bind(c)
            import
            type(c_ptr), value :: mesh
            real(c_double), intent(in), optional :: lower(*), upper(*)
            integer(c_size_t), value :: capacity
            real(c_double), intent(inout), optional :: volumes(*), centroids(*)
        end function
        integer(c_int) function annulus_voronoi_gradient(mesh, capacity, weights, gradient) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            real(c_double), intent(in) :: weights(*)
            real(c_double), intent(inout) :: gradient(*)
        end function
        ! Lists.
        integer(c_int) function annulus_vertex_of_input(mesh, capacity, indices, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: indices(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_cells(mesh, capacity, vertices, neighbours, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: vertices(*), neighbours(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_neighbours(mesh, vertex, capacity, vertices, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: vertex
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: vertices(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_neighbour_lists(mesh, begins, begin, capacity, vertices, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: begins
            integer(c_int32_t), intent(inout), optional :: begin(*)
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: vertices(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_voronoi_facets(mesh, capacity, measures, centroids, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            real(c_double), intent(inout), optional :: measures(*), centroids(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_convex_hull(mesh, capacity, vertices, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: vertices(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_find_cells(mesh, points, coordinates, cells) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: points
            real(c_double), intent(in) :: coordinates(*)
            integer(c_int32_t), intent(inout) :: cells(*)
        end function
        integer(c_int) function annulus_changed(mesh, capacity, vertices, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: vertices(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_audit(mesh, result) bind(c)
            import
            type(c_ptr), value :: mesh
            type(annulus_audit_result), intent(inout) :: result
        end function
        ! Without a mesh.
        integer(c_int) function annulus_orient_2d(count, coordinates, signs) bind(c)
            import
            integer(c_size_t), value :: count
            real(c_double), intent(in) :: coordinates(*)
            type(annulus_sign), intent(inout) :: signs(*)
        end function
        integer(c_int) function annulus_orient_3d(count, coordinates, signs) bind(c)
            import
            integer(c_size_t), value :: count
            real(c_double), intent(in) :: coordinates(*)
            type(annulus_sign), intent(inout) :: signs(*)
        end function
        integer(c_int) function annulus_in_circle(count, coordinates, signs) bind(c)
            import
            integer(c_size_t), value :: count
            real(c_double), intent(in) :: coordinates(*)
            type(annulus_sign), intent(inout) :: signs(*)
        end function
        integer(c_int) function annulus_in_sphere(count, coordinates, signs) bind(c)
            import
            integer(c_size_t), value :: count
            real(c_double), intent(in) :: coordinates(*)
            type(annulus_sign), intent(inout) :: signs(*)
        end function
        integer(c_int) function annulus_audit_cells(dimension, points, coordinates, cells, vertices, result, &
                capacity, faults, count) bind(c)
            import
            integer(c_int), value :: dimension
            integer(c_size_t), value :: points
            real(c_double), intent(in) :: coordinates(*)
            integer(c_size_t), value :: cells
            integer(c_int32_t), intent(in) :: vertices(*)
            type(annulus_audit_result), intent(inout) :: result
            integer(c_size_t), value :: capacity
            type(annulus_fault), intent(inout), optional :: faults(*)
            integer(c_size_t), intent(inout), optional :: count
        end function
        ! What the last call changed.
        integer(c_int) function annulus_gone(mesh, capacity, vertices, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: vertices(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_edges_made(mesh, capacity, vertices, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: vertices(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_edges_broken(mesh, capacity, vertices, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: vertices(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_t1(mesh, capacity, vertices, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: vertices(*)
            integer(c_size_t), intent(inout) :: count
        end function
        ! Periodic boxes.
        integer(c_int) function annulus_periodic_create(mesh, dimension, points, coordinates, box, &
                options) bind(c)
            import
            type(c_ptr), intent(out) :: mesh
            integer(c_int), value :: dimension
            integer(c_size_t), value :: points
            real(c_double), intent(in), optional :: coordinates(*)
            real(c_double), intent(in) :: box(*)
            type(annulus_options), intent(in), optional :: options
        end function
        subroutine annulus_periodic_destroy(mesh) bind(c)
            import
            type(c_ptr), intent(inout) :: mesh
        end subroutine
        integer(c_size_t) function annulus_periodic_message(mesh, buffer, capacity) bind(c)
            import
            type(c_ptr), value :: mesh
            character(kind=c_char), intent(inout), optional :: buffer(*)
            integer(c_size_t), value :: capacity
        end function
        integer(c_size_t) function annulus_periodic_error_vertices(mesh, capacity, vertices) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: vertices(*)
        end function
        integer(c_int) function annulus_periodic_move_all(mesh, points, coordinates, box, report) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: points
            real(c_double), intent(in) :: coordinates(*)
            real(c_double), intent(in), optional :: box(*)
            type(annulus_report), intent(inout), optional :: report
        end function
        integer(c_int) function annulus_periodic_move(mesh, count, indices, coordinates, report) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: count
            integer(c_int32_t), intent(in) :: indices(*)
            real(c_double), intent(in) :: coordinates(*)
            type(annulus_report), intent(inout), optional :: report
        end function
        integer(c_int) function annulus_periodic_recompute_tolerances(mesh, report) bind(c)
            import
            type(c_ptr), value :: mesh
            type(annulus_report), intent(inout), optional :: report
        end function
        integer(c_int) function annulus_periodic_insert(mesh, count, coordinates, indices) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: count
            real(c_double), intent(in) :: coordinates(*)
            integer(c_int32_t), intent(inout) :: indices(*)
        end function
        integer(c_int) function annulus_periodic_remove(mesh, count, indices) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: count
            integer(c_int32_t), intent(in) :: indices(*)
        end function
        integer(c_int) function annulus_periodic_dimension(mesh, dimension) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_int), intent(out) :: dimension
        end function
        integer(c_int) function annulus_periodic_vertex_count(mesh, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_periodic_index_bound(mesh, bound) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), intent(inout) :: bound
        end function
        integer(c_int) function annulus_periodic_is_vertex(mesh, index, answer) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: index
            integer(c_int), intent(out) :: answer
        end function
        integer(c_int) function annulus_periodic_box(mesh, box) bind(c)
            import
            type(c_ptr), value :: mesh
            real(c_double), intent(inout) :: box(*)
        end function
        integer(c_int) function annulus_periodic_points(mesh, capacity, coordinates) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            real(c_double), intent(inout) :: coordinates(*)
        end function
        integer(c_int) function annulus_periodic_tolerances(mesh, capacity, tolerances) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            real(c_double), intent(inout) :: tolerances(*)
        end function
        integer(c_int) function annulus_periodic_voronoi(mesh, capacity, volumes) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            real(c_double), intent(inout) :: volumes(*)
        end function
        integer(c_int) function annulus_periodic_voronoi_cells(mesh, capacity, volumes, surfaces, centroids) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            real(c_double), intent(inout), optional :: volumes(*), surfaces(*), centroids(*)
        end function
        integer(c_int) function annulus_periodic_voronoi_gradient(mesh, capacity, weights, gradient) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            real(c_double), intent(in) :: weights(*)
            real(c_double), intent(inout) :: gradient(*)
        end function
        integer(c_int) function annulus_periodic_vertex_of_input(mesh, capacity, indices, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: indices(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_periodic_cells(mesh, capacity, vertices, offsets, neighbours, &
                translations, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: vertices(*), offsets(*), neighbours(*), translations(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_periodic_neighbours(mesh, capacity, first, second, shifts, vectors, &
                distances, areas, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: first(*), second(*), shifts(*)
            real(c_double), intent(inout), optional :: vectors(*), distances(*), areas(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_periodic_voronoi_facets(mesh, capacity, first, second, shifts, measures, &
                centroids, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: first(*), second(*), shifts(*)
            real(c_double), intent(inout), optional :: measures(*), centroids(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_periodic_voronoi_corners(mesh, begins, begin, capacity, vertices, shifts, &
                count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: begins, capacity
            integer(c_int32_t), intent(inout), optional :: begin(*), vertices(*), shifts(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_periodic_voronoi_vertices(mesh, capacity, coordinates, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            real(c_double), intent(inout), optional :: coordinates(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_periodic_find_cells(mesh, points, coordinates, cells, shifts) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: points
            real(c_double), intent(in) :: coordinates(*)
            integer(c_int32_t), intent(inout) :: cells(*)
            integer(c_int32_t), intent(inout), optional :: shifts(*)
        end function
        integer(c_int) function annulus_periodic_pairs_made(mesh, capacity, first, second, shifts, &
                count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: first(*), second(*), shifts(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_periodic_pairs_broken(mesh, capacity, first, second, shifts, &
                count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: first(*), second(*), shifts(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_periodic_changed(mesh, capacity, vertices, offsets, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: vertices(*), offsets(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_periodic_gone(mesh, capacity, vertices, offsets, count) bind(c)
            import
            type(c_ptr), value :: mesh
            integer(c_size_t), value :: capacity
            integer(c_int32_t), intent(inout), optional :: vertices(*), offsets(*)
            integer(c_size_t), intent(inout) :: count
        end function
        integer(c_int) function annulus_periodic_audit(mesh, result) bind(c)
            import
            type(c_ptr), value :: mesh
            type(annulus_audit_result), intent(inout) :: result
        end function
    end interface
end module annulus_c
