! SPDX-License-Identifier: GPL-3.0-or-later
!
! Of annulus_meshes: creating and changing a mesh, what it has.
submodule (annulus_meshes) meshes_changes
    implicit none

contains

    module procedure create
        type(annulus_options) :: options
        type(c_ptr) :: made
        character(kind=c_char), target :: strategy_c(64), tolerance_c(64)
        integer(c_int) :: status
        if (present(strategy)) then
            strategy_c = to_c(strategy)
            options%strategy = c_loc(strategy_c)
        end if
        if (present(tolerance)) then
            tolerance_c = to_c(tolerance)
            options%tolerance = c_loc(tolerance_c)
        end if
        if (present(threads)) options%threads = int(threads, c_int32_t)
        options%merge_duplicates = in_c(merge_duplicates)
        options%report_changes = in_c(report_changes)
        if (present(seed)) options%seed = seed
        status = annulus_create(made, size(x, 1, c_int), size(x, 2, c_size_t), x, options)
        if (status == ANNULUS_OK) then
            call annulus_destroy(self%handle)
            self%handle = made
        end if
        call check(c_null_ptr, status, stat, errmsg)
    end procedure

    module procedure destroy
        call annulus_destroy(self%handle)
    end procedure

    module procedure move_all
        if (.not. fits(self, x, self%index_bound(), stat, errmsg)) return
        call check(self%handle, annulus_move_all(self%handle, size(x, 2, c_size_t), x, report), stat, errmsg)
    end procedure

    module procedure move
        if (.not. fits(self, x, size(indices), stat, errmsg)) return
        call check(self%handle, annulus_move(self%handle, size(indices, kind=c_size_t), indices - 1, x, report), stat, &
            errmsg)
    end procedure

    module procedure insert
        integer(c_int32_t), allocatable :: made(:)
        integer(c_size_t) :: count
        integer(c_int) :: status
        if (present(inserted)) inserted = 0
        if (.not. fits(self, x, size(x, 2), stat, errmsg)) return
        allocate (made(size(x, 2)), source=-1_c_int32_t)
        count = 0
        status = annulus_insert(self%handle, size(x, 2, c_size_t), x, made, count, report)
        if (present(inserted)) inserted = int(count)
        if (present(indices)) then
            call fit(indices, size(x, 2, c_size_t))
            indices = made + 1
        end if
        call check(self%handle, status, stat, errmsg)
    end procedure

    module procedure remove
        integer(c_size_t) :: count
        integer(c_int) :: status
        count = 0
        status = annulus_remove(self%handle, size(indices, kind=c_size_t), indices - 1, count, report)
        if (present(removed)) removed = int(count)
        call check(self%handle, status, stat, errmsg)
    end procedure

    module procedure recompute_tolerances
        call check(self%handle, annulus_recompute_tolerances(self%handle, report), stat, errmsg)
    end procedure

    module procedure dimension_of
        integer(c_int) :: dimension
        dimension_of = 0
        if (annulus_dimension(self%handle, dimension) == ANNULUS_OK) dimension_of = dimension
    end procedure

    module procedure affine_dimension
        integer(c_int) :: dimension
        affine_dimension = 0
        if (annulus_affine_dimension(self%handle, dimension) == ANNULUS_OK) affine_dimension = dimension
    end procedure

    module procedure vertex_count
        integer(c_size_t) :: count
        vertex_count = 0
        if (annulus_vertex_count(self%handle, count) == ANNULUS_OK) vertex_count = int(count)
    end procedure

    module procedure index_bound
        index_bound = int(rows_of(self))
    end procedure

    module procedure is_vertex
        integer(c_int) :: answer
        is_vertex = .false.
        if (annulus_is_vertex(self%handle, index - 1, answer) == ANNULUS_OK) is_vertex = answer /= 0
    end procedure

    module procedure strategy
        type(c_ptr) :: name
        strategy = ''
        if (annulus_strategy(self%handle, name) == ANNULUS_OK) strategy = from_c(name)
    end procedure

    module procedure message
        message = ''
        if (c_associated(self%handle)) message = message_of(self%handle)
    end procedure

    module procedure error_vertices
        if (c_associated(self%handle)) then
            error_vertices = vertices_of(self%handle)
        else
            allocate (error_vertices(0))
        end if
    end procedure
end submodule meshes_changes
