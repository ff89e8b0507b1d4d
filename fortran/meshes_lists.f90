! SPDX-License-Identifier: GPL-3.0-or-later
!
! Of annulus_meshes: cells, neighbours, the hull, point location, audit. Each list is requested twice, for its length
! and for its contents; the library keeps it in between.
submodule (annulus_meshes) meshes_lists
    implicit none

contains

    module procedure vertex_of_input
        integer(c_size_t) :: count
        integer(c_int) :: status
        status = annulus_vertex_of_input(self%handle, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            call fit(indices, count)
            status = annulus_vertex_of_input(self%handle, count, indices, count)
            indices = indices + 1
        end if
        call check(self%handle, status, stat, errmsg)
    end procedure

    module procedure cells
        integer(c_size_t) :: count
        integer(c_int) :: status
        integer(c_int32_t), pointer, contiguous :: all_vertices(:, :), all_neighbours(:, :)
        status = annulus_cells(self%handle, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            nullify (all_vertices, all_neighbours)
            if (present(vertices)) then
                call fit(vertices, self%dimension() + 1, count)
                all_vertices => vertices
            end if
            if (present(neighbours)) then
                call fit(neighbours, self%dimension() + 1, count)
                all_neighbours => neighbours
            end if
            status = annulus_cells(self%handle, count, all_vertices, all_neighbours, count)
            if (present(vertices)) vertices = vertices + 1
            if (present(neighbours)) neighbours = neighbours + 1
        end if
        call check(self%handle, status, stat, errmsg)
    end procedure

    module procedure neighbours
        integer(c_size_t) :: count
        integer(c_int) :: status
        status = annulus_neighbours(self%handle, vertex - 1, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            call fit(vertices, count)
            status = annulus_neighbours(self%handle, vertex - 1, count, vertices, count)
            vertices = vertices + 1
        end if
        call check(self%handle, status, stat, errmsg)
    end procedure

    module procedure neighbour_lists
        integer(c_size_t) :: count
        integer(c_int) :: status
        status = annulus_neighbour_lists(self%handle, 0_c_size_t, capacity=0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            call fit(begin, rows_of(self) + 1)
            call fit(vertices, count)
            status = annulus_neighbour_lists(self%handle, rows_of(self) + 1, begin, count, vertices, count)
            begin = begin + 1
            vertices = vertices + 1
        end if
        call check(self%handle, status, stat, errmsg)
    end procedure

    module procedure convex_hull
        integer(c_size_t) :: count
        integer(c_int) :: status
        status = annulus_convex_hull(self%handle, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            call fit(vertices, self%dimension(), count)
            status = annulus_convex_hull(self%handle, count, vertices, count)
            vertices = vertices + 1
        end if
        call check(self%handle, status, stat, errmsg)
    end procedure

    module procedure find_cells
        integer(c_int) :: status
        if (.not. fits(self, x, size(x, 2), stat, errmsg)) return
        call fit(cells, size(x, 2, c_size_t))
        cells = -1
        status = annulus_find_cells(self%handle, size(x, 2, c_size_t), x, cells)
        cells = cells + 1
        call check(self%handle, status, stat, errmsg)
    end procedure

    module procedure changed
        integer(c_size_t) :: count
        integer(c_int) :: status
        status = annulus_changed(self%handle, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            call fit(vertices, self%dimension() + 1, count)
            status = annulus_changed(self%handle, count, vertices, count)
            vertices = vertices + 1
        end if
        call check(self%handle, status, stat, errmsg)
    end procedure

    module procedure gone
        integer(c_size_t) :: count
        integer(c_int) :: status
        status = annulus_gone(self%handle, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            call fit(vertices, self%dimension() + 1, count)
            status = annulus_gone(self%handle, count, vertices, count)
            vertices = vertices + 1
        end if
        call check(self%handle, status, stat, errmsg)
    end procedure

    module procedure edges_made
        integer(c_size_t) :: count
        integer(c_int) :: status
        status = annulus_edges_made(self%handle, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            call fit(vertices, 2, count)
            status = annulus_edges_made(self%handle, count, vertices, count)
            vertices = vertices + 1
        end if
        call check(self%handle, status, stat, errmsg)
    end procedure

    module procedure edges_broken
        integer(c_size_t) :: count
        integer(c_int) :: status
        status = annulus_edges_broken(self%handle, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            call fit(vertices, 2, count)
            status = annulus_edges_broken(self%handle, count, vertices, count)
            vertices = vertices + 1
        end if
        call check(self%handle, status, stat, errmsg)
    end procedure

    module procedure t1
        integer(c_size_t) :: count
        integer(c_int) :: status
        status = annulus_t1(self%handle, 0_c_size_t, count=count)
        if (status == ANNULUS_OK .or. status == ANNULUS_WRONG_SIZE) then
            call fit(vertices, 4, count)
            status = annulus_t1(self%handle, count, vertices, count)
            vertices = vertices + 1
        end if
        call check(self%handle, status, stat, errmsg)
    end procedure

    module procedure audit
        type(annulus_audit_result) :: empty
        result = empty
        call check(self%handle, annulus_audit(self%handle, result), stat, errmsg)
    end procedure
end submodule meshes_lists
