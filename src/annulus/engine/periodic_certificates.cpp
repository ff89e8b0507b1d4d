// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/periodic_certificates.h>

#include <annulus/mesh/certificates.h>
#include <annulus/mesh/parallel_runs.h>
#include <annulus/predicate/batch.h>
#include <annulus/predicate/perturbed_sign.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

namespace {

/// The k-th corner of the facet opposite to corner i, in the order of the predicates.
template <int d>
constexpr std::size_t facing(std::size_t i, std::size_t k) {
    if constexpr (d == 2) return (i + 1 + k) % 3;
    else return static_cast<std::size_t>(facing_corners[i][k]);
}

/// An upper bound of how far points are from the middle of their bounding box.
template <int d>
double radius_upper(std::span<const Coordinates<d>> x) {
    Coordinates<d> low = x[0], high = x[0];
    for (const Coordinates<d>& p : x)
        for (std::size_t i = 0; i < d; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    double most = 0;
    for (const Coordinates<d>& p : x) {
        double squares = 0;
        for (std::size_t i = 0; i < d; ++i) {
            const double off = p[i] - 0.5 * (low[i] + high[i]);
            squares += off * off;
        }
        most = std::max(most, squares);
    }
    // What the middle is rounded does not matter, any point will do; squares underflow far below a unit of any grid.
    return std::sqrt(most) * (1 + 0x1p-48);
}

/// Certificates of one kind, evaluated together, with the places of their points.
template <int d, std::size_t points>
class Placed_batch {
  public:
    explicit Placed_batch(const Periodic_view<d>& view) : view_(view) {}

    void add(Certificate_id id, Evaluated_certificate<d>& out) {
        const auto images = certificate_images<d>(view_.table, id);
        auto& x = place_[size_];
        out.id = id;
        out.vertex.fill(none);
        for (std::size_t k = 0; k < points; ++k) {
            const Coordinates<d>& p = view_.place[static_cast<std::size_t>(images[k].vertex)];
            x[k] = images[k].label.is_zero() ? p : view_.lattice.place(p, images[k].label);
            tuple_[size_][k] = &x[k];
            out.vertex[k] = images[k].vertex;
        }
        out_[size_] = &out;
        if (++size_ == capacity) evaluate();
    }
    void evaluate() {
        if (size_ == 0) return;
        counts_ += annulus::evaluate(std::span<const T>(tuple_.data(), size_), Tolerance_precision::lower_bound,
                                     std::span(value_.data(), size_));
        for (std::size_t i = 0; i < size_; ++i) {
            Evaluated_certificate<d>& e = *out_[i];
            e.tolerance = value_[i].tolerance;
            e.radius = radius_upper<d>(place_[i]);
            e.holds = value_[i].sign > 0;
            e.cospherical = false;
            if constexpr (points == d + 2) {
                e.cospherical = value_[i].sign == 0;
                if (e.cospherical) e.holds = perturbed_sign(tuple_[i]) > 0;
            }
        }
        size_ = 0;
    }
    [[nodiscard]] const Stage_counts& counts() const { return counts_; }

  private:
    static constexpr std::size_t capacity = 64;
    using T = Tuple<d, static_cast<int>(points)>;

    const Periodic_view<d>& view_;
    std::array<std::array<Coordinates<d>, points>, capacity> place_;
    std::array<T, capacity> tuple_;
    std::array<Certificate_value, capacity> value_;
    std::array<Evaluated_certificate<d>*, capacity> out_;
    std::size_t size_ = 0;
    Stage_counts counts_;
};

}  // namespace

template <int d>
std::array<Image<d>, static_cast<std::size_t>(d + 2)> certificate_images(const Periodic_table<d>& table,
                                                                         Certificate_id id) {
    std::array<Image<d>, static_cast<std::size_t>(d + 2)> x;
    if (is_of_cell(id)) {
        const std::size_t c = cell_of(id).offset();
        for (std::size_t k = 0; k <= d; ++k) x[k] = table.image(c, k);
        x[d + 1] = Image<d>(none);
        return x;
    }
    const Corner_index f = facet_of(id);
    const std::size_t c = table.cell_of(f), i = table.slot_of(f);
    const Corner_index t = table.twin[c][i];
    for (std::size_t k = 0; k < d; ++k) x[k] = table.image(c, facing<d>(i, k));
    x[d] = table.image(table.cell_of(t), table.slot_of(t), table.translation(c, i));
    x[d + 1] = table.image(c, i);
    return x;
}

template <int d>
Stage_counts evaluate_periodic(const Periodic_view<d>& view, std::span<const Certificate_id> ids, int threads,
                               std::span<Evaluated_certificate<d>> out) {
    constexpr std::size_t run = 1024;
    std::vector<Stage_counts> counts((ids.size() + run - 1) / run);
    for_each_run(ids.size(), run, threads, [&](std::size_t first, std::size_t last) {
        Placed_batch<d, d + 1> cells(view);
        Placed_batch<d, d + 2> bicells(view);
        for (std::size_t k = first; k < last; ++k)
            if (is_of_cell(ids[k])) cells.add(ids[k], out[k]);
            else bicells.add(ids[k], out[k]);
        cells.evaluate();
        bicells.evaluate();
        counts[first / run] += cells.counts();
        counts[first / run] += bicells.counts();
    });
    Stage_counts all;
    for (const Stage_counts& here : counts) all += here;
    return all;
}

template std::array<Image<2>, 4> certificate_images(const Periodic_table<2>&, Certificate_id);
template std::array<Image<3>, 5> certificate_images(const Periodic_table<3>&, Certificate_id);
template Stage_counts evaluate_periodic(const Periodic_view<2>&, std::span<const Certificate_id>, int,
                                        std::span<Evaluated_certificate<2>>);
template Stage_counts evaluate_periodic(const Periodic_view<3>&, std::span<const Certificate_id>, int,
                                        std::span<Evaluated_certificate<3>>);

}  // namespace annulus::inline v1
