// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/file_bytes.h>
#include <apps/formats/format.h>
#include <apps/formats/input_error.h>

#include <algorithm>

namespace annulus::inline v1 {

namespace {

struct Names {
    Format format;
    std::string_view name;
    std::array<std::string_view, 4> extensions;  ///< the first is the usual one
};

constexpr std::array all_names{
    Names{Format::xyz, "xyz", {".xyz", ".extxyz"}},
    Names{Format::csv, "csv", {".csv", ".tsv", ".txt", ".dat"}},
    Names{Format::lammps, "lammps", {".lammpstrj", ".dump", ".lammpsdump"}},
    Names{Format::npy, "npy", {".npy"}},
    Names{Format::off, "off", {".off"}},
    Names{Format::obj, "obj", {".obj"}},
    Names{Format::ply, "ply", {".ply"}},
    Names{Format::stl, "stl", {".stl"}},
    Names{Format::mesh, "mesh", {".mesh"}},
    Names{Format::inr, "inr", {".inr"}},
    Names{Format::pnm, "pnm", {".pgm", ".ppm", ".pbm", ".pnm"}},
    Names{Format::png, "png", {".png"}},
    Names{Format::jpeg, "jpeg", {".jpg", ".jpeg"}},
};

const Names& names(Format format) { return all_names[static_cast<std::size_t>(format)]; }

std::string lower_extension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return extension;
}

/// ".xyz" for A.XYZ.gz.
std::string format_extension(const std::filesystem::path& file) {
    return is_packed(file) ? lower_extension(file.stem()) : lower_extension(file);
}

bool is_one_of(const Names& names, std::string_view extension) {
    return !extension.empty() &&
           std::find(names.extensions.begin(), names.extensions.end(), extension) != names.extensions.end();
}

/// ".xyz, .csv or .off"
std::string list(std::span<const Format> formats) {
    std::string text;
    for (std::size_t i = 0; i < formats.size(); ++i) {
        if (i > 0) text += i + 1 == formats.size() ? " or " : ", ";
        text += names(formats[i]).extensions[0];
    }
    return text;
}

}  // namespace

std::string_view name_of(Format format) { return names(format).name; }

std::vector<std::string> names_of(std::span<const Format> formats) {
    std::vector<std::string> result;
    for (const Format format : formats) result.emplace_back(name_of(format));
    return result;
}

Format format_of(const std::filesystem::path& file, std::span<const Format> accepted, std::string_view requested) {
    if (!requested.empty()) {
        for (const Format format : accepted)
            if (name_of(format) == requested) return format;
        throw Error(Error_code::usage, "no format of these files is called " + shown(requested));
    }
    if (is_standard_input(file) && accepted.size() > 1)
        throw Error(Error_code::usage, "standard input has no extension: say with --format what it is");
    if (is_standard_input(file)) return accepted.front();
    const std::string extension = format_extension(file);
    for (const Format format : accepted)
        if (is_one_of(names(format), extension)) return format;
    throw Input_error(Error_code::bad_input, file.string(), 0,
                      extension.empty() ? "has no extension" : "has the unknown extension " + shown(extension),
                      list(accepted));
}

bool has_extension_of(const std::filesystem::path& file, Format format) {
    return is_one_of(names(format), format_extension(file));
}

bool has_usual_extension_of(const std::filesystem::path& file, Format format) {
    return format_extension(file) == names(format).extensions[0];
}

bool is_packed(const std::filesystem::path& file) { return lower_extension(file) == ".gz"; }

}  // namespace annulus::inline v1
