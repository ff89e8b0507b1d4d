! SPDX-License-Identifier: GPL-3.0-or-later
! Meshes are created, moved, and vertices inserted and removed.
module test_moves
    use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int32_t, c_int64_t
    use annulus
    use checks, only: expect, scatter
    implicit none
    private
    public :: moves
contains

    ! Creates, moves, inserts, removes; indices and positions after each.
    subroutine moves(d)
        integer, intent(in) :: d
        integer, parameter :: n = 60
        type(moving_mesh) :: mesh
        type(annulus_report) :: report
        type(annulus_audit_result) :: result
        real(c_double) :: x(d, n), more(d, 3), one(d, 1)
        real(c_double), allocatable :: now(:, :), lengths(:), far(:)
        integer(c_int32_t), allocatable :: made(:), input(:)
        integer :: done, stat, i
        call scatter(x, 11_c_int64_t)
        call expect(mesh%dimension() == 0 .and. mesh%vertex_count() == 0 .and. mesh%index_bound() == 0, 'no mesh yet')
        call expect(.not. mesh%is_vertex(1) .and. mesh%strategy() == '', 'no vertex yet')
        call mesh%create(x)
        call expect(mesh%dimension() == d .and. mesh%affine_dimension() == d, 'dimension')
        call expect(mesh%vertex_count() == n .and. mesh%index_bound() == n, 'as many vertices as points')
        call expect(mesh%is_vertex(1) .and. mesh%is_vertex(n), 'the first and the last vertex')
        call expect(.not. mesh%is_vertex(0) .and. .not. mesh%is_vertex(n + 1), 'no further vertices')
        call expect(mesh%strategy() == 'auto', 'strategy')
        call mesh%vertex_of_input(input)
        call expect(all(input == [(i, i = 1, n)]), 'vertex i is point i')
        call mesh%points(now)
        call expect(all(now == x), 'points')

        x = x + 1e-4_c_double * (1 - 2 * x)
        call mesh%move_all(x, report)
        call expect(report%asked == n, 'a report')
        call mesh%points(now)
        call expect(all(now == x), 'points after move_all')
        one(:, 1) = 0.5_c_double + x(:, 7) / 100
        x(:, n) = one(:, 1)
        call mesh%move([int(n, c_int32_t)], one, report)
        call expect(report%asked == 1, 'one vertex moves')
        call mesh%points(now)
        call expect(all(now == x), 'points after move')
        call mesh%recompute_tolerances(report)
        call mesh%tolerances(lengths)
        call mesh%displacements(far)
        call expect(size(lengths) == n .and. all(lengths > 0) .and. all(far == 0), 'tolerances, displacements')

        call mesh%remove([3_c_int32_t, 5_c_int32_t], done, report)
        call expect(done == 2 .and. mesh%vertex_count() == n - 2 .and. mesh%index_bound() == n, 'remove')
        call expect(.not. mesh%is_vertex(3) .and. .not. mesh%is_vertex(5) .and. mesh%is_vertex(4), 'free indices')
        call mesh%points(now)
        call expect(all(ieee_is_nan(now(:, 3))) .and. all(now(:, 4) == x(:, 4)), 'NaN at free indices')
        call scatter(more, 77_c_int64_t)
        call mesh%insert(more, made, done, report)
        call expect(done == 3 .and. all(made == [5, 3, n + 1]), 'insert: the index freed last comes first')
        call mesh%points(now)
        call expect(all(now(:, made) == more), 'points after insert')
        call mesh%insert(more(:, :0), made)
        call expect(size(made) == 0, 'no point is inserted')

        call mesh%audit(result)
        call expect(result%delaunay == 1 .and. fault_text(result) == '', 'audit')
        call mesh%create(more(:, :0), stat=stat)
        call expect(stat == ANNULUS_OK .and. mesh%vertex_count() == 0 .and. mesh%affine_dimension() == -1, 'no points')
        call mesh%destroy()
        call mesh%destroy()
        call expect(.not. c_associated(mesh%handle), 'destroyed')
    end subroutine
end module test_moves
