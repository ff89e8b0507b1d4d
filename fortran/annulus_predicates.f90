! SPDX-License-Identifier: GPL-3.0-or-later
!
! Module annulus_predicates, a part of the module annulus: what needs no mesh. annulus/annulus.h has the meaning of each
! sign and fault, and what is refused; after an error library_message and library_vertices say more.
module annulus_predicates
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int32_t, c_null_ptr, c_size_t
    use annulus_c
    use annulus_common
    implicit none
    private
    public :: orient_2d, orient_3d, in_circle, in_sphere, audit_cells

contains

    ! Signs of size(x, 3) rows of points: x(:, :, k) are the points of row k, x(2, 3, n) here.
    subroutine orient_2d(x, signs, stat, errmsg)
        real(c_double), intent(in), contiguous :: x(:, :, :)
        type(annulus_sign), allocatable, intent(inout) :: signs(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        if (.not. ready(x, 2, 3, signs, stat, errmsg)) return
        call check(c_null_ptr, annulus_orient_2d(size(x, 3, c_size_t), x, signs), stat, errmsg)
    end subroutine

    subroutine orient_3d(x, signs, stat, errmsg) ! x(3, 4, n)
        real(c_double), intent(in), contiguous :: x(:, :, :)
        type(annulus_sign), allocatable, intent(inout) :: signs(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        if (.not. ready(x, 3, 4, signs, stat, errmsg)) return
        call check(c_null_ptr, annulus_orient_3d(size(x, 3, c_size_t), x, signs), stat, errmsg)
    end subroutine

    subroutine in_circle(x, signs, stat, errmsg) ! x(2, 4, n)
        real(c_double), intent(in), contiguous :: x(:, :, :)
        type(annulus_sign), allocatable, intent(inout) :: signs(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        if (.not. ready(x, 2, 4, signs, stat, errmsg)) return
        call check(c_null_ptr, annulus_in_circle(size(x, 3, c_size_t), x, signs), stat, errmsg)
    end subroutine

    subroutine in_sphere(x, signs, stat, errmsg) ! x(3, 5, n)
        real(c_double), intent(in), contiguous :: x(:, :, :)
        type(annulus_sign), allocatable, intent(inout) :: signs(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        if (.not. ready(x, 3, 5, signs, stat, errmsg)) return
        call check(c_null_ptr, annulus_in_sphere(size(x, 3, c_size_t), x, signs), stat, errmsg)
    end subroutine

    ! An exact verdict on a triangulation made by any program: points x(d, n), cells(d + 1, m) with corners in any
    ! order, which count from 1; -1 is padding. faults: the first `most_faults` (100) of those found, by numbers of
    ! points and cells, 0 where there is no cell, -1 where there is no point.
    subroutine audit_cells(x, cells, result, faults, most_faults, stat, errmsg)
        real(c_double), intent(in), contiguous :: x(:, :)
        integer(c_int32_t), intent(in) :: cells(:, :)
        type(annulus_audit_result), intent(inout) :: result
        type(annulus_fault), allocatable, intent(inout), optional :: faults(:)
        integer, intent(in), optional :: most_faults
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        type(annulus_audit_result) :: empty
        type(annulus_fault), allocatable :: found(:)
        integer(c_size_t) :: count
        integer(c_int) :: status
        integer :: i, most
        if (size(cells, 1) /= size(x, 1) + 1) then
            call fail(ANNULUS_WRONG_SIZE, 'cells have as many corners as the dimension, and one more', stat, errmsg)
            return
        end if
        most = 0
        if (present(faults)) most = 100
        if (present(faults) .and. present(most_faults)) most = max(most_faults, 0)
        allocate (found(most))
        result = empty
        count = 0
        status = annulus_audit_cells(size(x, 1, c_int), size(x, 2, c_size_t), x, size(cells, 2, c_size_t), cells - 1, &
            result, int(most, c_size_t), found, count)
        if (present(faults)) then
            faults = found(:count)
            do i = 1, size(faults)
                faults(i)%cells = faults(i)%cells + 1
                faults(i)%vertices = faults(i)%vertices + 1
            end do
        end if
        call check(c_null_ptr, status, stat, errmsg)
    end subroutine

    ! Whether the array has the expected shape; makes room for the signs.
    logical function ready(x, dimension, points, signs, stat, errmsg)
        real(c_double), intent(in) :: x(:, :, :)
        integer, intent(in) :: dimension, points
        type(annulus_sign), allocatable, intent(inout) :: signs(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        character(80) :: text
        ready = size(x, 1) == dimension .and. size(x, 2) == points
        if (.not. ready) then
            write (text, '(a, i0, a, i0, a)') 'rows of points (', dimension, ', ', points, ') are expected'
            call fail(ANNULUS_WRONG_SIZE, trim(text), stat, errmsg)
            return
        end if
        if (allocated(signs)) then
            if (size(signs) == size(x, 3)) return
            deallocate (signs)
        end if
        allocate (signs(size(x, 3)))
    end function
end module annulus_predicates
