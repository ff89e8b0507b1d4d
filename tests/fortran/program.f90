! SPDX-License-Identifier: GPL-3.0-or-later
!
! The module annulus, every procedure of it, in 2D and 3D; each error by its code, its words and its vertices. The parts
! are the modules test_*.f90; here are the structs, and annulus_c itself.
! Prints what does not hold, and ends with `fortran: N checks, N failures`.
program test_fortran
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int32_t, c_int64_t, c_ptr, c_sizeof, c_size_t
    use annulus
    use annulus_c, only: annulus_audit, annulus_create, annulus_destroy, annulus_interface, annulus_message_vertices, &
        annulus_options, annulus_periodic_create, annulus_periodic_destroy, annulus_periodic_move_all, &
        annulus_periodic_neighbours, annulus_periodic_voronoi, annulus_periodic_voronoi_cells, &
        ANNULUS_INTERFACE_OF_MODULE
    use checks
    use test_measures, only: a_square, measures
    use test_moves, only: moves
    use test_periodic, only: a_loop, in_a_box, lists_in_a_box, refusals_in_a_box
    use test_predicates, only: without_a_mesh
    use test_refusals, only: options, refusals
    implicit none

    call structs()
    call moves(2)
    call moves(3)
    call measures(2)
    call measures(3)
    call a_square()
    call refusals()
    call options()
    call without_a_mesh()
    call raw()
    call periodic()
    call a_loop()
    call in_a_box(2)
    call in_a_box(3)
    call lists_in_a_box(2)
    call lists_in_a_box(3)
    call refusals_in_a_box()
    print '(a, 2(i0, a))', 'fortran: ', checked, ' checks, ', failed, ' failures'
    if (failed > 0 .or. checked == 0) error stop 1

contains

    subroutine structs()
        type(annulus_options) :: given
        type(annulus_report) :: report
        type(annulus_audit_result) :: result
        call expect(given%size == c_sizeof(given), 'the size of annulus_options')
        call expect(report%size == c_sizeof(report), 'the size of annulus_report')
        call expect(result%size == c_sizeof(result), 'the size of annulus_audit_result')
        call expect(annulus_interface() >= ANNULUS_INTERFACE_OF_MODULE, 'the library is as new as the module')
        call expect(index(library_version(), '.') > 1, 'library_version')
        call expect(status_name(ANNULUS_DUPLICATE_POINT) == 'duplicate point', 'status_name')
    end subroutine

    ! annulus_c, with the handle of a moving_mesh and without.
    subroutine raw()
        type(moving_mesh) :: mesh
        type(c_ptr) :: handle
        type(annulus_audit_result) :: result
        integer(c_int32_t) :: pair(2)
        real(c_double) :: x(3, 20)
        call scatter(x, 3_c_int64_t)
        call mesh%create(x)
        call expect(annulus_audit(mesh%handle, result) == ANNULUS_OK .and. result%delaunay == 1, 'annulus_audit')
        x(:, 2) = x(:, 1)
        call expect(annulus_create(handle, 3, 20_c_size_t, x) == ANNULUS_DUPLICATE_POINT, 'annulus_create')
        call expect(.not. c_associated(handle), 'no mesh after an error')
        call annulus_destroy(handle)
        pair = -9
        call expect(annulus_message_vertices(handle, pair) == 2, 'annulus_message_vertices')
        call expect(all(pair == [0, 1]), 'indices from 0')
    end subroutine

    ! Copper: four atoms in a cube, which is sheared; four cells of a quarter, neighbours in both directions.
    subroutine periodic()
        type(c_ptr) :: handle
        real(c_double) :: x(3, 4), box(3, 3), volumes(4)
        real(c_double), allocatable :: areas(:)
        integer(c_int32_t), allocatable :: i(:), j(:), shifts(:, :)
        integer(c_size_t) :: pairs
        x = reshape([0d0, 0d0, 0d0, .5d0, .5d0, 0d0, .5d0, 0d0, .5d0, 0d0, .5d0, .5d0], [3, 4])
        box = reshape([1d0, 0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0], [3, 3])
        call expect(annulus_periodic_create(handle, 3, 4_c_size_t, x, box) == ANNULUS_OK, 'annulus_periodic_create')
        call expect(annulus_periodic_neighbours(handle, 0_c_size_t, count=pairs) == ANNULUS_OK, 'a count of pairs')
        allocate (i(pairs), j(pairs), shifts(3, pairs), areas(pairs))
        call expect(annulus_periodic_neighbours(handle, pairs, i, j, shifts, areas=areas, count=pairs) == ANNULUS_OK, &
            'annulus_periodic_neighbours')
        call expect(count(i == 0 .and. areas > 0) == 12, 'neighbours of an atom')
        box(1, 2) = 0.125d0
        x(1, :) = x(1, :) + 0.125d0 * x(2, :)
        call expect(annulus_periodic_move_all(handle, 4_c_size_t, x, box) == ANNULUS_OK, 'annulus_periodic_move_all')
        call expect(annulus_periodic_voronoi(handle, 4_c_size_t, volumes) == ANNULUS_OK, 'annulus_periodic_voronoi')
        call expect(all(abs(volumes - 0.25d0) < 1e-9), 'volumes in a box')
        call expect(annulus_periodic_voronoi_cells(handle, 4_c_size_t, volumes) == ANNULUS_OK, &
            'annulus_periodic_voronoi_cells')
        call expect(all(abs(volumes - 0.25d0) < 1e-9), 'volumes of the diagram in a box')
        call annulus_periodic_destroy(handle)
        call expect(.not. c_associated(handle), 'annulus_periodic_destroy')
    end subroutine
end program test_fortran
