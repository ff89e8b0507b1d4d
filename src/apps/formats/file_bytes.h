// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/file_kind.h>
#include <apps/formats/utf16.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace annulus::inline v1 {

/// The bytes of a file from first to last, `-` being standard input; where its name ends in .gz (either case), or it
/// begins like a gzip file, the unpacked bytes, all members one after the other.
///
/// Devices, which may have no end, are refused by any name but `-`. Files that foreign_kind recognises are refused with
/// their kind, unless `accept` names it.
///
/// Not zlib's gzread: that silently takes a damaged second member as the end of the file.
class File_bytes {
  public:
    /// Throws Input_error when the file is missing, a directory, a device or unreadable.
    explicit File_bytes(const std::filesystem::path& file);
    ~File_bytes();
    File_bytes(const File_bytes&) = delete;
    File_bytes& operator=(const File_bytes&) = delete;

    /// A kind that is not refused: arrays of NumPy are handed out as they are, text in UTF-16 as text in UTF-8. To be
    /// called before the first bytes are requested.
    void accept(Foreign kind) noexcept { accepted_ = kind; }

    /// Appends the next bytes to `content`, 96 KiB at most; false at the end. Throws Input_error when the file cannot
    /// be read further, its packed content is damaged or cut off, or it is of a foreign kind.
    bool more(std::string& content);

    /// The name for messages: "standard input" for `-`.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    /// Whether it is packed. Unless the name says so, this is known once some of it is read.
    [[nodiscard]] bool packed() const noexcept { return inflater_ != nullptr; }
    /// Bytes of the file read so far; packed bytes if it is packed.
    [[nodiscard]] std::uint64_t taken() const noexcept { return taken_; }
    /// The size of the file; none where it is not a regular file.
    [[nodiscard]] std::optional<std::uint64_t> size() const;
    /// The same file from its beginning; null where it is not a regular file and can be read only once.
    [[nodiscard]] std::unique_ptr<File_bytes> again() const;

  private:
    struct Inflater;
    [[noreturn]] void fail(std::string fault, std::string expected) const;
    void read_beginning();
    bool take(std::string& content);
    bool fill();
    bool inflate(std::string& content);
    void decode(std::string& content, std::size_t before, bool ends);

    std::string name_;
    bool standard_input_;
    bool begun_ = false;
    bool told_ = false;  ///< whether its first bytes were found not to be of a foreign kind, or of one that is accepted
    Foreign accepted_ = Foreign::other;
    std::unique_ptr<Utf16_decoder> decoder_;
    int file_ = -1;      ///< descriptor
    std::string block_;  ///< as read from the file, not yet handed out or inflated
    std::unique_ptr<Inflater> inflater_;
    std::uint64_t taken_ = 0;
};

/// Whether this is standard input, `-`. A file of that name is `./-`.
[[nodiscard]] bool is_standard_input(const std::filesystem::path& file);

}  // namespace annulus::inline v1
