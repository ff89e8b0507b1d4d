! SPDX-License-Identifier: GPL-3.0-or-later
!
! Module annulus: Delaunay triangulations in 2D and 3D that are kept exactly right while their vertices move, for
! Fortran 2018. docs/fortran.md is the guide, annulus/annulus.h has what each call takes, costs and refuses.
!
!     type(moving_mesh) :: mesh
!     call mesh%create(x)                 ! real(c_double) :: x(2, n) or x(3, n)
!     call mesh%move_all(x)
!     call mesh%voronoi(volumes)
!
! type(periodic_mesh) is the same in a periodic box: call mesh%create(x, box).
!
! Indices: every number of a vertex, a cell or a place in a list is one more than in C. So vertices and cells count from
! 1, 0 is no vertex, no cell or the vertex at infinity, and -1 is the padding of cells in a plane or on a line.
!
! Results are allocatable arrays; they are allocated again only where their size or shape is not the right one.
!
! Errors: stat and errmsg are as in `allocate`. stat is a status of annulus.h, ANNULUS_OK = 0 if all is well; without
! stat an error ends the program (error stop). After an error the mesh is as it was before the call, unless annulus.h
! says otherwise, and the values of results are undefined.
module annulus
    use annulus_types
    use annulus_common, only: fault_text, library_message, library_version, library_vertices, status_name
    use annulus_meshes, only: moving_mesh
    use annulus_periodic, only: periodic_mesh
    use annulus_predicates, only: audit_cells, in_circle, in_sphere, orient_2d, orient_3d
    implicit none
end module annulus
