// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/read_rings.h>

#include <apps/formats/file_bytes.h>
#include <apps/formats/format.h>
#include <apps/formats/text_input.h>

namespace annulus::inline v1 {

Ring_file read_rings(const std::filesystem::path& file) {
    Ring_file rings{read_points<2>(file), {0}};
    const Format format = format_of(file, point_formats);
    if (format != Format::xyz && format != Format::csv) return rings;
    const std::vector<std::uint64_t>& lines = rings.corners.lines;
    File_bytes bytes(file);
    Line_reader reader(bytes);
    bool blank = false;
    for (std::size_t i = 0; i < lines.size() && reader.next_line();) {
        if (reader.line().find_first_not_of(" \t\v\f") == std::string_view::npos) blank = true;
        if (reader.number() != lines[i]) continue;
        if (blank && i > 0) rings.begin.push_back(i);
        blank = false;
        ++i;
    }
    return rings;
}

}  // namespace annulus::inline v1
