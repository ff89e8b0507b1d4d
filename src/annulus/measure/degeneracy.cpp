// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/degeneracy.h>

#include <annulus/measure/certificate_sums.h>
#include <annulus/measure/paper_tolerance.h>
#include <annulus/measure/spacing.h>
#include <annulus/mesh/parallel_runs.h>

#include <cstdint>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// The number of certificates that one thread evaluates at a time.
constexpr std::size_t batch = 4096;

/// One scan of all certificates.
template <int d>
class Degeneracy_scan {
  public:
    Degeneracy_scan(const Corner_table<d>& t, std::span<const Coordinates<d>> x, const Degeneracy_options<d>& options)
        : t_(t),
          x_(x),
          options_(options),
          sums_(x.size(), mean_spacing(t, x), resolution(x), options),
          paper_(t, x.size(), options.threads) {}

    /// Batches are evaluated by all threads and entered one after another.
    Degeneracy result() {
        for_each_in_order<Slot>(
            options_.threads, [this](Slot& slot) { return fill(slot); }, [this](Slot& slot) { find(slot); },
            [this](const Slot& slot) { enter(slot); });
        Degeneracy r = sums_.result();
        enter_paper(r);
        return r;
    }

  private:
    enum class Kind : std::uint8_t { bicells, ridges, border, cells };
    using Facets = Simplex_batch<d, Corner_index>;
    using Cells = Simplex_batch<d, Cell_index>;
    /// Whether the batch of its kind is full or the last.
    struct Slot {
        Kind kind = Kind::bicells;
        Bicell_batch<d> bicells{};
        Facets facets{};
        Cells cells{};
    };

    /// The next batch, none after the last: facets in their order, then cells.
    bool fill(Slot& slot) {
        const auto give = [&slot](Kind kind, auto& from, auto& to) {
            slot.kind = kind;
            std::swap(from, to);
            from.clear();
            return true;
        };
        for (; filling_.next_facet != t_.facet_bound(); ++filling_.next_facet) {
            if (filling_.bicells.id.size() == batch) return give(Kind::bicells, filling_.bicells, slot.bicells);
            if (filling_.ridges.id.size() == batch) return give(Kind::ridges, filling_.ridges, slot.facets);
            if (filling_.border.id.size() == batch) return give(Kind::border, filling_.border, slot.facets);
            if (t_.is_facet(filling_.next_facet)) append(filling_.next_facet);
        }
        if (!filling_.bicells.id.empty()) return give(Kind::bicells, filling_.bicells, slot.bicells);
        if (!filling_.ridges.id.empty()) return give(Kind::ridges, filling_.ridges, slot.facets);
        if (!filling_.border.id.empty()) return give(Kind::border, filling_.border, slot.facets);
        for (; filling_.next_cell != t_.cell_bound() && filling_.cells.id.size() < batch; ++filling_.next_cell)
            if (t_.is_cell(filling_.next_cell) && !t_.is_infinite(filling_.next_cell))
                filling_.cells.append(filling_.next_cell, cell_sites(t_, filling_.next_cell), x_);
        return !filling_.cells.id.empty() && give(Kind::cells, filling_.cells, slot.cells);
    }
    void append(Corner_index h) {
        switch (facet_kind(t_, h)) {
            case Facet_kind::empty_sphere: filling_.bicells.append(h, bicell_sites(t_, h), x_); break;
            case Facet_kind::ridge: filling_.ridges.append(h, ridge_vertex_last(t_, h, ridge_sites(t_, h)), x_); break;
            default: filling_.border.append(h, slab_sites(t_, h), x_); break;
        }
    }

    /// The part that concerns one batch alone; run by several threads at once.
    void find(Slot& slot) const {
        switch (slot.kind) {
            case Kind::bicells: slot.bicells.find(sums_.thresholds()); break;
            case Kind::ridges:
                slot.facets.find(sums_.thresholds());
                slot.facets.find_paper(Width::ridge);
                break;
            case Kind::border: slot.facets.find_paper(Width::slab); break;
            case Kind::cells: slot.cells.find(sums_.thresholds()); break;
        }
    }

    void enter(const Slot& slot) {
        using Certificate = typename Raw_certificate<d>::Kind;
        switch (slot.kind) {
            case Kind::bicells:
                sums_.enter_bicells(slot.bicells);
                for (std::size_t i = 0; i < slot.bicells.id.size(); ++i)
                    paper_.note_bicell(slot.bicells.id[i], slot.bicells.all[i]);
                break;
            case Kind::ridges:
                sums_.enter(Certificate::ridge, slot.facets);
                for (std::size_t i = 0; i < slot.facets.id.size(); ++i)
                    paper_.note_ridge(slot.facets.id[i], slot.facets.half[i]);
                note_paper(slot.facets);
                break;
            case Kind::border: note_paper(slot.facets); break;
            case Kind::cells:
                sums_.enter(Certificate::cell, slot.cells);
                for (std::size_t i = 0; i < slot.cells.id.size(); ++i)
                    paper_.note_cell(slot.cells.id[i], slot.cells.half[i]);
                break;
        }
    }
    void note_paper(const Facets& b) {
        for (std::size_t i = 0; i < b.id.size(); ++i) paper_.note_paper(b.id[i], b.paper[i]);
    }

    void enter_paper(Degeneracy& r) {
        Vertex_counts& v = r.vertices;
        const Paper_verdict p = paper_.verdict(x_);
        v.paper_above_exact = p.above_exact;
        v.paper_unsound = p.unsound;
        v.unsound_certificates = p.certificates;
        Samples samples;
        for (const double tolerance : p.tolerance) samples.add(tolerance / r.spacing, options_.quantiles);
        v.paper = samples.result();
        // 0 / 0 is no number.
        for (std::size_t i = 0; i < p.exact.size(); ++i) v.paper_ratio.add(p.tolerance[i] / p.exact[i]);
        if (options_.unsound)
            for (const auto& points : p.points) options_.unsound(points);
    }

    const Corner_table<d>& t_;
    std::span<const Coordinates<d>> x_;
    const Degeneracy_options<d>& options_;
    Certificate_sums<d> sums_;
    Paper_tolerance<d> paper_;
    /// What fills slots.
    struct Filling {
        Corner_index next_facet{0};
        Cell_index next_cell{0};
        Bicell_batch<d> bicells;
        Facets ridges, border;
        Cells cells;
    };
    Filling filling_;
};

}  // namespace

Degeneracy degeneracy(const Corner_table<2>& t, std::span<const Coordinates<2>> x,
                      const Degeneracy_options<2>& options) {
    return Degeneracy_scan<2>(t, x, options).result();
}
Degeneracy degeneracy(const Corner_table<3>& t, std::span<const Coordinates<3>> x,
                      const Degeneracy_options<3>& options) {
    return Degeneracy_scan<3>(t, x, options).result();
}

}  // namespace annulus::inline v1
