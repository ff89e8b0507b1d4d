// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of annulus.h that create, change and destroy a mesh.
#include <annulus/annulus.h>
#include <annulus/arithmetic/environment.h>
#include <annulus/c/structs.h>
#include <annulus/engine/require_vertices.h>

#include <algorithm>

using namespace annulus;
using namespace annulus::c;

namespace {

/// How many cells annulus_changed lists.
std::size_t cells_in(const annulus_mesh& m) {
    return m.changes.came().size() / static_cast<std::size_t>(m.mesh->dimension() + 1);
}

void hand_over(annulus_mesh& m, Move_result& done, annulus_report* report) {
    m.changes.assign(std::move(done.changed), std::move(done.gone));
    write_report(report, done, cells_in(m));
}

/// For calls that make several calls of Moving_mesh: after each of these, adds its report and its lists of cells.
void add(annulus_mesh& m, const Move_result& one, Move_result& all, annulus_report* report, std::size_t* so_far) {
    if (so_far != nullptr) ++*so_far;
    m.changes.add(one.changed, one.gone);
    all += one;
    all.changed.clear();  // the mesh has them
    all.gone.clear();
    write_report(report, all, cells_in(m));
}

void begin_several(annulus_mesh& m, annulus_report* report, std::size_t* so_far) {
    if (so_far != nullptr) *so_far = 0;
    m.changes.clear();
    write_report(report, {}, 0);
}

}  // namespace

int annulus_create(annulus_mesh** mesh, int dimension, size_t points, const double* coordinates,
                   const annulus_options* options) {
    return guarded(error_of_thread(), [&] {
        require(mesh, "mesh");
        *mesh = nullptr;
        if (dimension != 2 && dimension != 3)
            throw Refused(ANNULUS_USAGE, "the dimension is " + std::to_string(dimension) + ": it can be 2 or 3");
        require_count(points, "points");
        require(coordinates, points, "coordinates");
        const Options chosen = options_of(options);
        require_sound_environment();
        auto made = std::make_unique<annulus_mesh>();
        made->mesh = make_mesh(dimension, coordinates, points, chosen);
        *mesh = made.release();
    });
}

void annulus_destroy(annulus_mesh** mesh) {
    if (mesh == nullptr) return;
    delete *mesh;
    *mesh = nullptr;
}

int annulus_move_all(annulus_mesh* mesh, size_t points, const double* coordinates, annulus_report* report) {
    return guarded(mesh, [&](annulus_mesh& m) {
        require_count(points, "points");
        require(coordinates, points, "coordinates");
        require_report(report);
        require_sound_environment();
        Move_result done = m.mesh->move_all(coordinates, points);
        hand_over(m, done, report);
    });
}

int annulus_move(annulus_mesh* mesh, size_t count, const int32_t* indices, const double* coordinates,
                 annulus_report* report) {
    return guarded(mesh, [&](annulus_mesh& m) {
        require_count(count, "vertices");
        require(indices, count, "indices");
        require(coordinates, count, "coordinates");
        require_report(report);
        require_sound_environment();
        Move_result done = m.mesh->move({indices, count}, coordinates);
        hand_over(m, done, report);
    });
}

int annulus_insert(annulus_mesh* mesh, size_t count, const double* coordinates, int32_t* indices, size_t* inserted,
                   annulus_report* report) {
    return guarded(mesh, [&](annulus_mesh& m) {
        if (inserted != nullptr) *inserted = 0;
        require_count(count, "points");
        require(coordinates, count, "coordinates");
        require(indices, count, "indices");
        require_report(report);
        require_sound_environment();
        m.mesh->require_positions(coordinates, count);
        begin_several(m, report, inserted);
        Move_result all;
        const auto d = static_cast<std::size_t>(m.mesh->dimension());
        for (std::size_t k = 0; k < count; ++k) {
            Move_result one;
            indices[k] = m.mesh->insert(coordinates + k * d, one);
            add(m, one, all, report, inserted);
        }
    });
}

int annulus_remove(annulus_mesh* mesh, size_t count, const int32_t* indices, size_t* removed, annulus_report* report) {
    return guarded(mesh, [&](annulus_mesh& m) {
        if (removed != nullptr) *removed = 0;
        require_count(count, "vertices");
        require(indices, count, "indices");
        require_report(report);
        require_sound_environment();
        require_vertices(
            std::span(indices, count), [&](Index i) { return m.mesh->is_vertex(i); }, Repeats::refused);
        begin_several(m, report, removed);
        Move_result all;
        for (std::size_t k = 0; k < count; ++k) {
            Move_result one;
            m.mesh->remove(indices[k], one);
            add(m, one, all, report, removed);
        }
    });
}

int annulus_recompute_tolerances(annulus_mesh* mesh, annulus_report* report) {
    return guarded(mesh, [&](annulus_mesh& m) {
        require_report(report);
        require_sound_environment();
        Move_result done = m.mesh->recompute_tolerances();
        hand_over(m, done, report);
    });
}
