! SPDX-License-Identifier: GPL-3.0-or-later
!
! Of annulus_periodic: cells, neighbours, facets, point location, changes, audit. Each list is requested twice, for its
! length and for its contents; the library keeps it in between.
submodule (annulus_periodic) periodic_lists
    implicit none

contains

    module procedure vertex_of_input
        integer(c_size_t) :: count
        integer(c_int) :: status
        status = annulus_periodic_vertex_of_input(self%handle, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            call fit(indices, count)
            status = annulus_periodic_vertex_of_input(self%handle, count, indices, count)
            indices = indices + 1
        end if
        call finish_call(self, status, stat, errmsg)
    end procedure

    module procedure cells
        integer(c_size_t) :: count
        integer(c_int) :: status
        integer(c_int32_t), pointer, contiguous :: all_vertices(:, :), all_offsets(:, :, :), &
            all_neighbours(:, :), all_translations(:, :, :)
        nullify (all_vertices, all_offsets, all_neighbours, all_translations)
        status = annulus_periodic_cells(self%handle, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            if (present(vertices)) then
                call fit(vertices, self%dimension() + 1, count)
                all_vertices => vertices
            end if
            if (present(offsets)) then
                call fit(offsets, self%dimension(), self%dimension() + 1, count)
                all_offsets => offsets
            end if
            if (present(neighbours)) then
                call fit(neighbours, self%dimension() + 1, count)
                all_neighbours => neighbours
            end if
            if (present(translations)) then
                call fit(translations, self%dimension(), self%dimension() + 1, count)
                all_translations => translations
            end if
            status = annulus_periodic_cells(self%handle, count, all_vertices, all_offsets, &
                all_neighbours, all_translations, count)
            if (present(vertices)) vertices = vertices + 1
            if (present(neighbours)) neighbours = neighbours + 1
        end if
        call finish_call(self, status, stat, errmsg)
    end procedure

    module procedure neighbours
        integer(c_size_t) :: count
        integer(c_int) :: status
        integer(c_int32_t), pointer, contiguous :: all_first(:), all_second(:), all_shifts(:, :)
        real(c_double), pointer, contiguous :: all_vectors(:, :), all_distances(:), all_areas(:)
        nullify (all_first, all_second, all_shifts, all_vectors, all_distances, all_areas)
        status = annulus_periodic_neighbours(self%handle, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            if (present(first)) then
                call fit(first, count)
                all_first => first
            end if
            if (present(second)) then
                call fit(second, count)
                all_second => second
            end if
            if (present(shifts)) then
                call fit(shifts, self%dimension(), count)
                all_shifts => shifts
            end if
            if (present(vectors)) then
                call fit(vectors, self%dimension(), count)
                all_vectors => vectors
            end if
            if (present(distances)) then
                call fit(distances, count)
                all_distances => distances
            end if
            if (present(areas)) then
                call fit(areas, count)
                all_areas => areas
            end if
            status = annulus_periodic_neighbours(self%handle, count, all_first, all_second, all_shifts, all_vectors, &
                all_distances, all_areas, count)
            if (present(first)) first = first + 1
            if (present(second)) second = second + 1
        end if
        call finish_call(self, status, stat, errmsg)
    end procedure

    module procedure voronoi_facets
        integer(c_size_t) :: count
        integer(c_int) :: status
        integer(c_int32_t), pointer, contiguous :: all_first(:), all_second(:), all_shifts(:, :)
        real(c_double), pointer, contiguous :: all_measures(:), all_centroids(:, :)
        nullify (all_first, all_second, all_shifts, all_measures, all_centroids)
        status = annulus_periodic_voronoi_facets(self%handle, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            if (present(first)) then
                call fit(first, count)
                all_first => first
            end if
            if (present(second)) then
                call fit(second, count)
                all_second => second
            end if
            if (present(shifts)) then
                call fit(shifts, self%dimension(), count)
                all_shifts => shifts
            end if
            if (present(measures)) then
                call fit(measures, count)
                all_measures => measures
            end if
            if (present(centroids)) then
                call fit(centroids, self%dimension(), count)
                all_centroids => centroids
            end if
            status = annulus_periodic_voronoi_facets(self%handle, count, all_first, all_second, all_shifts, &
                all_measures, all_centroids, count)
            if (present(first)) first = first + 1
            if (present(second)) second = second + 1
        end if
        call finish_call(self, status, stat, errmsg)
    end procedure

    module procedure find_cells
        integer(c_int) :: status
        integer(c_int32_t), pointer, contiguous :: all_shifts(:, :)
        if (.not. fits(self, x, size(x, 2), stat, errmsg)) return
        nullify (all_shifts)
        call fit(cells, size(x, 2, c_size_t))
        cells = -1
        if (present(shifts)) then
            call fit(shifts, self%dimension(), size(x, 2, c_size_t))
            all_shifts => shifts
        end if
        status = annulus_periodic_find_cells(self%handle, size(x, 2, c_size_t), x, cells, all_shifts)
        cells = cells + 1
        call finish_call(self, status, stat, errmsg)
    end procedure

    module procedure pairs_made
        call get_pairs(self, annulus_periodic_pairs_made, first, second, shifts, stat, errmsg)
    end procedure

    module procedure pairs_broken
        call get_pairs(self, annulus_periodic_pairs_broken, first, second, shifts, stat, errmsg)
    end procedure

    module procedure changed
        call get_cells(self, annulus_periodic_changed, vertices, offsets, stat, errmsg)
    end procedure

    module procedure gone
        call get_cells(self, annulus_periodic_gone, vertices, offsets, stat, errmsg)
    end procedure

    ! pairs_made or pairs_broken.
    subroutine get_pairs(self, list, first, second, shifts, stat, errmsg)
        class(periodic_mesh), intent(in) :: self
        procedure(annulus_periodic_pairs_made) :: list
        integer(c_int32_t), allocatable, intent(inout), optional, target :: first(:), second(:), shifts(:, :)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_size_t) :: count
        integer(c_int) :: status
        integer(c_int32_t), pointer, contiguous :: all_first(:), all_second(:), all_shifts(:, :)
        nullify (all_first, all_second, all_shifts)
        status = list(self%handle, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            if (present(first)) then
                call fit(first, count)
                all_first => first
            end if
            if (present(second)) then
                call fit(second, count)
                all_second => second
            end if
            if (present(shifts)) then
                call fit(shifts, self%dimension(), count)
                all_shifts => shifts
            end if
            status = list(self%handle, count, all_first, all_second, all_shifts, count)
            if (present(first)) first = first + 1
            if (present(second)) second = second + 1
        end if
        call finish_call(self, status, stat, errmsg)
    end subroutine

    ! changed or gone.
    subroutine get_cells(self, list, vertices, offsets, stat, errmsg)
        class(periodic_mesh), intent(in) :: self
        procedure(annulus_periodic_changed) :: list
        integer(c_int32_t), allocatable, intent(inout), optional, target :: vertices(:, :), offsets(:, :, :)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_size_t) :: count
        integer(c_int) :: status
        integer(c_int32_t), pointer, contiguous :: all_vertices(:, :), all_offsets(:, :, :)
        nullify (all_vertices, all_offsets)
        status = list(self%handle, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            if (present(vertices)) then
                call fit(vertices, self%dimension() + 1, count)
                all_vertices => vertices
            end if
            if (present(offsets)) then
                call fit(offsets, self%dimension(), self%dimension() + 1, count)
                all_offsets => offsets
            end if
            status = list(self%handle, count, all_vertices, all_offsets, count)
            if (present(vertices)) vertices = vertices + 1
        end if
        call finish_call(self, status, stat, errmsg)
    end subroutine

    module procedure audit
        type(annulus_audit_result) :: empty
        result = empty
        call finish_call(self, annulus_periodic_audit(self%handle, result), stat, errmsg)
    end procedure
end submodule periodic_lists
