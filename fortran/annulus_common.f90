! SPDX-License-Identifier: GPL-3.0-or-later
!
! Module annulus_common, a part of the module annulus: errors, strings and sizes of arrays.
module annulus_common
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_f_pointer, c_int, c_int32_t, c_null_char, c_null_ptr, &
        c_ptr, c_size_t
    use annulus_c
    implicit none
    private
    public :: check, fail, fit, from_c, has_shape, in_c, to_c, message_of, vertices_of
    public :: fault_text, library_message, library_version, library_vertices, status_name

    ! Gives an array this size or shape, if it has not.
    interface fit
        procedure :: fit_real, fit_reals, fit_integer, fit_integers, fit_offsets
    end interface

contains

    ! The end of a call that returned this status: sets stat and errmsg, or ends the program. handle: the mesh of the
    ! call, c_null_ptr without one. boxed: it is one of a periodic box, here and below.
    subroutine check(handle, status, stat, errmsg, boxed)
        type(c_ptr), intent(in) :: handle
        integer(c_int), intent(in) :: status
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        logical, intent(in), optional :: boxed
        if (status == ANNULUS_OK) then
            if (present(stat)) stat = status
        else
            call fail(status, message_of(handle, boxed) // counted_from_one(vertices_of(handle, boxed)), stat, &
                errmsg)
        end if
    end subroutine

    subroutine fail(status, text, stat, errmsg)
        integer(c_int), intent(in) :: status
        character(*), intent(in) :: text
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        character(:), allocatable :: why
        if (present(errmsg)) errmsg = text
        if (present(stat)) then
            stat = status
        else
            why = 'annulus: ' // status_name(status) // ': ' // text
            error stop why
        end if
    end subroutine

    ! Whether x has this shape; else the error is reported. created: there is a mesh.
    logical function has_shape(x, rows, columns, created, stat, errmsg)
        real(c_double), intent(in) :: x(:, :)
        integer, intent(in) :: rows, columns
        logical, intent(in) :: created
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        character(120) :: text
        has_shape = size(x, 1) == rows .and. size(x, 2) == columns .and. created
        if (has_shape) return
        if (.not. created) then
            call fail(ANNULUS_NULL_POINTER, 'the mesh has not been created', stat, errmsg)
        else
            write (text, '(4(a, i0), a)') 'an array (', size(x, 1), ', ', size(x, 2), ') where (', rows, ', ', &
                columns, ') is expected'
            call fail(ANNULUS_WRONG_SIZE, trim(text), stat, errmsg)
        end if
    end function

    ! The library's words count vertices from 0.
    function counted_from_one(vertices) result(text)
        integer(c_int32_t), intent(in) :: vertices(:)
        character(:), allocatable :: text
        character(12) :: number
        integer :: i
        text = ''
        do i = 1, min(size(vertices), 8)
            write (number, '(i0)') vertices(i)
            if (i == 1) text = text // ' (counted from 1: ' // trim(number)
            if (i > 1) text = text // ', ' // trim(number)
        end do
        if (size(vertices) > 8) text = text // ', ..'
        if (size(vertices) > 0) text = text // ')'
    end function

    ! Message of the last error of a mesh, or of this thread's last one without a mesh.
    function message_of(handle, boxed) result(text)
        type(c_ptr), intent(in) :: handle
        logical, intent(in), optional :: boxed
        character(:), allocatable :: text
        character(kind=c_char), allocatable :: buffer(:)
        integer(c_size_t) :: length, i
        logical :: in_box
        in_box = .false.
        if (present(boxed)) in_box = boxed
        if (in_box) length = annulus_periodic_message(handle, capacity=0_c_size_t)
        if (.not. in_box) length = annulus_message(handle, capacity=0_c_size_t)
        allocate (buffer(length + 1))
        if (in_box) length = annulus_periodic_message(handle, buffer, length + 1)
        if (.not. in_box) length = annulus_message(handle, buffer, length + 1)
        allocate (character(length) :: text)
        do i = 1, length
            text(i:i) = buffer(i)
        end do
    end function

    function vertices_of(handle, boxed) result(vertices)
        type(c_ptr), intent(in) :: handle
        logical, intent(in), optional :: boxed
        integer(c_int32_t), allocatable :: vertices(:)
        integer(c_size_t) :: count
        logical :: in_box
        in_box = .false.
        if (present(boxed)) in_box = boxed
        if (in_box) count = annulus_periodic_error_vertices(handle, 0_c_size_t)
        if (.not. in_box) count = annulus_error_vertices(handle, 0_c_size_t)
        allocate (vertices(count))
        if (in_box) count = annulus_periodic_error_vertices(handle, count, vertices)
        if (.not. in_box) count = annulus_error_vertices(handle, count, vertices)
        vertices = vertices + 1
    end function

    ! Why the last call of this thread without a mesh failed (`create`, orient_2d .. audit_cells), in words, in which
    ! indices count from 0.
    function library_message() result(text)
        character(:), allocatable :: text
        text = message_of(c_null_ptr)
    end function

    ! The points, or rows of points, that the same error concerns.
    function library_vertices() result(vertices)
        integer(c_int32_t), allocatable :: vertices(:)
        vertices = vertices_of(c_null_ptr)
    end function

    function library_version() result(text)
        character(:), allocatable :: text
        text = from_c(annulus_version())
    end function

    ! 'duplicate point' for ANNULUS_DUPLICATE_POINT.
    function status_name(status) result(text)
        integer, intent(in) :: status
        character(:), allocatable :: text
        text = from_c(annulus_status_name(int(status, c_int)))
    end function

    ! The first fault that an audit found, in words, in which indices count from 0; '' if there is none.
    function fault_text(result) result(text)
        type(annulus_audit_result), intent(in) :: result
        character(:), allocatable :: text
        text = until_null(result%first_fault)
    end function

    function from_c(string) result(text)
        type(c_ptr), intent(in) :: string
        character(:), allocatable :: text
        character(kind=c_char), pointer :: characters(:)
        call c_f_pointer(string, characters, [256]) ! read up to the null
        text = until_null(characters)
    end function

    function until_null(characters) result(text)
        character(kind=c_char), intent(in) :: characters(:)
        character(:), allocatable :: text
        integer :: i
        text = ''
        do i = 1, size(characters)
            if (characters(i) == c_null_char) exit
            text = text // characters(i)
        end do
    end function

    ! A name as a string of C. One that does not fit is no name of the library, neither in part.
    function to_c(text) result(string)
        character(*), intent(in) :: text
        character(kind=c_char) :: string(64)
        integer :: i
        string = c_null_char
        do i = 1, min(len_trim(text), size(string) - 1)
            string(i) = text(i:i)
        end do
    end function

    ! An option as a number of C.
    integer(c_int32_t) function in_c(option)
        logical, intent(in), optional :: option
        in_c = 0
        if (present(option)) in_c = merge(1_c_int32_t, 0_c_int32_t, option)
    end function

    subroutine fit_real(array, n)
        real(c_double), allocatable, intent(inout) :: array(:)
        integer(c_size_t), intent(in) :: n
        if (allocated(array)) then
            if (size(array, kind=c_size_t) == n) return
            deallocate (array)
        end if
        allocate (array(n))
    end subroutine

    subroutine fit_reals(array, rows, n)
        real(c_double), allocatable, intent(inout) :: array(:, :)
        integer, intent(in) :: rows
        integer(c_size_t), intent(in) :: n
        if (allocated(array)) then
            if (size(array, 1) == rows .and. size(array, 2, c_size_t) == n) return
            deallocate (array)
        end if
        allocate (array(rows, n))
    end subroutine

    subroutine fit_integer(array, n)
        integer(c_int32_t), allocatable, intent(inout) :: array(:)
        integer(c_size_t), intent(in) :: n
        if (allocated(array)) then
            if (size(array, kind=c_size_t) == n) return
            deallocate (array)
        end if
        allocate (array(n))
    end subroutine

    subroutine fit_integers(array, rows, n)
        integer(c_int32_t), allocatable, intent(inout) :: array(:, :)
        integer, intent(in) :: rows
        integer(c_size_t), intent(in) :: n
        if (allocated(array)) then
            if (size(array, 1) == rows .and. size(array, 2, c_size_t) == n) return
            deallocate (array)
        end if
        allocate (array(rows, n))
    end subroutine

    subroutine fit_offsets(array, rows, corners, n)
        integer(c_int32_t), allocatable, intent(inout) :: array(:, :, :)
        integer, intent(in) :: rows, corners
        integer(c_size_t), intent(in) :: n
        if (allocated(array)) then
            if (size(array, 1) == rows .and. size(array, 2) == corners .and. size(array, 3, c_size_t) == n) return
            deallocate (array)
        end if
        allocate (array(rows, corners, n))
    end subroutine
end module annulus_common
