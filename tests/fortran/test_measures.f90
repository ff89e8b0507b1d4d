! SPDX-License-Identifier: GPL-3.0-or-later
! Neighbours, cells and Voronoi measures.
module test_measures
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t
    use annulus
    use checks, only: expect, scatter
    implicit none
    private
    public :: measures, a_square
contains

    ! Neighbours, cells and Voronoi measures, compared with one another.
    subroutine measures(d)
        integer, intent(in) :: d
        integer, parameter :: n = 80
        type(moving_mesh) :: mesh
        real(c_double) :: x(d, n), weights(n), low(d), high(d), volume
        real(c_double), allocatable :: volumes(:), others(:), centroids(:, :), facets(:), middles(:, :), gradient(:, :)
        integer(c_int32_t), allocatable :: counts(:), begin(:), all_of(:), of_one(:), vertices(:, :), cells(:, :), &
            hull(:, :), found(:)
        integer :: v, k, c, i, finite
        logical :: right
        call scatter(x, 5_c_int64_t)
        call mesh%create(x)
        call mesh%voronoi(volumes, counts)
        call mesh%voronoi(neighbour_counts=found)
        call expect(size(volumes) == n .and. all(found == counts), 'one of two results')
        call mesh%neighbour_lists(begin, all_of)
        call expect(begin(1) == 1 .and. begin(n + 1) == size(all_of) + 1, 'where lists begin and end')
        call mesh%voronoi_facets(facets, middles)
        call expect(size(facets) == size(all_of) .and. all(shape(middles) == [d, size(all_of)]), 'a facet each')
        call mesh%voronoi_cells(others, centroids)
        finite = 0
        do v = 1, n
            call mesh%neighbours(int(v, c_int32_t), of_one)
            call expect(all(of_one == all_of(begin(v):begin(v + 1) - 1)), 'neighbours as in neighbour_lists')
            call expect(size(of_one) == counts(v), 'counts of neighbours')
            if (.not. ieee_is_finite(volumes(v))) then
                call expect(.not. ieee_is_finite(others(v)) .and. ieee_is_nan(centroids(1, v)), 'an unbounded cell')
                cycle
            end if
            finite = finite + 1
            volume = 0 ! pyramids over the facets
            do k = begin(v), begin(v + 1) - 1
                volume = volume + facets(k) * norm2(x(:, all_of(k)) - x(:, v)) / (2 * d)
            end do
            call expect(abs(volume - volumes(v)) < 1e-9 * volume, 'the volume is that of the pyramids')
            call expect(abs(others(v) - volumes(v)) < 1e-9 * volume, 'the volumes of both functions')
        end do
        call expect(finite > 5, 'bounded cells')

        ! The gradient by central differences, at one coordinate.
        weights = merge(1.0_c_double, 0.0_c_double, ieee_is_finite(volumes) .and. volumes < 0.05_c_double)
        call mesh%voronoi_gradient(weights, gradient)
        call expect(all(shape(gradient) == [d, n]), 'the shape of the gradient')
        v = all_of(begin(findloc(weights > 0, .true., 1)))
        volume = gradient(d, v)
        x(d, v) = x(d, v) + 1e-6_c_double
        call mesh%move_all(x)
        call mesh%voronoi(volumes)
        x(d, v) = x(d, v) - 2e-6_c_double
        call mesh%move_all(x)
        call mesh%voronoi(others)
        call expect(abs(sum(volumes - others, weights > 0) / 2e-6_c_double - volume) < 1e-5, 'gradient')

        low = 0
        high = 1
        call mesh%voronoi_cells(volumes, lower=low, upper=high)
        call expect(abs(sum(volumes) - 1) < 1e-12, 'cells in a box fill it')

        call mesh%cells(vertices, cells)
        call expect(size(vertices, 1) == d + 1 .and. all(vertices >= 1) .and. all(vertices <= n), 'corners of cells')
        right = minval(cells) == 0
        do c = 1, size(cells, 2)
            do i = 1, d + 1
                if (cells(i, c) > 0) right = right .and. any(cells(:, cells(i, c)) == c) .and. &
                    .not. any(vertices(:, cells(i, c)) == vertices(i, c))
            end do
        end do
        call expect(right, 'neighbours of cells are mutual, 0 outside the hull')
        call mesh%find_cells(reshape([sum(x(:, vertices(:, 4)), 2) / (d + 1), sum(x(:, vertices(:, 9)), 2) / (d + 1), &
            high + 8], [d, 3]), found)
        call expect(all(found == [4, 9, 0]), 'find_cells')
        call mesh%convex_hull(hull)
        call expect(size(hull, 1) == d .and. size(hull, 2) == count(cells == 0), 'a facet for each open side')
    end subroutine

    ! Numbers that can be verified by hand: a square with its centre.
    subroutine a_square()
        type(moving_mesh) :: mesh, kite
        real(c_double), allocatable :: areas(:)
        integer(c_int32_t), allocatable :: around(:), hull(:, :), cells(:, :), neighbours(:, :)
        call mesh%create(reshape([real(c_double) :: 0, 0, 4, 0, 0, 4, 4, 4, 2, 2], [2, 5]), report_changes=.true.)
        call mesh%neighbours(5, around)
        call expect(all(around == [1, 2, 3, 4]), 'the neighbours of the centre')
        call mesh%voronoi(areas)
        call expect(abs(areas(5) - 8) < 1e-8 .and. .not. ieee_is_finite(areas(1)), 'the area of the centre is 8')
        call mesh%convex_hull(hull)
        call expect(size(hull, 2) == 4 .and. .not. any(hull == 5), 'the hull')
        call mesh%move([5], reshape([real(c_double) :: 9, 2], [2, 1]))
        call mesh%changed(cells)
        call expect(size(cells, 1) == 3 .and. any(cells == 5) .and. any(cells == 0), 'changed, 0 at infinity')
        call mesh%gone(cells)
        call expect(size(cells, 1) == 3 .and. any(cells == 5), 'gone')
        call mesh%edges_made(cells)
        call expect(all(cells == reshape([2, 3], [2, 1])), 'edges_made')
        call mesh%edges_broken(cells)
        call expect(all(cells == reshape([1, 5, 3, 5], [2, 2])), 'edges_broken')
        call mesh%t1(cells)
        call expect(all(shape(cells) == [4, 0]), 'no t1: the vertex has passed through the hull')
        call kite%create(reshape([real(c_double) :: 0, 0, 4, 0, 0, 4, 3, 3], [2, 4]), report_changes=.true.)
        call kite%move([4], reshape([real(c_double) :: 5, 5], [2, 1]))
        call kite%t1(cells)
        call expect(all(cells == reshape([1, 4, 2, 3], [4, 1])), 't1')
        call mesh%remove([5])
        call mesh%cells(cells)
        call expect(size(cells, 2) == 2, 'two triangles')
        ! On a line cells are padded.
        call mesh%create(reshape([real(c_double) :: 0, 0, 1, 1, 2, 2], [2, 3]))
        call mesh%cells(cells, neighbours)
        call expect(mesh%affine_dimension() == 1 .and. all(count(cells == -1, 1) == 1) .and. all(neighbours == 0), &
            'cells on a line are padded with -1')
    end subroutine
end module test_measures
