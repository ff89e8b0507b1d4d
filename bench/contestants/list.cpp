// SPDX-License-Identifier: GPL-3.0-or-later
#include "contestant.h"

namespace bench {

const std::vector<Named_contestant>& contestants() {
    static const std::vector<Named_contestant> all{
        {"annulus", moving_mesh},
        {"annulus-anew", moving_mesh_anew},
        {"cgal", cgal},
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
