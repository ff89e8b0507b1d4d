// SPDX-License-Identifier: GPL-3.0-or-later
//
// The C interface of annulus, also for languages that call C: Fortran, Julia, Rust. A Delaunay triangulation in 2D or
// 3D that is kept right while its vertices move: the C++ class Moving_mesh behind an opaque handle, with plain arrays
// in and out. docs/c.md is the guide.
//
// Arrays belong to the caller. Coordinates are interleaved doubles, 2 or 3 per point, in the caller's unit of length.
// Indices are int32_t. Counts are of points, vertices or cells, never of single numbers. A NULL pointer is refused,
// unless it is documented as optional or the count of what it points to is 0. A buffer that is too small is refused:
// the call reports the count that is needed and writes nothing.
//
// Every function that can fail returns ANNULUS_OK or another annulus_status; annulus_message returns the reason in
// words. After a failed call the mesh is as it was before the call, and can still be used, unless the description of
// the function says otherwise.
//
// Threads: functions that take a `const annulus_mesh *` may run at the same time on one mesh, while no other function
// does. Meshes are independent of one another. There are no callbacks, no signals and no global state, except one
// message per thread. Do not cancel a thread within a call.
//
// Floating-point environment: rounding to nearest and subnormals not flushed, otherwise ANNULUS_ENVIRONMENT. The
// program may enable traps for floating-point exceptions (-ffpe-trap): they are disabled in the calling thread during
// a call, and the flags are restored after it.
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

// Grows by one with each addition to this file. Within one major version of the library nothing is removed or changed.
#define ANNULUS_INTERFACE 8

typedef enum annulus_status {
    ANNULUS_OK = 0,
    ANNULUS_NULL_POINTER = 1,     // a pointer that must not be NULL is NULL
    ANNULUS_USAGE = 2,            // invalid dimension, name, option or size of a struct
    ANNULUS_WRONG_SIZE = 3,       // not one point for every index, or a buffer that is too small
    ANNULUS_NOT_FINITE = 4,       // a coordinate is NaN or infinite
    ANNULUS_OUT_OF_DOMAIN = 5,    // a coordinate is larger than 2^500 in magnitude
    ANNULUS_DUPLICATE_POINT = 6,  // two vertices would be at one position
    ANNULUS_UNKNOWN_VERTEX = 7,   // an index that is not a vertex: free, or out of range
    ANNULUS_ENVIRONMENT = 8,      // the floating-point environment is not the one that the proofs assume
    ANNULUS_TOO_LARGE = 9,        // more vertices or cells than there are indices
    ANNULUS_NO_MEMORY = 10,
    ANNULUS_NO_TRIANGULATION = 11,  // Voronoi measures: a cell is not positive (tolerances that are not certified)
    ANNULUS_INTERNAL = 12           // a bug in the library; please report it
} annulus_status;

// Opaque handles of a triangulation, and of one in a periodic box.
typedef struct annulus_mesh annulus_mesh;
typedef struct annulus_periodic annulus_periodic;

// How a mesh is kept right. Set every member to 0, which means the default, and `size` to sizeof(annulus_options):
//     annulus_options options = {0}; options.size = sizeof options;
// Later versions may append members; members beyond the caller's `size` have their defaults. annulus_create reads the
// strings and does not keep them.
typedef struct annulus_options {
    size_t size;
    // "auto" (default), "tolerances", "tolerances-each", "in-place", "paper", "paper-hybrid", "relocate",
    // "relocate-flips", "rebuild"
    const char* strategy;
    const char* tolerance;     // "certified" (default); with "paper" and "paper-hybrid" also "paper", "floating"
    const char* second_look;   // must be NULL or "off"; has no effect
    int32_t threads;           // 1 or more; results do not depend on it. 0, like any member, is the default, here 1
    int32_t merge_duplicates;  // not 0: duplicate points become one vertex instead of ANNULUS_DUPLICATE_POINT
    int32_t report_changes;    // not 0: annulus_changed lists cells, annulus_gone, too. By default they do not
    int32_t reserved;          // 0
    uint64_t seed;             // of the sample that "paper-hybrid" draws
} annulus_options;

// What a call changed: what became of the vertices, `asked` to `rebuilt`, and `changed`. The other members are
// statistics of what the call cost. They stay where they are, but are no stable interface: a later version of the
// library may count otherwise, or write 0. Set `size` to sizeof(annulus_report) before the call; members beyond `size`
// are not written.
typedef struct annulus_report {
    size_t size;
    uint64_t asked;             // vertices that the call was to move; the next five add up to it
    uint64_t within_tolerance;  // proved right by the tolerance alone, or at rest
    uint64_t kept_in_place;     // certificates were evaluated, and all hold
    uint64_t flipped;           // a certificate was violated, and flips repaired it
    uint64_t reinserted;        // removed and inserted again
    uint64_t rebuilt;           // the triangulation was rebuilt
    uint64_t evaluated;         // certificates evaluated
    uint64_t by_filter;         // of these, decided by the filter,
    uint64_t by_intervals;      // by interval arithmetic,
    uint64_t by_integers;       // by exact arithmetic in integers
    uint64_t flips;
    uint64_t tolerance_steps;  // time steps that began with tolerances,
    uint64_t sign_steps;       // with the signs of all certificates,
    uint64_t rebuild_steps;    // with a rebuild
    uint64_t changed;          // cells that annulus_changed lists
    double cost;               // cost of the call, in cells tested
} annulus_report;

// The result of an audit; set `size` as above.
typedef struct annulus_audit_result {
    size_t size;
    // 1: proved exactly that the cells are a Delaunay triangulation of the vertices at their current positions; else 0
    int32_t delaunay;
    int32_t reserved;
    uint64_t inverted_cells;
    uint64_t violated_facets;
    uint64_t concave_ridges;
    uint64_t topological_faults;
    uint64_t degenerate_facets;  // not a fault: d + 2 cospherical points
    // In words, with vertex indices. Cut if it does not fit; empty if there is no fault.
    char first_fault[232];
} annulus_audit_result;

// The sign of a determinant of points, and how firmly it holds. Lengths are in the unit of the points.
typedef struct annulus_sign {
    double tolerance;    // while every point is less than this from where it is here, the sign stays; a lower bound
    double width_lower;  // the ends of an enclosure of the width of the standard annulus, for orientations of the
    double width_upper;  // narrowest slab that holds the points; 0 if the sign is 0
    double theta;        // angle of numerical stability in radians, 0 to pi/2; NaN for orientations
    int32_t sign;        // -1, 0, 1: exact
    int32_t stage;       // that decided the sign: 0 filter, 1 intervals, 2 integers
} annulus_sign;

// What is wrong with a triangulation.
typedef enum annulus_fault_kind {
    ANNULUS_UNKNOWN_POINT = 0,    // a cell names a point that is not there; nothing further is examined
    ANNULUS_FLAT_CELL = 1,        // the corners of a cell are on a line, or in a plane
    ANNULUS_OVERLAP = 2,          // two cells on one side of a facet
    ANNULUS_UNUSED_POINT = 3,     // a point in no cell
    ANNULUS_EQUAL_POINTS = 4,     // two points at one position
    ANNULUS_NOT_DELAUNAY = 5,     // the sphere of a cell holds the opposite vertex of its neighbour strictly inside
    ANNULUS_HULL_NOT_CONVEX = 6,  // the cells do not fill the convex hull
    ANNULUS_HULL_BROKEN = 7,      // the border of the cells is not one closed surface that winds once
    ANNULUS_NOT_FLAT = 8          // cells of a lower dimension, and a point that is not in their plane or line
} annulus_fault_kind;

// A fault, by the numbers of points and cells.
typedef struct annulus_fault {
    int64_t cells[2];     // the cells concerned, or -1
    int32_t vertices[5];  // the points concerned, or -2; of an overlap the facet and the opposite corners of the cells
    int32_t kind;         // an annulus_fault_kind
} annulus_fault;

// ---- Creating and destroying a mesh, error messages ---------------------------------------------

// Triangulates `points` points in 2D (dimension 2) or 3D (dimension 3). `points` may be 0, and `coordinates` NULL then.
// options: optional. *mesh is a new handle, or NULL after an error. Vertex i is point i unless duplicate points are
// merged (annulus_vertex_of_input). O(n log n).
// Errors: USAGE, NOT_FINITE, OUT_OF_DOMAIN, DUPLICATE_POINT, TOO_LARGE, ENVIRONMENT, NO_MEMORY; here and everywhere
// NULL_POINTER.
ANNULUS_API int annulus_create(annulus_mesh** mesh, int dimension, size_t points, const double* coordinates,
                               const annulus_options* options);

// Frees a mesh and sets *mesh to NULL, so that a second call does no harm. NULL and a pointer to NULL are allowed.
// Copies of the handle dangle.
ANNULUS_API void annulus_destroy(annulus_mesh** mesh);

// Writes the message of the last failed call on this mesh, from whichever thread. With mesh == NULL: the message of the
// last failed call of this thread that had no mesh, such as annulus_create. The message is cut to `capacity` bytes, the
// last one 0; buffer may be NULL when capacity is 0. Returns the length of the whole message, 0 if there has been no
// error. Cannot fail.
ANNULUS_API size_t annulus_message(const annulus_mesh* mesh, char* buffer, size_t capacity);

// Writes up to `capacity` of the vertices that the same error concerns, ascending, and returns how many there are.
// vertices may be NULL when capacity is 0. After DUPLICATE_POINT: the vertices that would share one position, two or
// more; for annulus_create numbers of points; for annulus_insert the one vertex that already has this position. After
// NOT_FINITE and OUT_OF_DOMAIN: every vertex (for annulus_create and annulus_insert point, for predicates row) that was
// refused. After UNKNOWN_VERTEX: every index that is not a vertex, or that occurs twice. After NO_TRIANGULATION: the
// corners of a cell that is not positive. Other errors concern none. Cannot fail.
ANNULUS_API size_t annulus_error_vertices(const annulus_mesh* mesh, size_t capacity, int32_t* vertices);

// The first two of these; returns 0 to 2. Cannot fail.
ANNULUS_API size_t annulus_message_vertices(const annulus_mesh* mesh, int32_t vertices[2]);

// The name of a status in words, "duplicate point" for ANNULUS_DUPLICATE_POINT; "unknown status" for any other number.
// Never NULL.
ANNULUS_API const char* annulus_status_name(int status);

// The version of the library, for example "0.1.0", and the ANNULUS_INTERFACE that it was built with. Macros of the
// headers' own version are in <annulus/version.h>.
ANNULUS_API const char* annulus_version(void);
ANNULUS_API int annulus_interface(void);

// ---- Changing a mesh. report: optional everywhere --------------------------------------------------

// Moves every vertex: point i is the new position of vertex i; points at free indices are ignored. `points` must be
// annulus_index_bound. O(n), with a small constant when few vertices leave their tolerance.
// Errors: WRONG_SIZE, NOT_FINITE, OUT_OF_DOMAIN, DUPLICATE_POINT, TOO_LARGE, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_move_all(annulus_mesh* mesh, size_t points, const double* coordinates, annulus_report* report);

// Moves some vertices, all at the same time: vertex indices[k] to point k (indices before points, as in C++). If an
// index occurs twice, its last point counts. If at most one vertex in 64 moves, under a strategy that repairs the
// mesh ("auto", "tolerances", "tolerances-each", "in-place"), the cost is that of their single moves, whatever the
// size of the mesh. Errors: as annulus_move_all, and UNKNOWN_VERTEX.
ANNULUS_API int annulus_move(annulus_mesh* mesh, size_t count, const int32_t* indices, const double* coordinates,
                             annulus_report* report);

// Inserts vertices one after another and writes their indices: first the free ones, the one freed last first, then new
// ones. All coordinates are checked before the first insertion. If a later point is refused (DUPLICATE_POINT,
// TOO_LARGE, NO_MEMORY), the points before it stay inserted: *inserted, optional, is their number, 0 if nothing was
// done. Ten to twenty microseconds each in 2D (up to a million vertices), about forty in 3D (up to 100,000). The first
// insertion after a construction copies arrays, O(n). While all points are in a plane or on a line, each insertion
// compares the point with all others, O(n).
// Errors: NOT_FINITE, OUT_OF_DOMAIN, DUPLICATE_POINT, TOO_LARGE, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_insert(annulus_mesh* mesh, size_t count, const double* coordinates, int32_t* indices,
                               size_t* inserted, annulus_report* report);

// Removes vertices one after another; their indices become free. All indices are checked before the first removal.
// After NO_MEMORY, *removed, optional, is the number of vertices removed, and the next one may have been removed as
// well (see annulus_is_vertex).
// Errors: UNKNOWN_VERTEX (also for an index that occurs twice), ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_remove(annulus_mesh* mesh, size_t count, const int32_t* indices, size_t* removed,
                               annulus_report* report);

// Computes every tolerance again, measured from the current positions of the vertices. O(n).
// Errors: DUPLICATE_POINT, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_recompute_tolerances(annulus_mesh* mesh, annulus_report* report);

// ---- Queries. O(1) ---------------------------------------------------------------------------------

ANNULUS_API int annulus_dimension(const annulus_mesh* mesh, int* dimension);  // 2 or 3, as given to annulus_create
ANNULUS_API int annulus_affine_dimension(const annulus_mesh* mesh,
                                         int* dimension);  // less if the points are flat; -1: no points
ANNULUS_API int annulus_vertex_count(const annulus_mesh* mesh, size_t* count);
// One more than the largest index in use or free: the size of every array by vertex index.
ANNULUS_API int annulus_index_bound(const annulus_mesh* mesh, size_t* bound);
// 1 for a vertex, 0 for a free index or one out of range.
ANNULUS_API int annulus_is_vertex(const annulus_mesh* mesh, int32_t index, int* answer);
// The strategy in use: that of the options, except that "paper-hybrid" becomes "paper" when it switches. A constant
// string.
ANNULUS_API int annulus_strategy(const annulus_mesh* mesh, const char** name);

// ---- Arrays by vertex index. `capacity` counts vertices: at least annulus_index_bound, else WRONG_SIZE. O(n) -------

// NaN at free indices.
ANNULUS_API int annulus_points(const annulus_mesh* mesh, size_t capacity, double* coordinates);
// The tolerance of each vertex: how far it may be from its fixed position, where it was when its tolerance was
// computed, while every other vertex is within its own tolerance. A certified lower bound, unless options say
// otherwise. 0 if all points are in a plane or on a line, NaN at free indices. Errors: ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_tolerances(const annulus_mesh* mesh, size_t capacity, double* lengths);
// The distance of each vertex from its fixed position, rounded up. NaN at free indices. Errors: as above.
ANNULUS_API int annulus_displacements(const annulus_mesh* mesh, size_t capacity, double* lengths);
// Areas (dimension 2) or volumes (dimension 3) of the Voronoi cells, each with a relative error of at most 2^-33 for
// any points, and for each cell the number of Voronoi cells that touch it: its neighbours in the triangulation. The
// area or volume of an unbounded cell, that of a vertex of the hull, is infinity. At free indices the volume is NaN and
// the number is 0. Either array may be NULL. Values saturate at the largest double; those below the smallest normal
// double have an additional absolute error of 2^-1074. One microsecond per vertex.
// Errors: NO_TRIANGULATION, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_voronoi(const annulus_mesh* mesh, size_t capacity, double* volumes, int32_t* neighbour_counts);

// The same volumes, and for each vertex the centroid of its cell, coordinates like those of points, NaN where the
// volume is infinite. With lower and upper, `dimension` numbers each, cells are intersected with this box, so that all
// are finite; otherwise both are NULL. A volume has a relative error of at most 2^-32; if the box cuts the cell, an
// absolute one of at most 2^-44 times the power of the diameter of box and points. `centroids` or `volumes` may be
// NULL. O(n), a microsecond per vertex in 2D, five in 3D. Without a box the diagram is kept, 1.5 kB per vertex in 3D
// (400 bytes in 2D), so that a later call, and one of annulus_voronoi_facets, computes only what has changed since.
// Errors: USAGE and NOT_FINITE for the box, NO_TRIANGULATION, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_voronoi_cells(const annulus_mesh* mesh, const double* lower, const double* upper,
                                      size_t capacity, double* volumes, double* centroids);
// The gradient of the sum of weights[v] times the volume of vertex v, with respect to all coordinates: `gradient` has
// `dimension` numbers for each vertex. Weights of unbounded cells and of free indices count as 0. With A and c the
// measure and the centroid of the Voronoi facet of v and w, the derivative of volume v with respect to x_w is
// A (x_w - c) / |x_v - x_w|. O(n), as above. Errors: NO_TRIANGULATION, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_voronoi_gradient(const annulus_mesh* mesh, size_t capacity, const double* weights,
                                         double* gradient);

// ---- Lists. Call with capacity 0 and NULL for the count, then again; *count is right after WRONG_SIZE, too ---------

// The vertex of every point given to annulus_create: 0, 1, 2, .. unless duplicate points were merged.
ANNULUS_API int annulus_vertex_of_input(const annulus_mesh* mesh, size_t capacity, int32_t* indices, size_t* count);
// Finite cells, dimension + 1 numbers each in both arrays; either may be NULL. vertices: positively oriented (in 2D
// counter-clockwise; in 3D det(b - a, c - a, e - a) > 0), padded with -2 if all points are in a plane or on a line.
// neighbours: the cell opposite to each vertex, -1 outside the hull. Cells have the numbers 0, 1, 2, .. until the next
// call that changes a cell. The list is kept until then for further calls: 24 or 32 bytes per cell. O(n).
// Errors: WRONG_SIZE, NO_MEMORY.
ANNULUS_API int annulus_cells(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, int32_t* neighbours,
                              size_t* count);
// The vertices that an edge joins to one vertex, ascending. This function and the next three use lists that the first
// call after a change of cells makes, O(n), and keeps: those of annulus_cells, and for neighbours about 28 (2D) or 66
// (3D) bytes per vertex.
// Errors: UNKNOWN_VERTEX, WRONG_SIZE, NO_MEMORY.
ANNULUS_API int annulus_neighbours(const annulus_mesh* mesh, int32_t vertex, size_t capacity, int32_t* vertices,
                                   size_t* count);
// Those of all vertices: those of vertex v are vertices[begin[v]] to vertices[begin[v + 1] - 1], none at free indices.
// begin: optional, NULL with begins 0; otherwise begins must be annulus_index_bound + 1 or more.
// Errors: WRONG_SIZE, NO_MEMORY.
ANNULUS_API int annulus_neighbour_lists(const annulus_mesh* mesh, size_t begins, int32_t* begin, size_t capacity,
                                        int32_t* vertices, size_t* count);
// The facets between Voronoi cells, in the order of the vertices of annulus_neighbour_lists, so that each is there
// twice. measures: length (dimension 2) or area (3), infinity if the facet is unbounded, otherwise with a relative
// error of at most 2^-32; exactly 0 where the cells of two neighbours meet in less than a facet, which is decided
// exactly: dimension + 2 or more points are cospherical. centroids: `dimension` numbers each, NaN where the measure is
// 0 or infinite. Either array may be NULL. O(n), as annulus_voronoi_cells. Errors: WRONG_SIZE, NO_TRIANGULATION,
// ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_voronoi_facets(const annulus_mesh* mesh, size_t capacity, double* measures, double* centroids,
                                       size_t* count);
// The facets of the convex hull, as many numbers each as the dimension: in 2D edges with the triangulation on their
// left, in 3D triangles that are counter-clockwise seen from outside. None if all points are on a line (in 3D: in a
// plane). Errors: WRONG_SIZE, NO_MEMORY.
ANNULUS_API int annulus_convex_hull(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, size_t* count);
// For each point the number, in annulus_cells, of a cell that contains it, in its interior or on its border; -1 outside
// the convex hull and for NaN, and if all vertices are on a line (in 3D: in a plane). Exact. Expected O(cbrt(n)) each.
// Errors: ENVIRONMENT, WRONG_SIZE, NO_MEMORY.
ANNULUS_API int annulus_find_cells(const annulus_mesh* mesh, size_t points, const double* coordinates, int32_t* cells);
// With options.report_changes: the cells that were created by the last call that changed the mesh, as vertices, -1 for
// the vertex at infinity. For a call that makes several changes (annulus_insert, annulus_remove) the list may contain a
// cell that no longer exists. If all points are, or were, in a plane or on a line: all finite cells. O(list).
// Errors: WRONG_SIZE; USAGE without that option.
ANNULUS_API int annulus_changed(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, size_t* count);

// An exact check in integer arithmetic that relies on none of the above. A few microseconds per vertex.
// Errors: USAGE, NO_MEMORY.
ANNULUS_API int annulus_audit(const annulus_mesh* mesh, annulus_audit_result* result);

// ---- Without a mesh. A message is that of annulus_message(NULL, ..) ------------------------------------------------

// Signs of `count` rows of points, 3, 4, 4 and 5 in a row: annulus/predicates.h describes them. orient_2d is positive
// if a, b, c turn left; orient_3d if det(b - a, c - a, e - a) > 0; in_circle and in_sphere if the last point is
// strictly inside the circle or sphere of the others and these are positive. 0 is an answer: nothing is perturbed. 0.1
// to 1.5 microseconds each, and up to some ten where the sign needs integers.
// Errors: NOT_FINITE, OUT_OF_DOMAIN, with the row in annulus_message_vertices; WRONG_SIZE, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_orient_2d(size_t count, const double* coordinates, annulus_sign* signs);
ANNULUS_API int annulus_orient_3d(size_t count, const double* coordinates, annulus_sign* signs);
ANNULUS_API int annulus_in_circle(size_t count, const double* coordinates, annulus_sign* signs);
ANNULUS_API int annulus_in_sphere(size_t count, const double* coordinates, annulus_sign* signs);

// An exact verdict on a triangulation made by any program: whether the cells, dimension + 1 numbers of points each in
// any order, are a Delaunay triangulation of all these points. If all points are in a plane or on a line, cells of that
// dimension may be padded with -2. A single point, and no point, is Delaunay without cells and with no others. Lists up
// to `capacity` faults, sorted by kind; *count is the number listed. count is optional if capacity is 0. In `result`
// inverted_cells counts flat cells. A few microseconds per cell.
// Errors: USAGE, NOT_FINITE, WRONG_SIZE, TOO_LARGE, NO_MEMORY.
ANNULUS_API int annulus_audit_cells(int dimension, size_t points, const double* coordinates, size_t cells,
                                    const int32_t* vertices, annulus_audit_result* result, size_t capacity,
                                    annulus_fault* faults, size_t* count);

// ---- What the last call changed: lists beside annulus_changed, with the same rules of lists ------------------------

// With options.report_changes: the cells that the last call that changed the mesh removed, as vertices, -1 for the
// vertex at infinity. dimension + 1 numbers each, positively oriented as in annulus_cells. A cell that was turned over
// is here and in annulus_changed, with its vertices in another order. For a call that makes several changes
// (annulus_insert, annulus_remove) the list may contain a cell that did not exist before the call. If all points are,
// or were, in a plane or on a line: all finite cells that there were, padded with -2. O(list).
// Errors: WRONG_SIZE; USAGE without that option.
ANNULUS_API int annulus_gone(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, size_t* count);
// With the same option: the pairs of vertices that the last call that changed the mesh made neighbours, and those that
// are neighbours no longer: the edges after the call without those before it, and the reverse, however many changes the
// call makes. Two indices each, the smaller one first, ascending. Pairs with a vertex that was inserted are made, those
// with one that was removed are broken. In 2D a flip breaks one pair and makes one, a T1 transition. The first of these
// two functions after a change takes O(k log k) for k cells in both lists; then the pairs are kept, 8 bytes each, until
// the next call that changes the mesh: O(list).
// Errors: WRONG_SIZE, NO_MEMORY; USAGE without that option.
ANNULUS_API int annulus_edges_made(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, size_t* count);
ANNULUS_API int annulus_edges_broken(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, size_t* count);
// With the same option, in 2D: the T1 transitions of the last call that changed the mesh, where two Voronoi cells lost
// their contact and two others came into contact. Four indices i, j, k, l each, i < j and k < l: i and j were
// neighbours before, k and l are since, and the triangles i j k and i j l became k l i and k l j. Ascending. Where
// flips follow one another in one place within a call, or vertices pass through the hull, pairs are made and broken
// that are in the two lists above and not here. Cocircular points may change their diagonal, which is a transition
// between empty facets. The first call after a change takes O(k log k) for k cells in the lists of cells; then the
// transitions are kept, 16 bytes each, until the next call that changes the mesh: O(list).
// Errors: WRONG_SIZE, NO_MEMORY; USAGE without that option, and in 3D.
ANNULUS_API int annulus_t1(const annulus_mesh* mesh, size_t capacity, int32_t* vertices, size_t* count);

// ---- Periodic boxes: the C++ class Periodic_mesh ----------------------------------------------------
//
// The Delaunay triangulation of points and all their translates by the vectors of a box, as finitely many cells with
// offsets. A box is 2 vectors of 2 numbers, or 3 of 3, one vector after the other: any that span a volume, of either
// handedness, not thinner or more skewed than docs/periodic.md says. All directions are periodic. Any number of points,
// from none on, inside the box or not: any image of each. Coordinates are rounded, once, to about 2^-49 of the box;
// everything is exact for points and box as they are returned. An offset or shift is 2 or 3 numbers of type int32_t: by
// how many of each vector of the box a point is moved. Rules, errors and messages are as above, with the handle of this
// kind. Every call that changes something is all or nothing.

// As annulus_create. Of the options `threads`, `report_changes` and `merge_duplicates` may be set, and `strategy` to
// "signs", which tests all signs in a move, to "tolerances", or to "auto", tolerances while they pay. Two points that
// are, rounded, images of one another are DUPLICATE_POINT, or one vertex (annulus_periodic_vertex_of_input); a box that
// is not possible is USAGE; a point more than 2^29 boxes away is OUT_OF_DOMAIN.
ANNULUS_API int annulus_periodic_create(annulus_periodic** mesh, int dimension, size_t points,
                                        const double* coordinates, const double* box, const annulus_options* options);
ANNULUS_API void annulus_periodic_destroy(annulus_periodic** mesh);
// As annulus_message and annulus_error_vertices, which have the errors of calls without a mesh.
ANNULUS_API size_t annulus_periodic_message(const annulus_periodic* mesh, char* buffer, size_t capacity);
ANNULUS_API size_t annulus_periodic_error_vertices(const annulus_periodic* mesh, size_t capacity, int32_t* vertices);

// Moves every vertex; points at free indices are not read. `points` must be annulus_periodic_index_bound. box: NULL
// leaves the box as it was given. Tests signs and flips, or builds where that costs less: O(n) or O(n log n).
// report: optional; `changed` is the number of cells that annulus_periodic_changed lists, 0 without report_changes.
// Errors: those of annulus_periodic_create, and WRONG_SIZE.
ANNULUS_API int annulus_periodic_move_all(annulus_periodic* mesh, size_t points, const double* coordinates,
                                          const double* box, annulus_report* report);
// Moves some vertices, all at once: vertex indices[k] to point k, any image. If an index occurs twice, its last point
// counts. They are removed and inserted where they go, and the report is of those that are named; where to move all is
// expected to cost less, or with few points, the call does that, and the report is of all vertices.
// Errors: as annulus_periodic_move_all, and UNKNOWN_VERTEX.
ANNULUS_API int annulus_periodic_move(annulus_periodic* mesh, size_t count, const int32_t* indices,
                                      const double* coordinates, annulus_report* report);
// Evaluates every certificate, and keeps tolerances from now on; with the strategy "signs" it does nothing. Lists of
// what a call has changed stay as they are, and `changed` in the report is 0. O(n). Errors: ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_periodic_recompute_tolerances(annulus_periodic* mesh, annulus_report* report);
// Inserts vertices, all or none, and writes their indices: first the free ones, the one freed last first. Five to
// fifteen microseconds each in 2D, twenty to forty in 3D; with few points a build. After DUPLICATE_POINT the vertex is
// named that has an image at one of the places; none where two of the points are images of one another.
// Errors: NOT_FINITE, OUT_OF_DOMAIN, DUPLICATE_POINT, TOO_LARGE, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_periodic_insert(annulus_periodic* mesh, size_t count, const double* coordinates,
                                        int32_t* indices);
// Removes vertices, all or none; their indices become free.
// Errors: UNKNOWN_VERTEX (also for an index that occurs twice), TOO_LARGE, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_periodic_remove(annulus_periodic* mesh, size_t count, const int32_t* indices);

ANNULUS_API int annulus_periodic_dimension(const annulus_periodic* mesh, int* dimension);
ANNULUS_API int annulus_periodic_vertex_count(const annulus_periodic* mesh, size_t* count);
ANNULUS_API int annulus_periodic_index_bound(const annulus_periodic* mesh, size_t* bound);
ANNULUS_API int annulus_periodic_is_vertex(const annulus_periodic* mesh, int32_t index, int* answer);
// The vectors of the box, rounded: 4 or 9 numbers.
ANNULUS_API int annulus_periodic_box(const annulus_periodic* mesh, double* box);

// Arrays by vertex index, as above. The points as they were given, rounded, NaN at free indices.
ANNULUS_API int annulus_periodic_points(const annulus_periodic* mesh, size_t capacity, double* coordinates);
// Lower bounds of how far each vertex may be from its place while the box stays and every other vertex is within its
// own: no cell changes. What is left of tolerances that are kept, or all certificates are evaluated. NaN at free
// indices. Errors: ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_periodic_tolerances(const annulus_periodic* mesh, size_t capacity, double* tolerances);
// Areas or volumes of the Voronoi cells, which add up to that of the box: relative error 2^-33, NaN at free indices.
// Errors: ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_periodic_voronoi(const annulus_periodic* mesh, size_t capacity, double* volumes);
// Of each cell volume, surface (in 2D area and perimeter) and centroid, 2 or 3 numbers, from the diagram of
// annulus_periodic_voronoi_facets, which is kept; NaN at free indices. Two of the arrays may be NULL.
// Errors: ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_periodic_voronoi_cells(const annulus_periodic* mesh, size_t capacity, double* volumes,
                                               double* surfaces, double* centroids);
// As annulus_voronoi_gradient: all images of a point move with it, and the box stays. Errors: ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_periodic_voronoi_gradient(const annulus_periodic* mesh, size_t capacity, const double* weights,
                                                  double* gradient);
// As annulus_vertex_of_input.
ANNULUS_API int annulus_periodic_vertex_of_input(const annulus_periodic* mesh, size_t capacity, int32_t* indices,
                                                 size_t* count);

// Lists, as above: kept until the next call that changes the mesh. Cells, one of each set of translates, dimension + 1
// corners each: vertices and neighbours as many numbers, and as many offsets: corner i of cell c is at
// points[vertices[c][i]] + offsets[c][i] . box. translations: what to add to the offsets of the neighbour, so that the
// images of the common facet are the same. Every array may be NULL. A vertex may be several corners of a cell.
// Errors: WRONG_SIZE, NO_MEMORY.
ANNULUS_API int annulus_periodic_cells(const annulus_periodic* mesh, size_t capacity, int32_t* vertices,
                                       int32_t* offsets, int32_t* neighbours, int32_t* translations, size_t* count);
// Pairs of Voronoi cells that touch, each in both directions, ascending by (first, second, shift): second, moved by the
// shift, is a neighbour of first. vectors: points[second] - points[first] + shift . box, 2 or 3 numbers; distances:
// their lengths; areas: the length or area of the facet, 0 where it is exactly empty. Every array may be NULL. A vertex
// may be its own neighbour, and two may be neighbours several times.
// Errors: WRONG_SIZE, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_periodic_neighbours(const annulus_periodic* mesh, size_t capacity, int32_t* first,
                                            int32_t* second, int32_t* shifts, double* vectors, double* distances,
                                            double* areas, size_t* count);
// The Voronoi diagram, in the frame of the points as they are returned. Facets between cells, each once: of `first` and
// of `second` moved by the shift, first <= second, ascending by (first, second, shift). measures: length (dimension 2)
// or area (3), 0 where the facet is exactly empty; centroids: NaN there. Measures, volumes and surfaces have a relative
// error of 2^-32. Every array may be NULL. The first of these calls after a change computes the diagram, some
// microseconds a vertex, and keeps it, with annulus_periodic_voronoi_cells. Errors: WRONG_SIZE, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_periodic_voronoi_facets(const annulus_periodic* mesh, size_t capacity, int32_t* first,
                                                int32_t* second, int32_t* shifts, double* measures, double* centroids,
                                                size_t* count);
// The corners of all facets: those of facet k have the numbers begin[k] to begin[k + 1] - 1, in order, in 3D counter-
// clockwise as seen from the second cell, in 2D two, with the first cell on the left. Each is at coordinates[vertices]
// + shifts . box, with the coordinates of annulus_periodic_voronoi_vertices. Two are the same if vertex and shift are,
// as may be of some that follow each other where points are cospherical. begin: optional, NULL with begins 0; otherwise
// begins must be one more than there are facets, or more. vertices and shifts may be NULL. Errors: as above.
ANNULUS_API int annulus_periodic_voronoi_corners(const annulus_periodic* mesh, size_t begins, int32_t* begin,
                                                 size_t capacity, int32_t* vertices, int32_t* shifts, size_t* count);
// The circumcentres of annulus_periodic_cells, in their order. Of cells that have exactly the same one up to a shift,
// and are connected by such cells, corners name the first. Errors: as above.
ANNULUS_API int annulus_periodic_voronoi_vertices(const annulus_periodic* mesh, size_t capacity, double* coordinates,
                                                  size_t* count);
// For each point the number, in annulus_periodic_cells, of a cell that contains it, decided exactly for the point as it
// is rounded, and what to add to the offsets of that cell; -1 without cells and for NaN. shifts may be NULL.
// Errors: NOT_FINITE for infinity, OUT_OF_DOMAIN, ENVIRONMENT, NO_MEMORY.
ANNULUS_API int annulus_periodic_find_cells(const annulus_periodic* mesh, size_t points, const double* coordinates,
                                            int32_t* cells, int32_t* shifts);
// With options.report_changes: the pairs that the last call that changed the mesh made and broke, each once, first <=
// second; shifts of pairs that were broken are those before the call. Points given as other images change nothing, nor
// does another basis of the box. Every array may be NULL.
// Errors: WRONG_SIZE; USAGE without that option.
ANNULUS_API int annulus_periodic_pairs_made(const annulus_periodic* mesh, size_t capacity, int32_t* first,
                                            int32_t* second, int32_t* shifts, size_t* count);
ANNULUS_API int annulus_periodic_pairs_broken(const annulus_periodic* mesh, size_t capacity, int32_t* first,
                                              int32_t* second, int32_t* shifts, size_t* count);

// With the same option: the cells that the same call created, and those that it removed, by the points and the box
// before it. dimension + 1 vertices and as many offsets each, positively oriented, as in annulus_periodic_cells, but
// in this order: corners ascend by (vertex, offset), the last two exchanged where that makes the cell positive; cells
// ascend. A cell that was turned over is in both. One of the arrays may be NULL.
// Errors: WRONG_SIZE; USAGE without that option.
ANNULUS_API int annulus_periodic_changed(const annulus_periodic* mesh, size_t capacity, int32_t* vertices,
                                         int32_t* offsets, size_t* count);
ANNULUS_API int annulus_periodic_gone(const annulus_periodic* mesh, size_t capacity, int32_t* vertices,
                                      int32_t* offsets, size_t* count);

// As annulus_audit, of the cells for the points and the box as they are returned.
ANNULUS_API int annulus_periodic_audit(const annulus_periodic* mesh, annulus_audit_result* result);

#ifdef __cplusplus
}  // extern "C"
#endif
