! SPDX-License-Identifier: GPL-3.0-or-later
! Errors by their code, their words and their vertices; options.
module test_refusals
    use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t
    use annulus
    use checks, only: expect
    implicit none
    private
    public :: refusals, options
contains

    subroutine refusals()
        type(moving_mesh) :: mesh, none
        type(annulus_audit_result) :: result
        real(c_double) :: x(2, 4), bad(2, 4)
        real(c_double), allocatable :: volumes(:), gradient(:, :)
        integer(c_int32_t), allocatable :: indices(:), cells(:, :)
        character(300) :: why
        character(8) :: cut
        integer :: stat, done
        x = reshape([real(c_double) :: 0, 0, 4, 0, 0, 4, 3, 3], [2, 4])
        call mesh%create(x, stat=stat, errmsg=why)
        call expect(stat == ANNULUS_OK, 'stat after success')
        call mesh%move([2, 4], x(:, [3, 3]), stat=stat, errmsg=why)
        call expect(stat == ANNULUS_DUPLICATE_POINT, 'two vertices at one position')
        call expect(index(why, '(counted from 1: 2, 3, 4)') > 0, 'all vertices in errmsg')
        call expect(all(mesh%error_vertices() == [2, 3, 4]), 'error_vertices')
        call expect(index(why, mesh%message()) == 1, 'message')
        call mesh%move([2, 4], x(:, [3, 3]), stat=stat, errmsg=cut)
        call expect(cut == why(:8), 'a short errmsg is cut')
        call mesh%remove([1, 5], done, stat=stat)
        call expect(stat == ANNULUS_UNKNOWN_VERTEX .and. done == 0 .and. all(mesh%error_vertices() == [5]), 'no 5')
        call mesh%remove([0], stat=stat)
        call expect(stat == ANNULUS_UNKNOWN_VERTEX .and. all(mesh%error_vertices() == [0]), 'no vertex 0')
        bad = x
        bad(2, 3) = ieee_value(0.0_c_double, ieee_quiet_nan)
        call mesh%move_all(bad, stat=stat)
        call expect(stat == ANNULUS_NOT_FINITE .and. all(mesh%error_vertices() == [3]), 'NaN')
        bad(2, 3) = 1e200_c_double
        call mesh%move_all(bad, stat=stat)
        call expect(stat == ANNULUS_OUT_OF_DOMAIN, 'out of the domain')
        call mesh%insert(reshape([real(c_double) :: 1, 1, 2, 2, 4, 0], [2, 3]), indices, done, stat=stat)
        call expect(stat == ANNULUS_DUPLICATE_POINT .and. done == 2 .and. all(indices(:2) == [5, 6]), 'insert up to it')
        call expect(all(mesh%error_vertices() == [2]), 'the vertex that is there')
        call expect(mesh%vertex_count() == 6, 'points before the error stay')

        ! Shapes that are wrong are refused before the library sees them.
        call mesh%move_all(x, stat=stat, errmsg=why)
        call expect(stat == ANNULUS_WRONG_SIZE .and. why == 'an array (2, 4) where (2, 6) is expected', 'columns')
        call mesh%move([1], reshape([real(c_double) :: 1, 1, 1], [3, 1]), stat=stat, errmsg=why)
        call expect(stat == ANNULUS_WRONG_SIZE .and. why == 'an array (3, 1) where (2, 1) is expected', 'rows')
        call mesh%move([1, 2], x(:, :1), stat=stat)
        call expect(stat == ANNULUS_WRONG_SIZE, 'a point for each index')
        call mesh%voronoi_gradient([1.0_c_double], gradient, stat=stat)
        call expect(stat == ANNULUS_WRONG_SIZE, 'a weight for each index')
        call mesh%voronoi_cells(volumes, lower=[0.0_c_double], upper=[1.0_c_double, 1.0_c_double], stat=stat)
        call expect(stat == ANNULUS_WRONG_SIZE, 'a box in another dimension')
        call mesh%voronoi_cells(volumes, lower=[0.0_c_double, 0.0_c_double], stat=stat)
        call expect(stat == ANNULUS_NULL_POINTER, 'half a box')
        call mesh%changed(cells, stat=stat)
        call expect(stat == ANNULUS_USAGE, 'changed without report_changes')
        call mesh%gone(cells, stat=stat)
        call expect(stat == ANNULUS_USAGE, 'gone without report_changes')
        call mesh%edges_made(cells, stat=stat)
        call expect(stat == ANNULUS_USAGE, 'edges_made without report_changes')
        call mesh%edges_broken(cells, stat=stat)
        call expect(stat == ANNULUS_USAGE, 'edges_broken without report_changes')
        call mesh%t1(cells, stat=stat)
        call expect(stat == ANNULUS_USAGE, 't1 without report_changes')

        call none%move_all(x, stat=stat, errmsg=why)
        call expect(stat == ANNULUS_NULL_POINTER .and. why == 'the mesh has not been created', 'no mesh to move')
        call none%audit(result, stat=stat)
        call expect(stat == ANNULUS_NULL_POINTER, 'no mesh to audit')
        call none%voronoi(volumes, stat=stat)
        call expect(stat == ANNULUS_NULL_POINTER .and. size(none%error_vertices()) == 0, 'no mesh to measure')

        ! A mesh outlives a creation that fails.
        call mesh%create(bad(:, [1, 2, 1]), stat=stat, errmsg=why)
        call expect(stat == ANNULUS_DUPLICATE_POINT .and. mesh%vertex_count() == 6, 'the mesh is still there')
        call expect(all(library_vertices() == [1, 3]) .and. index(why, library_message()) == 1, 'points that are equal')
        call mesh%audit(result)
        call expect(result%delaunay == 1, 'nothing refused has changed anything')
    end subroutine

    subroutine options()
        type(moving_mesh) :: mesh
        real(c_double) :: x(2, 3)
        integer(c_int32_t), allocatable :: vertex(:)
        integer :: stat
        x = reshape([real(c_double) :: 0, 0, 1, 0, 0, 0], [2, 3])
        call mesh%create(x, strategy='rebuild', tolerance='certified', threads=2, merge_duplicates=.true., &
            report_changes=.false., seed=3_c_int64_t)
        call mesh%vertex_of_input(vertex)
        call expect(mesh%strategy() == 'rebuild' .and. all(vertex == [1, 2, 1]), 'options arrive')
        call mesh%create(x, strategy='fastest', stat=stat)
        call expect(stat == ANNULUS_USAGE, 'an unknown strategy')
        call mesh%create(x, strategy='rebuild' // repeat('x', 100), stat=stat)
        call expect(stat == ANNULUS_USAGE, 'a long name')
        call mesh%create(reshape([1.0_c_double], [1, 1]), stat=stat)
        call expect(stat == ANNULUS_USAGE, 'dimension 1')
    end subroutine
end module test_refusals
