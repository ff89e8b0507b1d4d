! SPDX-License-Identifier: GPL-3.0-or-later
! Signs of points and audits of cells, without a mesh.
module test_predicates
    use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
    use, intrinsic :: iso_c_binding, only: c_double, c_int64_t
    use annulus
    use checks, only: expect
    implicit none
    private
    public :: without_a_mesh
contains

    subroutine without_a_mesh()
        type(annulus_sign), allocatable :: signs(:)
        type(annulus_audit_result) :: result
        type(annulus_fault), allocatable :: faults(:)
        real(c_double) :: plane(2, 4, 2), space(3, 5, 1)
        real(c_double), parameter :: x(2, 4) = reshape([real(c_double) :: 0, 0, 4, 0, 0, 4, 3, 3], [2, 4])
        integer :: stat
        plane(:, :, 1) = reshape([real(c_double) :: 0, 0, 1, 0, 0, 1, 1, 1], [2, 4])
        plane(:, :, 2) = reshape([real(c_double) :: 0, 0, 1, 0, 0, 1, 0.9, 0.9], [2, 4])
        space = reshape([real(c_double) :: 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 2, 2], [3, 5, 1])
        call orient_2d(plane(:, :3, :), signs)
        call expect(all(signs%sign == 1) .and. all(signs%tolerance > 0.1) .and. all(signs%tolerance < 0.5), 'orient_2d')
        call in_circle(plane, signs)
        call expect(all(signs%sign == [0, 1]) .and. signs(1)%tolerance == 0, 'in_circle')
        call orient_3d(space(:, :4, :), signs)
        call expect(size(signs) == 1 .and. signs(1)%sign == 1, 'orient_3d')
        call in_sphere(space, signs)
        call expect(signs(1)%sign == -1 .and. signs(1)%theta > 0, 'in_sphere')
        call in_sphere(space(:, :4, :), signs, stat)
        call expect(stat == ANNULUS_WRONG_SIZE, 'four points and no sphere')
        plane(1, 2, 2) = ieee_value(0.0_c_double, ieee_quiet_nan)
        call in_circle(plane, signs, stat)
        call expect(stat == ANNULUS_NOT_FINITE .and. all(library_vertices() == [2]), 'row 2 is refused')

        call audit_cells(x, reshape([1, 2, 4, 1, 4, 3], [3, 2]), result)
        call expect(result%delaunay == 1 .and. fault_text(result) == '', 'audit_cells')
        call audit_cells(x, reshape([1, 2, 3, 2, 4, 3], [3, 2]), result, faults)
        call expect(result%delaunay == 0 .and. len(fault_text(result)) > 0 .and. size(faults) == 1, 'a fault')
        call expect(faults(1)%kind == ANNULUS_NOT_DELAUNAY .and. all(sort2(faults(1)%cells) == [1, 2]), 'its cells')
        call audit_cells(x, reshape([1, 2, 3, 2, 4, 3], [3, 2]), result, faults, most_faults=0)
        call expect(size(faults) == 0 .and. result%violated_facets == 1, 'no more faults than requested')
        call audit_cells(x, reshape([1, 2], [1, 2]), result, stat=stat)
        call expect(stat == ANNULUS_WRONG_SIZE, 'corners of cells')
    end subroutine

    pure function sort2(pair)
        integer(c_int64_t), intent(in) :: pair(2)
        integer(c_int64_t) :: sort2(2)
        sort2 = [minval(pair), maxval(pair)]
    end function
end module test_predicates
