// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/certificate_terms.h>

#include <string_view>

namespace annulus::inline v1 {

namespace {

/// The word for 2D, for 3D, or both.
std::string word_of(const Certificate_terms& of, std::string_view plane, std::string_view space) {
    if (!of.space) return std::string(plane);
    if (!of.plane) return std::string(space);
    return std::string(plane) + " (2D) or " + std::string(space) + " (3D)";
}

}  // namespace

Terms certificate_terms(const Certificate_terms& of) {
    return {
        {"Bi-cell", "Two " + word_of(of, "triangles that share an edge", "tetrahedra that share a triangle") + "."},
        {"Certificate",
         "The sign of a determinant; all of them together prove the triangulation Delaunay. That of a bi-cell says "
         "that the " +
             word_of(of, "circle", "sphere") +
             " through one cell leaves the opposite vertex of the other outside, that of a cell that it is not turned "
             "over" +
             (of.open ? ", that of a hull " + word_of(of, "vertex", "edge") + " that the hull is convex there" +
                            (of.boxes ? " (in a periodic box there is none)" : "")
                      : std::string()) +
             "."},
        {"Annulus", "The region between two concentric " + word_of(of, "circles", "spheres") +
                        " with the points of a bi-cell on them; the standard one has those of the shared " +
                        word_of(of, "edge", "triangle") + " on one of them and the two others on the other."},
        {"Slab",
         "The region between two parallel " + word_of(of, "lines", "planes") + " with the points of a cell on them."},
        {"Tolerance",
         "Of a certificate, half of the width of its annulus or slab: as long as none of its points moves further, its "
         "sign stays. Of a vertex, the least of its certificates."},
    };
}

void append_degeneracy_terms(std::string& out, const Certificate_terms& of) {
    Terms terms = certificate_terms(of);
    terms.push_back({"Degenerate", "The determinant of a certificate is 0."});
    terms.push_back({"Theta", "The angle between the axis of the " + word_of(of, "edge", "triangle") +
                                  " that a bi-cell shares and the bisector of its two other vertices."});
    terms.push_back({"Mean spacing", "The " + word_of(of, "square root of the area", "cube root of the volume") +
                                         " of the " +
                                         (!of.boxes ? "hull"
                                          : of.open ? "hull, or of the box,"
                                                    : "box") +
                                         " that one vertex has on average."});
    if (of.open)
        terms.push_back({"Unsound",
                         "A vertex is in a certificate all points of which can go to where it fails and stay within "
                         "the paper's tolerances. The paper: de Castro, Tournois, Alliez and Devillers, Filtering "
                         "relocations on a Delaunay triangulation, 2009."});
    append_terms(out, terms);
}

}  // namespace annulus::inline v1
