! SPDX-License-Identifier: GPL-3.0-or-later
! The type periodic_mesh.
module test_periodic
    use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int32_t, c_int64_t
    use annulus
    use checks, only: expect, scatter
    implicit none
    private
    public :: a_loop, in_a_box, lists_in_a_box, refusals_in_a_box
contains

    ! Copper: four atoms in a cube, which is sheared and stretched with them.
    subroutine a_loop()
        integer, parameter :: n = 4, steps = 3
        type(annulus_report) :: report
        real(c_double) :: x(3, n), box(3, 3)
        integer :: step
        ! [docs]
        type(periodic_mesh) :: mesh
        real(c_double), allocatable :: volumes(:), areas(:)
        integer(c_int32_t), allocatable :: i(:), j(:), shifts(:, :)
        x = reshape([0d0, 0d0, 0d0, .5d0, .5d0, 0d0, .5d0, 0d0, .5d0, 0d0, .5d0, .5d0], [3, n])
        box = reshape([1d0, 0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0], [3, 3]) ! box(:, k): its vector k
        call mesh%create(x, box)
        do step = 1, steps
            x(1, :) = x(1, :) + 0.0625d0 * x(2, :)
            box(1, 2) = box(1, 2) + 0.0625d0
            call mesh%move_all(x, box, report)
            call mesh%voronoi(volumes)                                ! they add up to that of the box
            call mesh%neighbours(i, j, shifts, areas=areas)           ! x(:, j) + matmul(box, shifts) is beside x(:, i)
        end do
        ! [docs]
        call expect(report%asked == n .and. all(abs(volumes - 0.25d0) < 1e-9), 'four equal cells')
        call expect(size(i) == size(areas) .and. count(i == 1 .and. areas > 1e-9) >= 12, 'neighbours of an atom')
        call expect(all(abs(sum(spread(areas, 1, 3) * (x(:, j) - x(:, i) + matmul(box, shifts)), 2)) < 1e-9), &
            'neighbours in both directions')
    end subroutine

    ! A box that is skewed and points in it, or anywhere.
    subroutine a_scene(x, box)
        real(c_double), intent(out) :: x(:, :), box(:, :)
        integer :: k, d
        d = size(x, 1)
        call scatter(x, 11_c_int64_t)
        box = 0
        do k = 1, d
            box(k, k) = 1 + 0.25d0 * k
        end do
        box(1, 2) = 0.375d0
        x = matmul(box, x)
    end subroutine

    real(c_double) function volume_of(box) result(volume)
        real(c_double), intent(in) :: box(:, :)
        integer :: k
        volume = 1 ! of a box as above
        do k = 1, size(box, 1)
            volume = volume * box(k, k)
        end do
    end function

    ! Creates, moves, inserts, removes; what there is after each.
    subroutine in_a_box(d)
        integer, intent(in) :: d
        integer, parameter :: n = 80
        type(periodic_mesh) :: mesh
        type(annulus_report) :: report
        type(annulus_audit_result) :: result
        real(c_double) :: x(d, n), box(d, d), more(d, 2), one(d, 1), weights(n), slope
        real(c_double), allocatable :: now(:, :), lengths(:), volumes(:), others(:), surfaces(:), centroids(:, :), &
            gradient(:, :)
        integer(c_int32_t), allocatable :: made(:), of(:)
        integer :: i
        call a_scene(x, box)
        call expect(mesh%dimension() == 0 .and. mesh%vertex_count() == 0 .and. mesh%index_bound() == 0, 'no mesh yet')
        call expect(.not. mesh%is_vertex(1) .and. mesh%message() == '', 'no vertex yet')
        call mesh%create(x, box, strategy='tolerances', threads=2)
        call expect(mesh%dimension() == d .and. mesh%vertex_count() == n .and. mesh%index_bound() == n, 'as given')
        call expect(mesh%is_vertex(1) .and. mesh%is_vertex(n), 'the first and the last vertex')
        call expect(.not. mesh%is_vertex(0) .and. .not. mesh%is_vertex(n + 1), 'no further vertices')
        call mesh%vertex_of_input(of)
        call expect(all(of == [(i, i = 1, n)]), 'vertex i is point i')
        call mesh%points(now)
        call expect(all(shape(now) == [d, n]) .and. all(abs(now - x) < 1e-14), 'points')
        call mesh%box(now)
        call expect(all(shape(now) == [d, d]) .and. all(now == box), 'the box')

        call mesh%tolerances(lengths)
        call expect(size(lengths) == n .and. all(lengths >= 0) .and. any(lengths > 1e-6), 'tolerances')
        call mesh%recompute_tolerances(report)
        call expect(report%evaluated > 0, 'tolerances are computed again')
        x(1, :) = x(1, :) + 1e-9_c_double
        call mesh%move_all(x, report=report)
        call expect(report%asked == n .and. report%within_tolerance > n / 2, 'a small move')
        box(1, 1) = 1.5_c_double * box(1, 1)
        x(1, :) = 1.5_c_double * x(1, :)
        call mesh%move_all(x, box, report)
        call mesh%box(now)
        call expect(report%asked == n .and. all(now == box), 'another box')
        one(:, 1) = x(:, 5) + 0.01_c_double
        call mesh%move([5], one, report)
        call mesh%points(now)
        call expect(report%asked == 1 .and. all(abs(now(:, 5) - one(:, 1)) < 1e-14), 'one vertex')
        x(:, 5) = one(:, 1)

        call mesh%voronoi(volumes)
        call expect(abs(sum(volumes) - volume_of(box)) < 1e-8, 'volumes fill the box')
        call mesh%voronoi_cells(others, surfaces, centroids)
        call expect(all(abs(others - volumes) < 1e-8 * volumes) .and. all(surfaces > 0), 'the same volumes')
        call expect(all(shape(centroids) == [d, n]), 'centroids')
        call mesh%voronoi_cells(surfaces=others)
        call expect(all(others == surfaces), 'one of three results')
        weights = 0
        weights(:20) = 1
        call mesh%voronoi_gradient(weights, gradient)
        call expect(all(shape(gradient) == [d, n]), 'the shape of the gradient')
        slope = gradient(d, 3)
        x(d, 3) = x(d, 3) + 1e-6_c_double
        call mesh%move_all(x)
        call mesh%voronoi(volumes)
        x(d, 3) = x(d, 3) - 2e-6_c_double
        call mesh%move_all(x)
        call mesh%voronoi(others)
        call expect(abs(sum(volumes(:20) - others(:20)) / 2e-6_c_double - slope) < 1e-5, 'the gradient by differences')

        call mesh%remove([4, 7])
        call expect(mesh%vertex_count() == n - 2 .and. mesh%index_bound() == n, 'two vertices less')
        call expect(.not. mesh%is_vertex(4) .and. .not. mesh%is_vertex(7), 'free indices')
        call mesh%points(now)
        call expect(all(ieee_is_nan(now(:, [4, 7]))), 'NaN at free indices')
        more = x(:, [4, 7]) + 0.001_c_double
        call mesh%insert(more, made)
        call expect(all(made == [7, 4]), 'the index that was freed last comes first')
        call mesh%insert(x(:, [4]))
        call expect(mesh%index_bound() == n + 1, 'a new index')
        call mesh%audit(result)
        call expect(result%delaunay == 1 .and. fault_text(result) == '', 'audit')

        call mesh%create(x(:, [1, 2, 1]), box, merge_duplicates=.true.)
        call mesh%vertex_of_input(of)
        call expect(mesh%vertex_count() == 2 .and. all(of == [1, 2, 1]), 'one vertex of two points')
        call mesh%destroy()
        call expect(.not. c_associated(mesh%handle) .and. mesh%vertex_count() == 0, 'destroy')
    end subroutine

    ! Lists, compared with one another.
    subroutine lists_in_a_box(d)
        integer, intent(in) :: d
        integer, parameter :: n = 50
        type(periodic_mesh) :: mesh
        real(c_double) :: x(d, n), box(d, d), at(d, d + 1), middle(d, 1)
        real(c_double), allocatable :: vectors(:, :), distances(:), areas(:), measures(:), centroids(:, :)
        integer(c_int32_t), allocatable :: vertices(:, :), offsets(:, :, :), beyond(:, :), translations(:, :, :), &
            first(:), second(:), shifts(:, :), i(:), j(:), s(:, :), found(:), by(:, :), made(:), broken(:), old(:, :), &
            old_offsets(:, :, :), new(:, :), new_offsets(:, :, :)
        integer :: c, k, cells
        logical :: right
        call a_scene(x, box)
        call mesh%create(x, box, report_changes=.true.)
        call mesh%cells(vertices, offsets, beyond, translations)
        cells = size(vertices, 2)
        call expect(all(shape(offsets) == [d, d + 1, cells]) .and. all(shape(translations) == shape(offsets)), 'shapes')
        call expect(d == 3 .or. cells == 2 * n, 'triangles')
        call expect(minval(vertices) == 1 .and. maxval(vertices) == n, 'every vertex')
        call expect(minval(beyond) == 1 .and. maxval(beyond) == cells, 'every cell')
        right = .true.
        do c = 1, cells
            do k = 1, d + 1
                at(:, k) = x(:, vertices(k, c)) + matmul(box, offsets(:, k, c))
                right = right .and. count(beyond(:, beyond(k, c)) == c) > 0
            end do
            if (c > 10) cycle
            middle(:, 1) = sum(at, 2) / (d + 1)
            call mesh%find_cells(middle, found, by)
            right = right .and. found(1) == c .and. all(shape(by) == [d, 1]) .and. all(by == 0)
            middle(:, 1) = middle(:, 1) + box(:, 2)
            call mesh%find_cells(middle, found, by)
            right = right .and. found(1) == c .and. by(2, 1) == 1 .and. count(by == 0) == d - 1
            call mesh%find_cells(middle, found)
            right = right .and. found(1) == c
        end do
        call expect(right, 'the middle of each cell is in it, and it is a neighbour of its neighbours')

        call mesh%neighbours(first, second, shifts, vectors, distances, areas)
        call expect(all(abs(vectors - (x(:, second) - x(:, first) + matmul(box, shifts))) < 1e-12), 'vectors')
        call expect(all(abs(distances - norm2(vectors, 1)) < 1e-12), 'distances')
        call expect(minval(first) == 1 .and. maxval(first) == n .and. all(areas >= 0), 'of every vertex')
        call mesh%voronoi_facets(i, j, s, measures, centroids)
        call expect(2 * size(i) == size(first) .and. all(i <= j), 'each facet once')
        call expect(abs(2 * sum(measures) - sum(areas)) < 1e-8 .and. all(shape(centroids) == [d, size(i)]), 'measures')
        call expect(all(shape(s) == [d, size(i)]), 'shifts of facets')
        call mesh%neighbours(areas=measures)
        call expect(all(measures == areas), 'one of six results')

        call mesh%remove([9])
        call mesh%pairs_broken(i, j, s)
        call mesh%pairs_made(made)
        call expect(size(i) > d .and. all(shape(s) == [d, size(i)]) .and. all(i <= j), 'pairs that are broken')
        call expect(count(i == 9 .or. j == 9) == count(first == 9), 'those of the vertex')
        call mesh%gone(old, old_offsets)
        call mesh%changed(new, new_offsets)
        call expect(size(old, 1) == d + 1 .and. all(shape(old_offsets) == [d, d + 1, size(old, 2)]), 'cells gone')
        call expect(all([(any(old(:, k) == 9), k = 1, size(old, 2))]) .and. .not. any(new == 9), 'all of the vertex')
        call mesh%insert(x(:, [9]))
        call mesh%pairs_made(first)
        call mesh%pairs_broken(broken)
        call expect(size(first) == size(i) .and. size(broken) == size(made), 'what was broken is made')
        call mesh%changed(vertices)
        call expect(all(shape(vertices) == shape(old)) .and. all(vertices == old), 'cells that are there again')
        call mesh%create(x(:, :0), box)
        call mesh%find_cells(x(:, [1]), found)
        call mesh%cells(vertices)
        call expect(all(found == [0]) .and. size(vertices) == 0, 'no cells')
    end subroutine

    subroutine refusals_in_a_box()
        type(periodic_mesh) :: mesh, none
        type(annulus_audit_result) :: result
        real(c_double) :: x(2, 4), box(2, 2)
        real(c_double), allocatable :: volumes(:), gradient(:, :)
        integer(c_int32_t), allocatable :: some(:), cells(:, :)
        character(200) :: why
        integer :: stat
        x = reshape([real(c_double) :: 0, 0, 1, 1, 2, 1, 3, 2], [2, 4])
        box = reshape([real(c_double) :: 4, 0, 0, 4], [2, 2])
        call mesh%create(x, box, stat=stat, errmsg=why)
        call expect(stat == ANNULUS_OK, 'stat after success')
        call mesh%create(x(:, [1, 2, 1]), box, stat=stat, errmsg=why)
        call expect(stat == ANNULUS_DUPLICATE_POINT .and. mesh%vertex_count() == 4, 'the mesh is still there')
        call expect(all(library_vertices() == [1, 3]) .and. index(why, library_message()) == 1, 'points that are equal')
        x(:, 3) = x(:, 2) + [4, -8]
        call mesh%move_all(x, stat=stat, errmsg=why)
        call expect(stat == ANNULUS_DUPLICATE_POINT .and. all(mesh%error_vertices() == [2, 3]), 'images of one another')
        call expect(why == mesh%message() // ' (counted from 1: 2, 3)', 'both in errmsg')
        call mesh%move([3], x(:, [3]), stat=stat, errmsg=why)
        call expect(stat == ANNULUS_DUPLICATE_POINT .and. all(mesh%error_vertices() == [2, 3]), 'the same by one move')
        call expect(why == mesh%message() // ' (counted from 1: 2, 3)', 'the same words')
        call mesh%insert(x(:, [3]), some, stat=stat)
        call expect(stat == ANNULUS_DUPLICATE_POINT .and. all(mesh%error_vertices() == [2]), 'a vertex is there')
        call mesh%remove([1, 5], stat=stat)
        call expect(stat == ANNULUS_UNKNOWN_VERTEX .and. all(mesh%error_vertices() == [5]), 'no 5')
        call mesh%create(x, box, strategy='in-place', stat=stat, errmsg=why)
        call expect(stat == ANNULUS_USAGE .and. index(why, 'there are auto, signs, tolerances') > 0, 'a strategy')
        call mesh%create(x, box, threads=-1, stat=stat)
        call expect(stat == ANNULUS_USAGE, 'threads')
        call mesh%create(x, 0 * box, stat=stat)
        call expect(stat == ANNULUS_USAGE, 'a box without volume')
        call mesh%create(reshape([1.0_c_double], [1, 1]), reshape([1.0_c_double], [1, 1]), stat=stat)
        call expect(stat == ANNULUS_USAGE, 'dimension 1')

        ! Shapes that are wrong are refused before the library sees them.
        call mesh%create(x, box(:, :1), stat=stat, errmsg=why)
        call expect(stat == ANNULUS_WRONG_SIZE .and. why == 'an array (2, 1) where (2, 2) is expected', 'half a box')
        call mesh%move_all(x, box(:1, :), stat=stat, errmsg=why)
        call expect(stat == ANNULUS_WRONG_SIZE .and. why == 'an array (1, 2) where (2, 2) is expected', 'and half')
        call mesh%move_all(x(:, :3), stat=stat)
        call expect(stat == ANNULUS_WRONG_SIZE, 'columns')
        call mesh%move([1, 2], x(:, :1), stat=stat)
        call expect(stat == ANNULUS_WRONG_SIZE, 'a point for each index')
        call mesh%voronoi_gradient([1.0_c_double], gradient, stat=stat)
        call expect(stat == ANNULUS_WRONG_SIZE, 'a weight for each index')
        call mesh%voronoi_cells(stat=stat)
        call expect(stat == ANNULUS_NULL_POINTER, 'no result at all')
        call mesh%pairs_made(some, stat=stat)
        call expect(stat == ANNULUS_USAGE, 'pairs_made without report_changes')
        call mesh%gone(cells, stat=stat)
        call expect(stat == ANNULUS_USAGE, 'gone without report_changes')

        call none%move_all(x, stat=stat, errmsg=why)
        call expect(stat == ANNULUS_NULL_POINTER .and. why == 'the mesh has not been created', 'no mesh to move')
        call none%audit(result, stat=stat)
        call expect(stat == ANNULUS_NULL_POINTER, 'no mesh to audit')
        call none%voronoi(volumes, stat=stat)
        call expect(stat == ANNULUS_NULL_POINTER .and. size(none%error_vertices()) == 0, 'no mesh to measure')
        call none%box(gradient, stat=stat)
        call expect(stat == ANNULUS_NULL_POINTER, 'no box')
        call mesh%audit(result)
        call expect(result%delaunay == 1, 'nothing refused has changed anything')
    end subroutine
end module test_periodic
