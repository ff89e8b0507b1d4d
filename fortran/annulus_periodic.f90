! SPDX-License-Identifier: GPL-3.0-or-later
!
! Module annulus_periodic, a part of the module annulus: periodic_mesh. annulus/annulus.h has what each call takes,
! costs and refuses; annulus.f90 has the rules of indices, results and errors.
module annulus_periodic
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_int, c_int32_t, c_loc, c_null_ptr, c_ptr, &
        c_size_t
    use annulus_c
    use annulus_common
    implicit none
    private
    public :: periodic_mesh

    ! A triangulation in a periodic box; as a moving_mesh it is destroyed with its variable and cannot be assigned. A
    ! box is box(d, d), and box(:, k) its vector k. Shifts and offsets, by how many of each vector of the box a point is
    ! moved, are as in C: shifts(:, k) of pair k, offsets(:, i, c) of corner i of cell c, which is at
    ! x(:, vertices(i, c)) + matmul(box, offsets(:, i, c)).
    type :: periodic_mesh
        type(c_ptr) :: handle = c_null_ptr
    contains
        procedure :: create
        procedure :: destroy
        procedure :: move_all
        procedure :: move
        procedure :: insert
        procedure :: remove
        procedure :: recompute_tolerances
        procedure :: dimension => dimension_of
        procedure :: vertex_count
        procedure :: index_bound
        procedure :: is_vertex
        procedure :: box => box_of
        procedure :: points
        procedure :: tolerances
        procedure :: voronoi
        procedure :: voronoi_cells
        procedure :: voronoi_gradient
        procedure :: vertex_of_input
        procedure :: cells
        procedure :: neighbours
        procedure :: voronoi_facets
        procedure :: find_cells
        procedure :: pairs_made
        procedure :: pairs_broken
        procedure :: changed
        procedure :: gone
        procedure :: audit
        procedure :: message
        procedure :: error_vertices
        procedure, private :: refuse_copy
        generic :: assignment(=) => refuse_copy
        final :: finish
    end type

    ! ---- periodic_changes.f90: creating and changing a mesh, what it has -------------------------------------------
    interface
        ! Triangulates the points x(d, n), any image of each, in box(d, d), d = 2 or 3; n may be 0. Options are those of
        ! annulus_options that there are in a box. A mesh that was there before is destroyed if all goes well.
        module subroutine create(self, x, box, strategy, threads, merge_duplicates, report_changes, stat, errmsg)
            class(periodic_mesh), intent(inout) :: self
            real(c_double), intent(in), contiguous :: x(:, :), box(:, :)
            character(*), intent(in), optional :: strategy
            integer, intent(in), optional :: threads
            logical, intent(in), optional :: merge_duplicates, report_changes
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine destroy(self)
            class(periodic_mesh), intent(inout) :: self
        end subroutine
        ! x(d, index_bound): x(:, i) is the new position of vertex i, any image. box: the new one; else it stays.
        module subroutine move_all(self, x, box, report, stat, errmsg)
            class(periodic_mesh), intent(inout) :: self
            real(c_double), intent(in), contiguous :: x(:, :)
            real(c_double), intent(in), contiguous, optional :: box(:, :)
            type(annulus_report), intent(inout), optional :: report
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! x(:, k) is the new position of vertex indices(k).
        module subroutine move(self, indices, x, report, stat, errmsg)
            class(periodic_mesh), intent(inout) :: self
            integer(c_int32_t), intent(in) :: indices(:)
            real(c_double), intent(in), contiguous :: x(:, :)
            type(annulus_report), intent(inout), optional :: report
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! All or none. indices(k): the vertex at x(:, k).
        module subroutine insert(self, x, indices, stat, errmsg)
            class(periodic_mesh), intent(inout) :: self
            real(c_double), intent(in), contiguous :: x(:, :)
            integer(c_int32_t), allocatable, intent(inout), optional :: indices(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! All or none.
        module subroutine remove(self, indices, stat, errmsg)
            class(periodic_mesh), intent(inout) :: self
            integer(c_int32_t), intent(in) :: indices(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine recompute_tolerances(self, report, stat, errmsg)
            class(periodic_mesh), intent(inout) :: self
            type(annulus_report), intent(inout), optional :: report
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! Of a mesh that has not been created these are 0 and .false.
        module integer function dimension_of(self)
            class(periodic_mesh), intent(in) :: self
        end function
        module integer function vertex_count(self)
            class(periodic_mesh), intent(in) :: self
        end function
        module integer function index_bound(self) ! the largest index, in use or free
            class(periodic_mesh), intent(in) :: self
        end function
        module logical function is_vertex(self, index)
            class(periodic_mesh), intent(in) :: self
            integer(c_int32_t), intent(in) :: index
        end function
        ! Why the last call on this mesh failed, in words, in which indices count from 0.
        module function message(self)
            class(periodic_mesh), intent(in) :: self
            character(:), allocatable :: message
        end function
        ! The vertices that the same error concerns.
        module function error_vertices(self)
            class(periodic_mesh), intent(in) :: self
            integer(c_int32_t), allocatable :: error_vertices(:)
        end function
    end interface

    ! ---- periodic_measures.f90: numbers of each vertex, Voronoi cells; NaN at free indices --------------------------
    interface
        ! vectors(d, d): the box as it was given, rounded; vectors(:, k) is its vector k.
        module subroutine box_of(self, vectors, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            real(c_double), allocatable, intent(inout) :: vectors(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! x(d, index_bound): as they were given, rounded.
        module subroutine points(self, x, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            real(c_double), allocatable, intent(inout) :: x(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine tolerances(self, lengths, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            real(c_double), allocatable, intent(inout) :: lengths(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine voronoi(self, volumes, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            real(c_double), allocatable, intent(inout) :: volumes(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! centroids(d, index_bound).
        module subroutine voronoi_cells(self, volumes, surfaces, centroids, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            real(c_double), allocatable, intent(inout), optional, target :: volumes(:), surfaces(:), &
                centroids(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! weights(index_bound); gradient(d, index_bound) of sum(weights * volumes).
        module subroutine voronoi_gradient(self, weights, gradient, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            real(c_double), intent(in), contiguous :: weights(:)
            real(c_double), allocatable, intent(inout) :: gradient(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
    end interface

    ! ---- periodic_lists.f90 -----------------------------------------------------------------------------------------
    interface
        ! indices(i): the vertex of point i of `create`.
        module subroutine vertex_of_input(self, indices, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout) :: indices(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! vertices and neighbours (d + 1, cells); offsets and translations (d, d + 1, cells).
        module subroutine cells(self, vertices, offsets, neighbours, translations, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout), optional, target :: vertices(:, :), &
                offsets(:, :, :), neighbours(:, :), translations(:, :, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! Pairs in both directions, ascending: second(k), moved by shifts(:, k), is a neighbour of first(k).
        ! vectors(d, :).
        module subroutine neighbours(self, first, second, shifts, vectors, distances, areas, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout), optional, target :: first(:), second(:), shifts(:, :)
            real(c_double), allocatable, intent(inout), optional, target :: vectors(:, :), distances(:), areas(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! Facets between cells, each once. centroids(d, :).
        module subroutine voronoi_facets(self, first, second, shifts, measures, centroids, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout), optional, target :: first(:), second(:), shifts(:, :)
            real(c_double), allocatable, intent(inout), optional, target :: measures(:), centroids(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! cells(k): the cell that contains x(:, k), 0 without cells; shifts(:, k): what to add to its offsets.
        module subroutine find_cells(self, x, cells, shifts, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            real(c_double), intent(in), contiguous :: x(:, :)
            integer(c_int32_t), allocatable, intent(inout) :: cells(:)
            integer(c_int32_t), allocatable, intent(inout), optional, target :: shifts(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! The pairs that the last call made and broke, each once; need report_changes.
        module subroutine pairs_made(self, first, second, shifts, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout), optional, target :: first(:), second(:), shifts(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine pairs_broken(self, first, second, shifts, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout), optional, target :: first(:), second(:), shifts(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! The cells that it created and removed, (d + 1, :) and (d, d + 1, :); need report_changes.
        module subroutine changed(self, vertices, offsets, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout), optional, target :: vertices(:, :), offsets(:, :, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine gone(self, vertices, offsets, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout), optional, target :: vertices(:, :), offsets(:, :, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! fault_text(result) is the first fault in words, in which indices count from 0.
        module subroutine audit(self, result, stat, errmsg)
            class(periodic_mesh), intent(in) :: self
            type(annulus_audit_result), intent(inout) :: result
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
    end interface

contains

    subroutine finish(self)
        type(periodic_mesh), intent(inout) :: self
        call annulus_periodic_destroy(self%handle)
    end subroutine

    subroutine refuse_copy(self, other)
        class(periodic_mesh), intent(inout) :: self
        type(periodic_mesh), intent(in) :: other
        if (.not. c_associated(self%handle, other%handle)) error stop 'annulus: a periodic_mesh cannot be assigned'
    end subroutine

    ! The end of a call on the mesh: `check` with its message.
    subroutine finish_call(self, status, stat, errmsg)
        class(periodic_mesh), intent(in) :: self
        integer(c_int), intent(in) :: status
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call check(self%handle, status, stat, errmsg, boxed=.true.)
    end subroutine

    ! One more than the largest index of C: the length of arrays by vertex index.
    integer(c_size_t) function rows_of(self)
        class(periodic_mesh), intent(in) :: self
        rows_of = 0
        if (annulus_periodic_index_bound(self%handle, rows_of) /= ANNULUS_OK) rows_of = 0
    end function

    ! Whether x has a column for each of `columns` points in the dimension of the mesh; else the error is reported.
    logical function fits(self, x, columns, stat, errmsg)
        class(periodic_mesh), intent(in) :: self
        real(c_double), intent(in) :: x(:, :)
        integer, intent(in) :: columns
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        fits = has_shape(x, self%dimension(), columns, c_associated(self%handle), stat, errmsg)
    end function
end module annulus_periodic
