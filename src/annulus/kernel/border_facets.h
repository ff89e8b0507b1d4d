// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/facet_side.h>
#include <annulus/mesh/site_hash.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

/// The facets between a cavity and the cells outside, found by their corners.
template <int d>
class Border_facets {
  public:
    struct Facet {
        Facet_side<d> side;  // the side that the cavity is on
        Corner_index beyond;
    };

    void clear() { facets_.clear(); }
    void add(const Facet_side<d>& side, Corner_index beyond) { facets_.push_back({side, beyond}); }
    /// To be called when all facets have been added, before any is searched. Calls twice(k, j) for two that have the
    /// same corners. Expected O(k).
    template <class Twice>
    void index(Twice twice);

    [[nodiscard]] std::size_t size() const { return facets_.size(); }
    [[nodiscard]] const Facet& operator[](std::size_t k) const { return facets_[k]; }
    /// Calls visit(k) for each facet with these corners, from either side. Expected O(1).
    template <class Visit>
    void for_each_alike(const Facet_side<d>& s, Visit visit) const {
        for (std::size_t i = first_place(s.sites, place_.size()); place_[i] != 0; i = (i + 1) & (place_.size() - 1))
            if (facets_[place_[i] - 1].side.sites == s.sites) visit(place_[i] - 1);
    }

  private:
    std::vector<Facet> facets_;
    std::vector<std::uint32_t> place_;  // hash table of indices from 1, size a power of two; 0: empty
};

template <int d>
template <class Twice>
void Border_facets<d>::index(Twice twice) {
    std::size_t places = 16;
    while (places < 2 * facets_.size()) places *= 2;
    place_.assign(places, 0);
    for (std::size_t k = 0; k < facets_.size(); ++k) {
        for_each_alike(facets_[k].side, [&](std::size_t j) { twice(k, j); });
        std::size_t i = first_place(facets_[k].side.sites, places);
        while (place_[i] != 0) i = (i + 1) & (places - 1);
        place_[i] = static_cast<std::uint32_t>(k + 1);
    }
}

}  // namespace annulus::inline v1
