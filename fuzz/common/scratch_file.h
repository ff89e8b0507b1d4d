// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files for readers: in a directory of the process, packed or as they are.

#include <unistd.h>
#include <zlib.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace annulus::fuzz {

inline std::string gzip(std::string_view text) {
    z_stream s{};
    if (deflateInit2(&s, 1, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK) std::abort();
    std::string out(deflateBound(&s, text.size()), '\0');
    std::string in(text);
    s.next_in = reinterpret_cast<Bytef*>(in.data());
    s.avail_in = static_cast<uInt>(in.size());
    s.next_out = reinterpret_cast<Bytef*>(out.data());
    s.avail_out = static_cast<uInt>(out.size());
    if (deflate(&s, Z_FINISH) != Z_STREAM_END) std::abort();
    out.resize(s.total_out);
    deflateEnd(&s);
    return out;
}

/// A directory of this process, removed at its end.
class Scratch {
  public:
    Scratch() : path_(std::filesystem::temp_directory_path() / ("annulus-fuzz-readers-" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(path_);
    }
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    std::filesystem::path file(const std::string& name, std::string_view content) const {
        std::filesystem::path path = path_ / name;
        std::ofstream(path, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
        return path;
    }

  private:
    std::filesystem::path path_;
};

}  // namespace annulus::fuzz
