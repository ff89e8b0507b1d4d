// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace annulus::inline v1 {

/// "a device", "a pipe", "a socket": the kind of what this path, or a link at it, names; empty for files, directories
/// and nothing.
[[nodiscard]] std::string special_kind(const std::filesystem::path& path);

/// Throws Error(bad_input) unless a file may be put at this path: there is nothing, a file, or a link to a file or to
/// nothing. Devices, pipes and sockets are not replaced, nor links to them. `-` is accepted.
void require_replaceable(const std::filesystem::path& file);

/// A text that is written piece by piece: `-` is standard output; a file is written under a temporary name and renamed
/// at the end, all of it or nothing; packed by gzip where the name ends in .gz. Memory does not depend on its length.
class Text_output {
  public:
    /// Throws std::system_error where no file can be made there, and as require_replaceable does; so does commit().
    explicit Text_output(const std::filesystem::path& file);
    /// Removes the file unless it was committed.
    ~Text_output();
    Text_output(const Text_output&) = delete;
    Text_output& operator=(const Text_output&) = delete;

    /// Throws std::system_error when writing fails.
    void write(std::string_view text);
    /// Writes the rest and puts the file in its place; replaces an existing one.
    void commit();

  private:
    struct Deflater;
    [[noreturn]] void fail() const;
    void put(const char* bytes, std::size_t size);
    void deflate(std::string_view text, int flush);

    std::filesystem::path file_, beside_;
    std::FILE* out_ = nullptr;
    std::unique_ptr<Deflater> deflater_;
};

}  // namespace annulus::inline v1
