! SPDX-License-Identifier: GPL-3.0-or-later
!
! Module annulus_types: the constants and structs of annulus.h, which documents them. The modules annulus_c and annulus
! have them, too.
module annulus_types
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_int32_t, c_int64_t, c_null_ptr, c_ptr, c_size_t
    implicit none
    private :: c_char, c_double, c_int, c_int32_t, c_int64_t, c_null_ptr, c_ptr, c_size_t

    ! ANNULUS_INTERFACE of the header that this file was written for; the function of that name returns the library's.
    integer(c_int), parameter :: ANNULUS_INTERFACE_OF_MODULE = 8

    enum, bind(c) ! annulus_status
        enumerator :: ANNULUS_OK = 0
        enumerator :: ANNULUS_NULL_POINTER = 1
        enumerator :: ANNULUS_USAGE = 2
        enumerator :: ANNULUS_WRONG_SIZE = 3
        enumerator :: ANNULUS_NOT_FINITE = 4
        enumerator :: ANNULUS_OUT_OF_DOMAIN = 5
        enumerator :: ANNULUS_DUPLICATE_POINT = 6
        enumerator :: ANNULUS_UNKNOWN_VERTEX = 7
        enumerator :: ANNULUS_ENVIRONMENT = 8
        enumerator :: ANNULUS_TOO_LARGE = 9
        enumerator :: ANNULUS_NO_MEMORY = 10
        enumerator :: ANNULUS_NO_TRIANGULATION = 11
        enumerator :: ANNULUS_INTERNAL = 12
    end enum

    enum, bind(c) ! annulus_fault_kind
        enumerator :: ANNULUS_UNKNOWN_POINT = 0
        enumerator :: ANNULUS_FLAT_CELL = 1
        enumerator :: ANNULUS_OVERLAP = 2
        enumerator :: ANNULUS_UNUSED_POINT = 3
        enumerator :: ANNULUS_EQUAL_POINTS = 4
        enumerator :: ANNULUS_NOT_DELAUNAY = 5
        enumerator :: ANNULUS_HULL_NOT_CONVEX = 6
        enumerator :: ANNULUS_HULL_BROKEN = 7
        enumerator :: ANNULUS_NOT_FLAT = 8
    end enum

    ! Structs. Each `size` is already what C's sizeof would be.
    type, bind(c) :: annulus_options
        integer(c_size_t) :: size = 56
        type(c_ptr) :: strategy = c_null_ptr
        type(c_ptr) :: tolerance = c_null_ptr
        type(c_ptr) :: second_look = c_null_ptr
        integer(c_int32_t) :: threads = 0
        integer(c_int32_t) :: merge_duplicates = 0
        integer(c_int32_t) :: report_changes = 0
        integer(c_int32_t) :: reserved = 0
        integer(c_int64_t) :: seed = 0
    end type

    type, bind(c) :: annulus_report
        integer(c_size_t) :: size = 136
        integer(c_int64_t) :: asked = 0
        integer(c_int64_t) :: within_tolerance = 0
        integer(c_int64_t) :: kept_in_place = 0
        integer(c_int64_t) :: flipped = 0
        integer(c_int64_t) :: reinserted = 0
        integer(c_int64_t) :: rebuilt = 0
        integer(c_int64_t) :: evaluated = 0
        integer(c_int64_t) :: by_filter = 0
        integer(c_int64_t) :: by_intervals = 0
        integer(c_int64_t) :: by_integers = 0
        integer(c_int64_t) :: flips = 0
        integer(c_int64_t) :: tolerance_steps = 0
        integer(c_int64_t) :: sign_steps = 0
        integer(c_int64_t) :: rebuild_steps = 0
        integer(c_int64_t) :: changed = 0
        real(c_double) :: cost = 0
    end type

    type, bind(c) :: annulus_audit_result
        integer(c_size_t) :: size = 288
        integer(c_int32_t) :: delaunay = 0
        integer(c_int32_t) :: reserved = 0
        integer(c_int64_t) :: inverted_cells = 0
        integer(c_int64_t) :: violated_facets = 0
        integer(c_int64_t) :: concave_ridges = 0
        integer(c_int64_t) :: topological_faults = 0
        integer(c_int64_t) :: degenerate_facets = 0
        character(kind=c_char) :: first_fault(232) = achar(0)
    end type

    type, bind(c) :: annulus_sign
        real(c_double) :: tolerance
        real(c_double) :: width_lower
        real(c_double) :: width_upper
        real(c_double) :: theta
        integer(c_int32_t) :: sign
        integer(c_int32_t) :: stage
    end type

    type, bind(c) :: annulus_fault
        integer(c_int64_t) :: cells(2)
        integer(c_int32_t) :: vertices(5)
        integer(c_int32_t) :: kind
    end type
end module annulus_types
