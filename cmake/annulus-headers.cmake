# SPDX-License-Identifier: GPL-3.0-or-later
# The headers that are installed, below src/annulus. Each includes others of them only: the test installed-headers.

# The public ones without CGAL; they include only each other.
set(annulus_plain_headers
    annulus.h
    audit.h
    box.h
    degeneracy.h
    error.h
    moving_mesh.h
    options.h
    periodic_mesh.h
    predicates.h
    types.h
    version.h
    voronoi.h)

# The public ones that include CGAL, and what these need.
set(annulus_view_headers
    moving_delaunay_2.h
    moving_delaunay_3.h
    internal/compiler_flags.h
    internal/dirty_cells.h
    internal/flat_cells.h
    internal/grow.h
    internal/index.h
    internal/mesh_access.h
    internal/moving_delaunay.h
    internal/no_info.h
    internal/originals.h
    internal/traits.h
    internal/traits_2.h
    internal/traits_3.h
    internal/types_2.h
    internal/types_3.h
    internal/update.h
    internal/vertex_numbers.h
    internal/view.h
    internal/view_2.h
    internal/view_3.h
    internal/view_audit.h)
