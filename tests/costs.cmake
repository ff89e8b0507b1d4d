# SPDX-License-Identifier: GPL-3.0-or-later
# Read by ctest, which starts tests of a high COST first. Tests of more than two seconds: `tools/check` prints the list.
# An obsolete name does no harm.
foreach(name IN ITEMS
        "After any calls in space under any strategy the audit passes and the cells are those of a rebuild"
        "A failed call leaves everything as it was, with the right code"
        "A recomputed tolerance in space is never above what its certificates allow and within 0.2 % of it"
        "A lattice, a prism and a sphere that move and return many times are still Delaunay"
        "After a refused call in space the flips that it took back do no harm"
        "bi-cells of space: every stage is sound, tight and has the exact sign"
        "Facets and cells of 3D Voronoi diagrams are those cut out exactly, points of every kind"
        "Volumes of Voronoi cells are those of cells cut out exactly, points of every kind"
        "Whenever a drifting call reports all within tolerance the audit passes"
        "Steady motion that breaks off never leaves a wrong triangulation"
        "sin2 moments of a polygon have the stated relative error")
    set_tests_properties("${name}" PROPERTIES COST 10)
endforeach()
