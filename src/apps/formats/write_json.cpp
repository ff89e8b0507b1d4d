// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/write_json.h>

namespace annulus::inline v1 {

std::string write_json(const nlohmann::ordered_json& value) {
    return value.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace annulus::inline v1
