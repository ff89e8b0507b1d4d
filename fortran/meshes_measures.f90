! SPDX-License-Identifier: GPL-3.0-or-later
!
! Of annulus_meshes: numbers of each vertex, Voronoi cells. A disassociated pointer is an absent argument; compilers
! differ in what they make of an allocatable one that is absent.
submodule (annulus_meshes) meshes_measures
    implicit none

contains

    module procedure points
        call fit(x, self%dimension(), rows_of(self))
        call check(self%handle, annulus_points(self%handle, rows_of(self), x), stat, errmsg)
    end procedure

    module procedure tolerances
        call fit(lengths, rows_of(self))
        call check(self%handle, annulus_tolerances(self%handle, rows_of(self), lengths), stat, errmsg)
    end procedure

    module procedure displacements
        call fit(lengths, rows_of(self))
        call check(self%handle, annulus_displacements(self%handle, rows_of(self), lengths), stat, errmsg)
    end procedure

    module procedure voronoi
        real(c_double), pointer, contiguous :: all_volumes(:)
        integer(c_int32_t), pointer, contiguous :: all_counts(:)
        nullify (all_volumes, all_counts)
        if (present(volumes)) then
            call fit(volumes, rows_of(self))
            all_volumes => volumes
        end if
        if (present(neighbour_counts)) then
            call fit(neighbour_counts, rows_of(self))
            all_counts => neighbour_counts
        end if
        call check(self%handle, annulus_voronoi(self%handle, rows_of(self), all_volumes, all_counts), stat, errmsg)
    end procedure

    module procedure voronoi_cells
        real(c_double), pointer, contiguous :: all_volumes(:), all_centroids(:, :)
        nullify (all_volumes, all_centroids)
        if (present(lower)) then
            if (.not. fits(self, reshape(lower, [size(lower), 1]), 1, stat, errmsg)) return
        end if
        if (present(upper)) then
            if (.not. fits(self, reshape(upper, [size(upper), 1]), 1, stat, errmsg)) return
        end if
        if (present(volumes)) then
            call fit(volumes, rows_of(self))
            all_volumes => volumes
        end if
        if (present(centroids)) then
            call fit(centroids, self%dimension(), rows_of(self))
            all_centroids => centroids
        end if
        call check(self%handle, annulus_voronoi_cells(self%handle, lower, upper, rows_of(self), all_volumes, &
            all_centroids), stat, errmsg)
    end procedure

    module procedure voronoi_gradient
        integer :: bound
        bound = self%index_bound()
        if (c_associated(self%handle) .and. size(weights) /= bound) then
            call fail(ANNULUS_WRONG_SIZE, 'not one weight for each index', stat, errmsg)
            return
        end if
        call fit(gradient, self%dimension(), rows_of(self))
        call check(self%handle, annulus_voronoi_gradient(self%handle, rows_of(self), weights, gradient), stat, errmsg)
    end procedure

    module procedure voronoi_facets
        integer(c_size_t) :: count
        integer(c_int) :: status
        real(c_double), pointer, contiguous :: all_measures(:), all_centroids(:, :)
        nullify (all_measures, all_centroids)
        status = annulus_neighbour_lists(self%handle, 0_c_size_t, capacity=0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            if (present(measures)) then
                call fit(measures, count)
                all_measures => measures
            end if
            if (present(centroids)) then
                call fit(centroids, self%dimension(), count)
                all_centroids => centroids
            end if
            status = annulus_voronoi_facets(self%handle, count, all_measures, all_centroids, count)
        end if
        call check(self%handle, status, stat, errmsg)
    end procedure
end submodule meshes_measures
