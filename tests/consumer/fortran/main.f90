! SPDX-License-Identifier: GPL-3.0-or-later
program fortran_consumer
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
    use annulus
    implicit none
    type(moving_mesh) :: mesh
    real(c_double), allocatable :: areas(:)
    integer(c_int32_t), allocatable :: vertices(:, :)
    call mesh%create(reshape([real(c_double) :: 0, 0, 4, 0, 0, 4, 3, 3, 1, 1], [2, 5]))
    call mesh%move([5], reshape([real(c_double) :: 2, 1], [2, 1]))
    call mesh%cells(vertices)
    call mesh%voronoi(areas)
    if (size(vertices, 2) /= 4 .or. .not. (areas(5) > 0 .and. areas(5) < 16)) error stop 'fortran-consumer: wrong'
    print '(a)', 'fortran-consumer: right'
end program fortran_consumer
