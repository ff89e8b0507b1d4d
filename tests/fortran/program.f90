! SPDX-License-Identifier: GPL-3.0-or-later
!
! The module annulus, every procedure of it, in 2D and 3D; each error by its code, its words and its vertices.
! Prints what does not hold, and ends with `fortran: N checks, N failures`.
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

program test_fortran
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan, ieee_quiet_nan, ieee_value
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int, c_int32_t, c_int64_t, c_ptr, c_sizeof, &
        c_size_t
    use annulus
    use annulus_c, only: annulus_audit, annulus_create, annulus_destroy, annulus_interface, annulus_message_vertices, &
        annulus_options, ANNULUS_INTERFACE_OF_MODULE
    use checks
    implicit none

    call structs()
    call moves(2)
    call moves(3)
    call measures(2)
    call measures(3)
    call a_square()
    call refusals()
    call options()
    call without_a_mesh()
    call raw()
    print '(a, 2(i0, a))', 'fortran: ', checked, ' checks, ', failed, ' failures'
    if (failed > 0 .or. checked == 0) error stop 1

contains

    subroutine structs()
        type(annulus_options) :: options
        type(annulus_report) :: report
        type(annulus_audit_result) :: result
        call expect(options%size == c_sizeof(options), 'the size of annulus_options')
        call expect(report%size == c_sizeof(report), 'the size of annulus_report')
        call expect(result%size == c_sizeof(result), 'the size of annulus_audit_result')
        call expect(annulus_interface() >= ANNULUS_INTERFACE_OF_MODULE, 'the library is as new as the module')
        call expect(index(library_version(), '.') > 1, 'library_version')
        call expect(status_name(ANNULUS_DUPLICATE_POINT) == 'duplicate point', 'status_name')
    end subroutine

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
        type(moving_mesh) :: mesh
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
        call mesh%remove([5])
        call mesh%cells(cells)
        call expect(size(cells, 2) == 2, 'two triangles')
        ! On a line cells are padded.
        call mesh%create(reshape([real(c_double) :: 0, 0, 1, 1, 2, 2], [2, 3]))
        call mesh%cells(cells, neighbours)
        call expect(mesh%affine_dimension() == 1 .and. all(count(cells == -1, 1) == 1) .and. all(neighbours == 0), &
            'cells on a line are padded with -1')
    end subroutine

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

    ! annulus_c, with the handle of a moving_mesh and without.
    subroutine raw()
        type(moving_mesh) :: mesh
        type(c_ptr) :: handle
        type(annulus_audit_result) :: result
        integer(c_int32_t) :: pair(2)
        real(c_double) :: x(3, 20)
        call scatter(x, 3_c_int64_t)
        call mesh%create(x)
        call expect(annulus_audit(mesh%handle, result) == ANNULUS_OK .and. result%delaunay == 1, 'annulus_audit')
        x(:, 2) = x(:, 1)
        call expect(annulus_create(handle, 3, 20_c_size_t, x) == ANNULUS_DUPLICATE_POINT, 'annulus_create')
        call expect(.not. c_associated(handle), 'no mesh after an error')
        call annulus_destroy(handle)
        pair = -9
        call expect(annulus_message_vertices(handle, pair) == 2, 'annulus_message_vertices')
        call expect(all(pair == [0, 1]), 'indices from 0')
    end subroutine
end program test_fortran
