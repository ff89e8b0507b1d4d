// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/neighbours.h>
#include <annulus/types.h>

#include <vector>

/// Delaunay neighbours of points by CGAL, triangulated from scratch. Points must differ.
annulus::Neighbours_2 neighbours_of(const std::vector<annulus::Coordinates<2>>& points);
