// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/markup.h>
#include <apps/formats/write_pvd.h>

namespace annulus::inline v1 {

std::string write_pvd(std::span<const Pvd_entry> series) {
    std::string out =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n  <Collection>\n";
    for (const Pvd_entry& entry : series)
        out += "    <DataSet timestep=\"" + std::to_string(entry.time) + "\" part=\"0\" file=\"" + escaped(entry.file) +
               "\"/>\n";
    return out + "  </Collection>\n</VTKFile>\n";
}

}  // namespace annulus::inline v1
