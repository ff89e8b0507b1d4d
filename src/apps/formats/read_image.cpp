// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/file_bytes.h>
#include <apps/formats/format.h>
#include <apps/formats/read_image.h>
#include <apps/formats/text_input.h>

#include <map>

namespace annulus::inline v1 {

namespace {

constexpr std::uint64_t most_voxels = std::uint64_t{1} << 32;
constexpr std::size_t longest_header = 1 << 16;

/// KEY=value, and the line of each.
struct Header {
    std::map<std::string, std::pair<std::string, std::uint64_t>, std::less<>> value;
    std::size_t length = 0;
    std::uint64_t last_line = 1;
};

Header header_of(const Source& source, Line_reader& reader) {
    Header header;
    if (!reader.next_line() || reader.line() != "#INRIMAGE-4#{")
        reader.fail("begins with " + shown(reader.line()), "#INRIMAGE-4#{");
    while (true) {
        if (!reader.next_line())
            reader.fail(source.content.size() < longest_header ? "the file ends within its header"
                                                               : "the header is longer than 64 KiB",
                        "##}");
        const std::string_view line = reader.line();
        if (line == "##}") break;
        const std::size_t equals = line.find('=');
        if (equals != std::string_view::npos)
            header.value[std::string(line.substr(0, equals))] = {std::string(line.substr(equals + 1)), reader.number()};
    }
    header.length = source.content.size() - reader.rest().size();
    header.last_line = reader.number();
    if (header.length % 256 != 0)
        reader.fail("the header has " + std::to_string(header.length) + " bytes", "a multiple of 256");
    return header;
}

}  // namespace

Labelled_image read_image(const std::filesystem::path& file) {
    if (!has_extension_of(file, Format::inr))
        throw Input_error(Error_code::bad_input, file.string(), 0, "has an unknown extension", ".inr or .inr.gz");
    File_bytes bytes(file);
    Source source{bytes.name(), {}};
    // The header determines the length: nothing is unpacked beyond it.
    while (source.content.size() < longest_header && bytes.more(source.content)) continue;
    if (source.content.empty()) throw Input_error(Error_code::bad_input, source.name, 1, "is empty", "data");
    Line_reader reader(source);
    const Header header = header_of(source, reader);
    const auto get = [&](std::string_view key) -> const std::string& {
        const auto at = header.value.find(key);
        if (at == header.value.end()) reader.fail("the header has no " + std::string(key), std::string(key) + "=");
        return at->second.first;
    };
    const auto require = [&](std::string_view key, std::string_view wanted) {
        if (get(key) != wanted)
            throw Input_error(Error_code::bad_input, source.name, header.value.find(key)->second.second,
                              std::string(key) + " is " + shown(get(key)), std::string(wanted));
    };
    require("TYPE", "unsigned fixed");
    require("PIXSIZE", "8 bits");
    if (header.value.contains("VDIM")) require("VDIM", "1");

    Labelled_image image;
    const std::string axes = "XYZ";
    std::uint64_t voxels = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string dim = axes[k] + std::string("DIM"), length = "V" + std::string(1, axes[k]);
        image.size[k] = reader.whole(get(dim), dim);
        if (image.size[k] == 0 || image.size[k] > 1u << 20) reader.fail(dim + " is " + get(dim), "1 to 2^20");
        voxels *= image.size[k];
        if (voxels > most_voxels) reader.fail("more than 2^32 voxels", "fewer");
        if (header.value.contains(length)) image.spacing[k] = reader.real(get(length), length);
        if (!(image.spacing[k] > 1e-100 && image.spacing[k] < 1e100))
            reader.fail(length + " is " + get(length), "an edge length, between 1e-100 and 1e100");
    }
    const std::uint64_t most = header.length + voxels;
    while (source.content.size() <= most && bytes.more(source.content)) continue;
    if (source.content.size() != most)
        reader.fail("has " +
                        (source.content.size() > most ? "more than " + std::to_string(voxels)
                                                      : std::to_string(source.content.size() - header.length)) +
                        " bytes after its header",
                    std::to_string(voxels) + ", one a voxel");
    const auto* first = reinterpret_cast<const std::uint8_t*>(source.content.data() + header.length);
    image.label.assign(first, first + voxels);
    return image;
}

}  // namespace annulus::inline v1
