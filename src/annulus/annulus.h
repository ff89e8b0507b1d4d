// SPDX-License-Identifier: GPL-3.0-or-later
//
// annulus for C, and for whatever calls C: Fortran, Julia, Rust. A Delaunay 2D triangulation or of space
// that is kept right while its vertices move: Moving_mesh of the C++ library behind a handle, arrays in and arrays
// out. docs/c.md is the guide.
//
// Arrays belong to the caller. Coordinates are interleaved doubles, 2 or 3 a point, in the caller's unit of length;
// indices are int32_t; counts are of points, vertices or cells, never of numbers. A pointer that is NULL is refused,
// unless it is said to be optional or the count of what it points to is 0. Buffers that are too small are refused,
// with the count that is needed; nothing is written then.
//
// Every function that can fail returns ANNULUS_OK or another annulus_status, and what went wrong in words is in
// annulus_message. The mesh is then as it was before the call, and can be used, unless the function says what else
// holds.
//
// Threads: functions that take a `const annulus_mesh *` may run at once on one mesh, while no other does; meshes are
// independent of one another. No callback, no signal, no global state but a message a thread. Do not cancel a thread
// within a call.
//
// Floating-point environment: rounding to nearest, subnormals not flushed, else ANNULUS_ENVIRONMENT. Exceptions may
// trap in the program (-ffpe-trap): during a call they do not, in the calling thread, and the flags are afterwards as
// they were before.
#pragma once

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define ANNULUS_API __attribute__((visibility("default")))
#else
#define ANNULUS_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

// Counts what was added to this file. Nothing is ever taken away or changed within one major version of the library.
#define ANNULUS_INTERFACE 2

typedef enum annulus_status {
    ANNULUS_OK = 0,
    ANNULUS_NULL_POINTER = 1,     // a pointer is NULL that must not be
    ANNULUS_USAGE = 2,            // invalid dimension, name, option or size of a struct
    ANNULUS_WRONG_SIZE = 3,       // not one point for every index; a buffer that is too small
    ANNULUS_NOT_FINITE = 4,       // a coordinate is NaN or infinite
    ANNULUS_OUT_OF_DOMAIN = 5,    // a coordinate is larger than 2^500 in magnitude
    ANNULUS_DUPLICATE_POINT = 6,  // two vertices would be at one place
    ANNULUS_UNKNOWN_VERTEX = 7,   // an index that names no vertex: free, or outside
    ANNULUS_ENVIRONMENT = 8,      // the floating-point environment is not the one the proofs assume
    ANNULUS_TOO_LARGE = 9,        // more vertices or cells than indices can name
    ANNULUS_NO_MEMORY = 10,
    ANNULUS_NO_TRIANGULATION = 11,  // Voronoi measures: the cells are not positive (tolerances that are not certified)
    ANNULUS_INTERNAL = 12           // a bug in the library; please report it
} annulus_status;

// Opaque handle of a triangulation.
typedef struct annulus_mesh annulus_mesh;

// How a mesh is kept right. Make all of it 0, which stands for the default everywhere, and `size`
// sizeof(annulus_options):
//     annulus_options options = {0}; options.size = sizeof options;
// Later versions may append members; what a caller's `size` does not reach has its default. Strings are read in
// annulus_create and not kept.
typedef struct annulus_options {
    size_t size;
    // "auto" (default), "tolerances", "tolerances-each", "in-place", "paper", "paper-hybrid", "relocate",
    // "relocate-flips", "rebuild"
    const char* strategy;
    const char* tolerance;     // "certified" (default); with "paper" and "paper-hybrid" also "paper", "floating"
    const char* second_look;   // NULL or "off": there are none any longer
    int32_t threads;           // default 1; results do not depend on it. Negative: ANNULUS_USAGE
    int32_t merge_duplicates;  // not 0: equal points become one vertex instead of ANNULUS_DUPLICATE_POINT
    int32_t report_changes;    // not 0: annulus_changed lists cells
    int32_t reserved;          // 0
    uint64_t seed;             // of the sample that "paper-hybrid" draws
} annulus_options;

// What a call did, all counts: of vertices, certificates, flips, time steps. Set `size` to sizeof(annulus_report)
// before; what it does not reach is not written.
typedef struct annulus_report {
    size_t size;
    uint64_t asked;             // vertices that were asked to move; the next five add up to it
    uint64_t within_tolerance;  // proved right by the tolerance alone, or at rest
    uint64_t kept_in_place;     // evaluated, and all certificates hold
    uint64_t flipped;           // a certificate was violated, and flips repaired it
    uint64_t reinserted;        // taken out and put back in
    uint64_t rebuilt;           // the triangulation was rebuilt
    uint64_t evaluated;         // certificates evaluated
    uint64_t by_filter;         // and the stage that decided them
    uint64_t by_intervals;
    uint64_t by_integers;
    uint64_t flips;
    uint64_t tolerance_steps;  // time steps that began with tolerances,
    uint64_t sign_steps;       // with the signs of everything,
    uint64_t rebuild_steps;    // with a rebuild
    uint64_t changed;          // cells that annulus_changed lists
    double cost;               // what it cost, in cells looked at
} annulus_report;

// The verdict of an audit; `size` as above.
typedef struct annulus_audit_result {
    size_t size;
    // 1: shown exactly that the cells are a Delaunay triangulation of the vertices where they are now. 0: not
    int32_t delaunay;
    int32_t reserved;
    uint64_t inverted_cells;
    uint64_t violated_facets;
    uint64_t concave_ridges;
    uint64_t topological_faults;
    uint64_t degenerate_facets;  // no fault: d + 2 cospherical points
    // In words, vertices by their index; cut where they do not fit; empty when there is none.
    char first_fault[232];
} annulus_audit_result;

// ---- A mesh, and what went wrong ----------------------------------------------------------------

// Triangulates `points` points (0 is fine: coordinates may be NULL then) of the plane (dimension 2) or of space (3).
// options: optional. *mesh is a new handle, or NULL after an error. Vertex i is point i unless duplicates are merged
// (annulus_vertex_of_input). O(n log n).
// Errors: USAGE, NOT_FINITE, OUT_OF_DOMAIN, DUPLICATE_POINT, TOO_LARGE, ENVIRONMENT, NO_MEMORY; here and everywhere
// NULL_POINTER.
ANNULUS_API int annulus_create(annulus_mesh** mesh, int dimension, size_t points, const double* coordinates,
                               const annulus_options* options);

// Frees a mesh and makes *mesh NULL, so that doing it twice does no harm. NULL, and a pointer to NULL, are fine.
// Copies of the handle dangle.
ANNULUS_API void annulus_destroy(annulus_mesh** mesh);

// Writes the message of the last call on this mesh that failed, whichever thread made it; for NULL of the last call
// of this thread that failed without a mesh, annulus_create above all. Cut to `capacity` bytes, the last one 0;
// buffer may be NULL when capacity is 0. Returns the length of the whole message, 0 when there has been no error. No
// error itself.
ANNULUS_API size_t annulus_message(const annulus_mesh* mesh, char* buffer, size_t capacity);

// Writes the indices of the vertices that the same message is about and returns how many they are, 0 to 2. After
// DUPLICATE_POINT both, the smaller one first: of annulus_create numbers of points, of annulus_insert the one vertex
// that is there already. After UNKNOWN_VERTEX, NOT_FINITE and OUT_OF_DOMAIN the vertex or point that is refused. No
// error itself.
ANNULUS_API size_t annulus_message_vertices(const annulus_mesh* mesh, int32_t vertices[2]);

// "duplicate_point" for ANNULUS_DUPLICATE_POINT, and so on; "unknown status" for what is none. Never NULL.
ANNULUS_API const char* annulus_status_name(int status);

// The version of the library, "0.1.0", and the ANNULUS_INTERFACE that it was built with.
ANNULUS_API const char* annulus_version(void);
ANNULUS_API int annulus_interface(void);

// ---- What changes it. report: optional everywhere --------------------------------------------------

// Moves every vertex: point i is the new position of vertex i; what stands at free indices is ignored. `points` is
// annulus_index_bound. O(n) with a small constant when few vertices leave their tolerance.
// Errors: WRONG_SIZE, NOT_FINITE, OUT_OF_DOMAIN, DUPLICATE_POINT, TOO_LARGE, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_move_all(annulus_mesh* mesh, size_t points, const double* coordinates, annulus_report* report);

// Moves some vertices, all at once: indices[k] to point k; the last holds for an index that is named twice. While
// they are fewer than one in 64, under the filters, it costs as much as their single moves, whatever the size of the
// mesh. The same errors and UNKNOWN_VERTEX.
ANNULUS_API int annulus_move(annulus_mesh* mesh, size_t count, const int32_t* indices, const double* coordinates,
                             annulus_report* report);

// Inserts vertices one after another and writes their indices: those freed last, then new ones. Coordinates are
// looked at first. When a later point is refused (DUPLICATE_POINT, TOO_LARGE, NO_MEMORY), those before it stay:
// *inserted, optional, says how many they are, 0 when nothing was done. Ten to twenty microseconds each in 2D
// (up to a million vertices), some forty in 3D (up to 100,000); the first after a construction copies arrays, O(n).
// While all points are in a plane or on a line each rebuilds everything.
// Errors: NOT_FINITE, OUT_OF_DOMAIN, DUPLICATE_POINT, TOO_LARGE, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_insert(annulus_mesh* mesh, size_t count, const double* coordinates, int32_t* indices,
                               size_t* inserted, annulus_report* report);

// Removes vertices one after another; their indices become free. Indices are looked at first; after NO_MEMORY
// *removed, optional, says how many have gone, and the next one may have gone, too (annulus_is_vertex). Errors:
// UNKNOWN_VERTEX (named twice, too), ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_remove(annulus_mesh* mesh, size_t count, const int32_t* indices, size_t* removed,
                               annulus_report* report);

// Makes every tolerance fresh, measured from where the vertices are. O(n). Errors: DUPLICATE_POINT, ENVIRONMENT,
// NO_MEMORY.
ANNULUS_API int annulus_recompute_tolerances(annulus_mesh* mesh, annulus_report* report);

// ---- What it says. O(1) ----------------------------------------------------------------------------

ANNULUS_API int annulus_dimension(const annulus_mesh* mesh, int* dimension);  // 2 or 3, of annulus_create
ANNULUS_API int annulus_affine_dimension(const annulus_mesh* mesh,
                                         int* dimension);  // less when the points are flat; -1: none
ANNULUS_API int annulus_vertex_count(const annulus_mesh* mesh, size_t* count);
// One more than the largest index in use or free: the size of every array by vertex index.
ANNULUS_API int annulus_index_bound(const annulus_mesh* mesh, size_t* bound);
// 1 for a vertex, 0 for a free index and for what is outside.
ANNULUS_API int annulus_is_vertex(const annulus_mesh* mesh, int32_t index, int* answer);
// The strategy in force: that of the options, except that "paper-hybrid" becomes "paper" when it switches. A constant
// string.
ANNULUS_API int annulus_strategy(const annulus_mesh* mesh, const char** name);

// ---- Arrays by vertex index. `capacity` is of vertices, at least annulus_index_bound, else WRONG_SIZE. O(n) -------

// NaN at free indices.
ANNULUS_API int annulus_points(const annulus_mesh* mesh, size_t capacity, double* coordinates);
// How far a vertex may be from where it was when its tolerance was computed, while every other one is within its own:
// a certified lower bound, unless options say otherwise. 0 at free indices and where all points are in a plane or
// on a line. Errors: ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_tolerances(const annulus_mesh* mesh, size_t capacity, double* lengths);
// How far it is from there, rounded up. 0 at free indices. Errors: as above.
ANNULUS_API int annulus_displacements(const annulus_mesh* mesh, size_t capacity, double* lengths);
// Areas (dimension 2) or volumes (3) of Voronoi cells, each with a relative error of at most 2^-33, whatever the
// points, and how many Voronoi cells touch each: the neighbours in the triangulation. Infinity where the cell is
// unbounded, at vertices of the hull; NaN and 0 at free indices. Either array may be NULL.
// Saturates at the largest double; one below the smallest normal double has an absolute error of 2^-1074 besides. A
// microsecond a vertex.
// Errors: NO_TRIANGULATION, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_voronoi(const annulus_mesh* mesh, size_t capacity, double* volumes, int32_t* neighbour_counts);

// ---- Lists. Ask with capacity 0 and NULL for the count, then call again; *count is right after WRONG_SIZE, too -----

// The vertex of every point that was given to annulus_create: other than 0, 1, 2 .. only where duplicates were merged.
ANNULUS_API int annulus_vertex_of_input(const annulus_mesh* mesh, size_t capacity, int32_t* indices, size_t* count);
// Finite cells, dimension + 1 numbers each in both arrays; either may be NULL. vertices: positively oriented (
// in 2D counter-clockwise; in 3D det(b - a, c - a, e - a) > 0), padded with -2 where all points are in a plane or
// on a line. neighbours: the cell opposite to each vertex, -1 beyond the hull. Cells are counted 0, 1, 2 .. until the
// next call that changes the mesh. They are kept until then for the next caller: 24 or 32 bytes a cell. O(n).
// Errors: WRONG_SIZE, NO_MEMORY.
ANNULUS_API int annulus_cells(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, int32_t* neighbours,
                              size_t* count);
// With options.report_changes: the cells that the last call that changed the mesh made, as vertices, -1 for the one
// at infinity; a call that is several (annulus_insert, annulus_remove) may name one that is gone again. All finite
// ones where all points are, or were, in a plane or on a line. O(list).
// Errors: WRONG_SIZE; USAGE without that option.
ANNULUS_API int annulus_changed(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, size_t* count);

// The exact verdict, in integers, trusting nothing of the above. Some microseconds a vertex. Errors: USAGE, NO_MEMORY.
ANNULUS_API int annulus_audit(const annulus_mesh* mesh, annulus_audit_result* result);

#ifdef __cplusplus
}  // extern "C"
#endif
