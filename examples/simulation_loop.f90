! SPDX-License-Identifier: GPL-3.0-or-later
!
! Particles that move, in Fortran: volumes of Voronoi cells, neighbours and errors at each step.
program simulation_loop
    ! [docs]
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
    use annulus
    implicit none
    integer, parameter :: n = 500, steps = 20
    type(moving_mesh) :: mesh
    type(annulus_report) :: report
    real(c_double) :: x(3, n)
    real(c_double), allocatable :: volumes(:)
    integer(c_int32_t), allocatable :: begin(:), neighbours(:)
    character(200) :: why
    integer :: step, stat

    call random_init(repeatable=.true., image_distinct=.false.)
    call random_number(x)
    call mesh%create(x)
    do step = 1, steps
        call simulate()
        call mesh%move_all(x, report, stat, why)
        if (stat == ANNULUS_DUPLICATE_POINT) then
            print '(2a)', trim(why), '; separate these vertices and go on:'
            print *, mesh%error_vertices()
        else if (stat /= ANNULUS_OK) then
            error stop 'the mesh is as it was before the step'
        end if
        call mesh%voronoi(volumes)                  ! volumes(i): of the cell of x(:, i), infinity on the hull
        call mesh%neighbour_lists(begin, neighbours) ! of vertex i: neighbours(begin(i):begin(i + 1) - 1)
    end do
    print '(i0, a, f0.1)', report%within_tolerance + report%kept_in_place, ' vertices kept their cells at ' // &
        'the end; mean number of neighbours ', real(size(neighbours)) / n
    ! [docs]

contains

    subroutine simulate()
        real(c_double) :: by(3, n)
        call random_number(by)
        x = x + 1e-4_c_double * (by - 0.5_c_double)
    end subroutine
end program simulation_loop
