! SPDX-License-Identifier: GPL-3.0-or-later
!
! Module annulus_meshes, a part of the module annulus: moving_mesh. annulus/annulus.h has what each call takes, costs
! and refuses; annulus.f90 has the rules of indices, results and errors.
module annulus_meshes
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_int, c_int32_t, c_int64_t, c_loc, &
        c_null_ptr, c_ptr, c_size_t
    use annulus_c
    use annulus_common
    implicit none
    private
    public :: moving_mesh

    ! A triangulation. It is destroyed with the variable (those of a main program: by `destroy`, or not at all). It
    ! cannot be assigned: `error stop`. `handle` is for the functions of the module annulus_c.
    type :: moving_mesh
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
        procedure :: affine_dimension
        procedure :: vertex_count
        procedure :: index_bound
        procedure :: is_vertex
        procedure :: strategy
        procedure :: points
        procedure :: tolerances
        procedure :: displacements
        procedure :: voronoi
        procedure :: voronoi_cells
        procedure :: voronoi_gradient
        procedure :: voronoi_facets
        procedure :: vertex_of_input
        procedure :: cells
        procedure :: neighbours
        procedure :: neighbour_lists
        procedure :: convex_hull
        procedure :: find_cells
        procedure :: changed
        procedure :: gone
        procedure :: edges_made
        procedure :: edges_broken
        procedure :: t1
        procedure :: audit
        procedure :: message
        procedure :: error_vertices
        procedure, private :: refuse_copy
        generic :: assignment(=) => refuse_copy
        final :: finish
    end type

    ! ---- meshes_changes.f90: creating and changing a mesh, what it has ----------------------------------------------
    interface
        ! Triangulates the points x(d, n), d = 2 or 3; n may be 0. Options are those of annulus_options. A mesh that was
        ! there before is destroyed if all goes well.
        module subroutine create(self, x, strategy, tolerance, threads, merge_duplicates, report_changes, seed, stat, &
                errmsg)
            class(moving_mesh), intent(inout) :: self
            real(c_double), intent(in), contiguous :: x(:, :)
            character(*), intent(in), optional :: strategy, tolerance
            integer, intent(in), optional :: threads
            logical, intent(in), optional :: merge_duplicates, report_changes
            integer(c_int64_t), intent(in), optional :: seed
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine destroy(self)
            class(moving_mesh), intent(inout) :: self
        end subroutine
        ! x(d, index_bound): x(:, i) is the new position of vertex i.
        module subroutine move_all(self, x, report, stat, errmsg)
            class(moving_mesh), intent(inout) :: self
            real(c_double), intent(in), contiguous :: x(:, :)
            type(annulus_report), intent(inout), optional :: report
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! x(:, k) is the new position of vertex indices(k).
        module subroutine move(self, indices, x, report, stat, errmsg)
            class(moving_mesh), intent(inout) :: self
            integer(c_int32_t), intent(in) :: indices(:)
            real(c_double), intent(in), contiguous :: x(:, :)
            type(annulus_report), intent(inout), optional :: report
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! indices(k): the vertex at x(:, k). inserted: how many there are; after an error those before the one refused.
        module subroutine insert(self, x, indices, inserted, report, stat, errmsg)
            class(moving_mesh), intent(inout) :: self
            real(c_double), intent(in), contiguous :: x(:, :)
            integer(c_int32_t), allocatable, intent(inout), optional :: indices(:)
            integer, intent(out), optional :: inserted
            type(annulus_report), intent(inout), optional :: report
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine remove(self, indices, removed, report, stat, errmsg)
            class(moving_mesh), intent(inout) :: self
            integer(c_int32_t), intent(in) :: indices(:)
            integer, intent(out), optional :: removed
            type(annulus_report), intent(inout), optional :: report
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine recompute_tolerances(self, report, stat, errmsg)
            class(moving_mesh), intent(inout) :: self
            type(annulus_report), intent(inout), optional :: report
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! Of a mesh that has not been created these are 0, .false. and ''.
        module integer function dimension_of(self)
            class(moving_mesh), intent(in) :: self
        end function
        module integer function affine_dimension(self)
            class(moving_mesh), intent(in) :: self
        end function
        module integer function vertex_count(self)
            class(moving_mesh), intent(in) :: self
        end function
        module integer function index_bound(self) ! the largest index, in use or free
            class(moving_mesh), intent(in) :: self
        end function
        module logical function is_vertex(self, index)
            class(moving_mesh), intent(in) :: self
            integer(c_int32_t), intent(in) :: index
        end function
        module function strategy(self)
            class(moving_mesh), intent(in) :: self
            character(:), allocatable :: strategy
        end function
        ! Why the last call on this mesh failed, in words, in which indices count from 0.
        module function message(self)
            class(moving_mesh), intent(in) :: self
            character(:), allocatable :: message
        end function
        ! The vertices that the same error concerns.
        module function error_vertices(self)
            class(moving_mesh), intent(in) :: self
            integer(c_int32_t), allocatable :: error_vertices(:)
        end function
    end interface

    ! ---- meshes_measures.f90: numbers of each vertex, Voronoi cells; NaN at free indices ---------------------------
    interface
        module subroutine points(self, x, stat, errmsg) ! x(d, index_bound)
            class(moving_mesh), intent(in) :: self
            real(c_double), allocatable, intent(inout) :: x(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine tolerances(self, lengths, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            real(c_double), allocatable, intent(inout) :: lengths(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine displacements(self, lengths, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            real(c_double), allocatable, intent(inout) :: lengths(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine voronoi(self, volumes, neighbour_counts, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            real(c_double), allocatable, intent(inout), optional, target :: volumes(:)
            integer(c_int32_t), allocatable, intent(inout), optional, target :: neighbour_counts(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! centroids(d, index_bound). With lower(d) and upper(d): cells are intersected with this box.
        module subroutine voronoi_cells(self, volumes, centroids, lower, upper, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            real(c_double), allocatable, intent(inout), optional, target :: volumes(:), centroids(:, :)
            real(c_double), intent(in), contiguous, optional :: lower(:), upper(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! weights(index_bound); gradient(d, index_bound) of sum(weights * volumes).
        module subroutine voronoi_gradient(self, weights, gradient, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            real(c_double), intent(in), contiguous :: weights(:)
            real(c_double), allocatable, intent(inout) :: gradient(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! In the order of the vertices of neighbour_lists. centroids(d, :).
        module subroutine voronoi_facets(self, measures, centroids, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            real(c_double), allocatable, intent(inout), optional, target :: measures(:), centroids(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
    end interface

    ! ---- meshes_lists.f90 -------------------------------------------------------------------------------------------
    interface
        ! indices(i): the vertex of point i of `create`.
        module subroutine vertex_of_input(self, indices, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout) :: indices(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! Both (d + 1, cells): neighbours(i, c) is the cell opposite to vertices(i, c), 0 outside the hull.
        module subroutine cells(self, vertices, neighbours, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout), optional, target :: vertices(:, :), neighbours(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine neighbours(self, vertex, vertices, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            integer(c_int32_t), intent(in) :: vertex
            integer(c_int32_t), allocatable, intent(inout) :: vertices(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! The neighbours of vertex v are vertices(begin(v):begin(v + 1) - 1).
        module subroutine neighbour_lists(self, begin, vertices, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout) :: begin(:), vertices(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine convex_hull(self, vertices, stat, errmsg) ! vertices(d, facets)
            class(moving_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout) :: vertices(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! cells(k): a cell that contains x(:, k), 0 outside the hull.
        module subroutine find_cells(self, x, cells, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            real(c_double), intent(in), contiguous :: x(:, :)
            integer(c_int32_t), allocatable, intent(inout) :: cells(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! vertices(d + 1, :) of the cells that the last call created, 0 at infinity; needs report_changes.
        module subroutine changed(self, vertices, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout) :: vertices(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! The same of the cells that it removed.
        module subroutine gone(self, vertices, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout) :: vertices(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! vertices(2, :): the pairs of vertices that the last call made neighbours, and those that are neighbours no
        ! longer, the smaller index first, ascending; need report_changes.
        module subroutine edges_made(self, vertices, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout) :: vertices(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine edges_broken(self, vertices, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout) :: vertices(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! vertices(4, :): the T1 transitions of the last call in 2D. The first two vertices of each were neighbours
        ! before, the other two are since; needs report_changes.
        module subroutine t1(self, vertices, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            integer(c_int32_t), allocatable, intent(inout) :: vertices(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! fault_text(result) is the first fault in words, in which indices count from 0.
        module subroutine audit(self, result, stat, errmsg)
            class(moving_mesh), intent(in) :: self
            type(annulus_audit_result), intent(inout) :: result
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
    end interface

contains

    subroutine finish(self)
        type(moving_mesh), intent(inout) :: self
        call annulus_destroy(self%handle)
    end subroutine

    subroutine refuse_copy(self, other)
        class(moving_mesh), intent(inout) :: self
        type(moving_mesh), intent(in) :: other
        if (.not. c_associated(self%handle, other%handle)) error stop 'annulus: a moving_mesh cannot be assigned'
    end subroutine

    ! One more than the largest index of C: the length of arrays by vertex index.
    integer(c_size_t) function rows_of(self)
        class(moving_mesh), intent(in) :: self
        rows_of = 0
        if (annulus_index_bound(self%handle, rows_of) /= ANNULUS_OK) rows_of = 0
    end function

    ! Whether x has a column for each of `columns` points in the dimension of the mesh; else the error is reported.
    logical function fits(self, x, columns, stat, errmsg)
        class(moving_mesh), intent(in) :: self
        real(c_double), intent(in) :: x(:, :)
        integer, intent(in) :: columns
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        fits = has_shape(x, self%dimension(), columns, c_associated(self%handle), stat, errmsg)
    end function
end module annulus_meshes
