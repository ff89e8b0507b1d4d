// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// The format of a file.
enum class Format { xyz, csv, lammps, npy, off, obj, ply, stl, mesh, inr, pnm, png, jpeg };

/// Formats of files with frames, those of them that are written, and formats of files with points.
inline constexpr std::array frame_formats{Format::xyz, Format::csv, Format::lammps, Format::npy};
inline constexpr std::array written_formats{Format::xyz, Format::csv, Format::lammps};
inline constexpr std::array point_formats{Format::xyz, Format::csv, Format::lammps, Format::npy,
                                          Format::off, Format::ply, Format::mesh};
inline constexpr std::array surface_formats{Format::off, Format::obj, Format::ply, Format::stl};
inline constexpr std::array picture_formats{Format::png, Format::jpeg, Format::pnm};

/// The format's name for --format: "xyz", "lammps".
[[nodiscard]] std::string_view name_of(Format format);
[[nodiscard]] std::vector<std::string> names_of(std::span<const Format> formats);

/// The format of a file, one of `accepted`: the one that `requested` names, or by default that of the file's extension
/// (either case, and before .gz). Throws Input_error where the extension is that of another format or of none,
/// Error(usage) where `requested` is invalid, and for standard input without `requested`, which has no extension.
[[nodiscard]] Format format_of(const std::filesystem::path& file, std::span<const Format> accepted,
                               std::string_view requested = {});

/// Whether the file's extension names this format.
[[nodiscard]] bool has_extension_of(const std::filesystem::path& file, Format format);

/// Whether the file's extension is the usual one of this format: .csv, and not .txt.
[[nodiscard]] bool has_usual_extension_of(const std::filesystem::path& file, Format format);

/// Whether the file's name ends in .gz, in either case.
[[nodiscard]] bool is_packed(const std::filesystem::path& file);

}  // namespace annulus::inline v1
