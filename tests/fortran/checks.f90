! SPDX-License-Identifier: GPL-3.0-or-later
! What the parts of the test share: counted checks, and points.
module checks
    use, intrinsic :: iso_c_binding, only: c_double, c_int64_t
    implicit none
    integer :: checked = 0, failed = 0
contains
    subroutine expect(holds, what)
        logical, intent(in) :: holds
        character(*), intent(in) :: what
        checked = checked + 1
        if (holds) return
        failed = failed + 1
        print '(2a)', 'does not hold: ', what
    end subroutine

    ! The same numbers between 0 and 1 with every compiler.
    subroutine scatter(x, seed)
        real(c_double), intent(out) :: x(:, :)
        integer(c_int64_t), intent(in) :: seed
        integer(c_int64_t) :: state
        integer :: i, j
        state = seed
        do j = 1, size(x, 2)
            do i = 1, size(x, 1)
                state = modulo(48271 * state, 2147483647_c_int64_t)
                x(i, j) = state / 2147483647.0_c_double
            end do
        end do
    end subroutine
end module checks
