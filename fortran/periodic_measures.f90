! SPDX-License-Identifier: GPL-3.0-or-later
!
! Of annulus_periodic: numbers of each vertex, Voronoi cells. A disassociated pointer is an absent argument, as in
! meshes_measures.
submodule (annulus_periodic) periodic_measures
    implicit none

contains

    module procedure box_of
        call fit(vectors, self%dimension(), int(self%dimension(), c_size_t))
        call finish_call(self, annulus_periodic_box(self%handle, vectors), stat, errmsg)
    end procedure

    module procedure points
        call fit(x, self%dimension(), rows_of(self))
        call finish_call(self, annulus_periodic_points(self%handle, rows_of(self), x), stat, errmsg)
    end procedure

    module procedure tolerances
        call fit(lengths, rows_of(self))
        call finish_call(self, annulus_periodic_tolerances(self%handle, rows_of(self), lengths), stat, errmsg)
    end procedure

    module procedure voronoi
        call fit(volumes, rows_of(self))
        call finish_call(self, annulus_periodic_voronoi(self%handle, rows_of(self), volumes), stat, errmsg)
    end procedure

    module procedure voronoi_cells
        real(c_double), pointer, contiguous :: all_volumes(:), all_surfaces(:), all_centroids(:, :)
        nullify (all_volumes, all_surfaces, all_centroids)
        if (present(volumes)) then
            call fit(volumes, rows_of(self))
            all_volumes => volumes
        end if
        if (present(surfaces)) then
            call fit(surfaces, rows_of(self))
            all_surfaces => surfaces
        end if
        if (present(centroids)) then
            call fit(centroids, self%dimension(), rows_of(self))
            all_centroids => centroids
        end if
        call finish_call(self, annulus_periodic_voronoi_cells(self%handle, rows_of(self), all_volumes, all_surfaces, &
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
        call finish_call(self, annulus_periodic_voronoi_gradient(self%handle, rows_of(self), weights, gradient), stat, &
            errmsg)
    end procedure
end submodule periodic_measures
