// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace annulus {

/// The bytes of a file from first to last, `-` being standard input; where its name ends in .gz (either case), or it
/// begins as gzip does, those that gzip packed in it, all members one after the other.
///
/// Devices, which may have no end, are refused by any name but `-`. What foreign_kind knows is refused by what it is.
///
/// Not zlib's gzread: that takes a damaged second member for the end of the file, and says nothing.
class File_bytes {
  public:
    /// Throws Input_error when the file is missing, a directory, a device or unreadable.
    explicit File_bytes(const std::filesystem::path& file);
    ~File_bytes();
    File_bytes(const File_bytes&) = delete;
    File_bytes& operator=(const File_bytes&) = delete;

    /// Appends the next bytes to `content`, 64 KiB at most; false at the end. Throws Input_error when the file cannot
    /// be read further, what is packed in it is damaged or cut off, or it is of a foreign kind.
    bool more(std::string& content);

    /// "standard input", where it is that.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    /// Where its name does not say so, known once some of it is read.
    [[nodiscard]] bool packed() const noexcept { return inflater_ != nullptr; }
    /// Bytes of the file read so far, packed ones where they are.
    [[nodiscard]] std::uint64_t taken() const noexcept { return taken_; }
    /// How many there are; none where it is no regular file.
    [[nodiscard]] std::optional<std::uint64_t> size() const;

  private:
    struct Inflater;
    [[noreturn]] void fail(std::string fault, std::string expected) const;
    void look_at_beginning();
    bool take(std::string& content);
    bool fill();
    bool inflate(std::string& content);

    std::string name_;
    bool standard_input_;
    bool begun_ = false;
    bool told_ = false;  ///< its first bytes are of no foreign kind
    int file_ = -1;      ///< descriptor
    std::string block_;  ///< as read from the file, not yet handed out or inflated
    std::unique_ptr<Inflater> inflater_;
    std::uint64_t taken_ = 0;
};

/// Is this standard input, `-`? A file of that name is `./-`.
[[nodiscard]] bool is_standard_input(const std::filesystem::path& file);

}  // namespace annulus
