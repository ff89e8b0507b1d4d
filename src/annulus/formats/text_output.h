// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace annulus {

/// A text that is written bit by bit: `-` is standard output; a file is written beside its name and gets it in the end, all of
/// it or nothing; packed by gzip where the name ends in .gz. Memory does not depend on its length.
class Text_output {
  public:
    /// Throws std::system_error where no file can be made there.
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
