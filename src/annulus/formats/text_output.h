// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace annulus {

/// "a device", "a pipe", "a socket": what is at this place or where a link at it leads; empty for files, directories
/// and nothing.
[[nodiscard]] std::string special_kind(const std::filesystem::path& path);

/// Throws Error(bad_input) unless a file may come to this place: nothing is there, a file, or a link to one or to
/// nothing. Devices, pipes and sockets are not replaced, nor links to them. `-` may be.
void require_replaceable(const std::filesystem::path& file);

/// A text that is written bit by bit: `-` is standard output; a file is written beside its name and gets it in the
/// end, all of it or nothing; packed by gzip where the name ends in .gz. Memory does not depend on its length.
class Text_output {
  public:
    /// Throws std::system_error where no file can be made there, and what require_replaceable throws, also when it is
    /// committed.
    explicit Text_output(const std::filesystem::path& file);
    /// Leaves nothing behind that was not committed.
    ~Text_output();
    Text_output(const Text_output&) = delete;
    Text_output& operator=(const Text_output&) = delete;

    /// Throws std::system_error where it cannot be written.
    void write(std::string_view text);
    /// Writes what is left and puts the file in its place, that of another one if there is one.
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

}  // namespace annulus
