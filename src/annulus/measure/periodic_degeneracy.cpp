// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/periodic_degeneracy.h>

#include <annulus/measure/certificate_sums.h>
#include <annulus/mesh/parallel_runs.h>
#include <annulus/space/lattice.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace annulus::inline v1 {

namespace {

/// Which image of a vertex.
template <int d>
struct Imaged {
    Index vertex = none;
    Shift<d> offset{};
    friend bool operator==(const Imaged&, const Imaged&) = default;
};
template <int d>
Shift<d> plus(Shift<d> a, const Shift<d>& b, int sign) {
    for (std::size_t i = 0; i < d; ++i) a[i] += sign * b[i];
    return a;
}

/// The corners of cells and bi-cells, and their places: as doubles exactly, since those of a bi-cell are near one
/// another, and each is seen with one of them at its place.
template <int d>
class Periodic_corners {
  public:
    static constexpr std::size_t k = d + 1;
    template <std::size_t n>
    using Images = std::array<Imaged<d>, n>;

    Periodic_corners(const Periodic_audit_input<d>& mesh, const Coordinates<d>& grid) : mesh_(mesh), grid_(grid) {
        for (std::size_t i = 0; i < d; ++i)
            for (std::size_t a = 0; a < d; ++a) box_[i][a] = units(mesh.box[i][a], a);
    }

    [[nodiscard]] std::size_t cells() const { return mesh_.cells.vertices.size(); }
    [[nodiscard]] Images<k> cell(std::size_t c, const Shift<d>& translation = {}) const {
        Images<k> x;
        for (std::size_t i = 0; i < k; ++i)
            x[i] = {mesh_.cells.vertices[c][i], plus<d>(mesh_.cells.offsets[c][i], translation, 1)};
        return x;
    }
    /// Of each pair of half-facets one is counted: that of the cell with the lesser number.
    [[nodiscard]] bool owns(std::size_t c, std::size_t i) const {
        return static_cast<Index>(c) < mesh_.cells.neighbours[c][i];
    }
    /// In the order of the predicates (mesh/certificates.h): facet, opposite vertex beyond it, own vertex.
    [[nodiscard]] Images<k + 1> bicell(std::size_t c, std::size_t i) const {
        const Images<k> own = cell(c);
        const Images<k> other =
            cell(static_cast<std::size_t>(mesh_.cells.neighbours[c][i]), mesh_.cells.translations[c][i]);
        Images<k + 1> x;
        for (std::size_t j = 0; j < d; ++j) x[j] = own[facing(i, j)];
        const auto on_facet = [&x](const Imaged<d>& s) {
            return std::find(x.begin(), x.begin() + d, s) != x.begin() + d;
        };
        x[d] = *std::find_if_not(other.begin(), other.end(), on_facet);
        x[d + 1] = own[i];
        return x;
    }
    /// Places as seen where the last image is at the place of its vertex.
    template <std::size_t n>
    [[nodiscard]] std::array<Coordinates<d>, k + 1> places(const Images<n>& x) const {
        std::array<Coordinates<d>, k + 1> result{};
        for (std::size_t j = 0; j < n; ++j) result[j] = place(x[j].vertex, plus<d>(x[j].offset, x.back().offset, -1));
        return result;
    }

  private:
    [[nodiscard]] static std::size_t facing(std::size_t i, std::size_t j) {
        if constexpr (d == 2) return (i + 1 + j) % 3;
        else return static_cast<std::size_t>(facing_corners[i][j]);
    }
    /// Integers below 2^53 in magnitude.
    [[nodiscard]] std::uint64_t units(double x, std::size_t axis) const {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(x / grid_[axis]));
    }
    /// In integers modulo 2^64: parts of the sum may be large where the box is skewed, the sum is not.
    [[nodiscard]] Coordinates<d> place(Index v, const Shift<d>& offset) const {
        Coordinates<d> x = mesh_.points[static_cast<std::size_t>(v)];
        if (offset == Shift<d>{}) return x;
        for (std::size_t a = 0; a < d; ++a) {
            std::uint64_t sum = units(x[a], a);
            for (std::size_t i = 0; i < d; ++i)
                sum += static_cast<std::uint64_t>(static_cast<std::int64_t>(offset[i])) * box_[i][a];
            x[a] = static_cast<double>(static_cast<std::int64_t>(sum)) * grid_[a];
        }
        return x;
    }

    const Periodic_audit_input<d>& mesh_;
    const Coordinates<d>& grid_;
    std::array<std::array<std::uint64_t, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d)> box_{};
};

/// One scan of all certificates: the bi-cells, then the cells.
template <int d>
class Periodic_scan {
  public:
    Periodic_scan(const Periodic_audit_input<d>& mesh, const Coordinates<d>& grid, std::size_t vertices,
                  const Degeneracy_options<d>& options)
        : corners_(mesh, grid),
          options_(options),
          sums_(mesh.points.size(), spacing(mesh, vertices), *std::max_element(grid.begin(), grid.end()), options) {}

    Degeneracy result() {
        for_each_in_order<Slot>(
            options_.threads, [this](Slot& slot) { return fill(slot); }, [this](Slot& slot) { find(slot); },
            [this](const Slot& slot) {
                if (slot.of_bicells) sums_.enter_bicells(slot.bicells);
                else sums_.enter(Raw_certificate<d>::Kind::cell, slot.cells);
            });
        Degeneracy r = sums_.result();
        r.periodic = true;
        return r;
    }

  private:
    using Places = std::array<Coordinates<d>, static_cast<std::size_t>(d) + 2>;
    struct Slot {
        bool of_bicells = true;
        Bicell_batch<d> bicells{};
        Simplex_batch<d, Cell_index> cells{};
        std::vector<Places> places{};  ///< of the points of each certificate
    };

    static double spacing(const Periodic_audit_input<d>& mesh, std::size_t vertices) {
        const double each = std::fabs(determinant_of_rows(mesh.box)) / static_cast<double>(vertices);
        return d == 2 ? std::sqrt(each) : std::cbrt(each);
    }

    /// The next certificates of one kind, about 4096; none after the last.
    bool fill(Slot& slot) {
        slot.bicells.clear();
        slot.cells.clear();
        slot.places.clear();
        slot.of_bicells = facets_of_ < corners_.cells();
        for (; facets_of_ < corners_.cells() && slot.places.size() < batch; ++facets_of_)
            for (std::size_t i = 0; i <= d; ++i)
                if (corners_.owns(facets_of_, i)) append(slot, slot.bicells, corners_.bicell(facets_of_, i));
        if (slot.of_bicells && !slot.places.empty()) return true;
        slot.of_bicells = false;
        for (; cell_ < corners_.cells() && slot.places.size() < batch; ++cell_)
            append(slot, slot.cells, corners_.cell(cell_));
        return !slot.places.empty();
    }
    template <class Batch, std::size_t n>
    void append(Slot& slot, Batch& to, const std::array<Imaged<d>, n>& x) const {
        std::array<Index, n> v;
        for (std::size_t j = 0; j < n; ++j) v[j] = x[j].vertex;
        to.append({}, v);
        slot.places.push_back(corners_.places(x));
    }
    void find(Slot& slot) const {
        const std::span<const Places> places(slot.places);
        if (slot.of_bicells) {
            slot.bicells.refer_to(places);
            slot.bicells.find(sums_.thresholds());
        } else {
            slot.cells.refer_to(places);
            slot.cells.find(sums_.thresholds());
        }
    }

    static constexpr std::size_t batch = 4096;

    Periodic_corners<d> corners_;
    const Degeneracy_options<d>& options_;
    Certificate_sums<d> sums_;
    std::size_t facets_of_ = 0, cell_ = 0;  // the next to be appended
};

}  // namespace

template <int d>
Degeneracy periodic_degeneracy(const Periodic_audit_input<d>& mesh, const Coordinates<d>& grid,
                               const Degeneracy_options<d>& options) {
    const auto vertices = std::count_if(mesh.points.begin(), mesh.points.end(),
                                        [](const Coordinates<d>& p) { return !std::isnan(p[0]); });
    return Periodic_scan<d>(mesh, grid, static_cast<std::size_t>(vertices), options).result();
}

template Degeneracy periodic_degeneracy(const Periodic_audit_input<2>&, const Coordinates<2>&,
                                        const Degeneracy_options<2>&);
template Degeneracy periodic_degeneracy(const Periodic_audit_input<3>&, const Coordinates<3>&,
                                        const Degeneracy_options<3>&);

}  // namespace annulus::inline v1
