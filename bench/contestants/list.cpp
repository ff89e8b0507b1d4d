// SPDX-License-Identifier: GPL-3.0-or-later
#include "contestant.h"

namespace bench {

template <>
const std::vector<Named_contestant<2>>& contestants<2>() {
    static const std::vector<Named_contestant<2>> all{
        {"annulus", moving_mesh<2>},
        {"annulus-anew", moving_mesh_anew<2>},
        {"cgal", cgal<2>},
    };
    return all;
}

template <>
const std::vector<Named_contestant<3>>& contestants<3>() {
    static const std::vector<Named_contestant<3>> all{
        {"annulus", moving_mesh<3>},
        {"annulus-anew", moving_mesh_anew<3>},
        {"cgal", cgal<3>},
#ifdef ANNULUS_PEERS_GEOGRAM
        {"geogram", geogram},
#endif
#ifdef ANNULUS_PEERS_HXT
        {"hxt", hxt},
        {"hxt-reordering", hxt_reordering},
#endif
    };
    return all;
}

}  // namespace bench
