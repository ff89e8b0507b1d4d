// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/formats/file_bytes.h>
#include <annulus/formats/input_error.h>

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <system_error>
#include <utility>

namespace annulus {

namespace {

constexpr std::size_t block_size = 1 << 16;

std::string lower_extension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return extension;
}

}  // namespace

std::string format_extension(const std::filesystem::path& file) {
    const std::string extension = lower_extension(file);
    return extension == ".gz" ? lower_extension(file.stem()) : extension;
}

struct File_bytes::Inflater {
    z_stream stream{};
    bool within = true;  ///< a member is begun and not at its end

    Inflater() {
        if (inflateInit2(&stream, 15 + 16) != Z_OK) throw std::bad_alloc();
    }
    ~Inflater() { inflateEnd(&stream); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
};

File_bytes::~File_bytes() = default;

File_bytes::File_bytes(const std::filesystem::path& file) : name_(file.string()) {
    std::error_code code;
    const auto status = std::filesystem::status(file, code);
    if (status.type() == std::filesystem::file_type::not_found) fail("does not exist", "a file");
    if (std::filesystem::is_directory(status)) fail("is a directory", "a file");
    errno = 0;
    in_.open(file, std::ios::binary);
    if (!in_) fail(std::string("cannot be opened: ") + std::strerror(errno), "a readable file");
    if (lower_extension(file) == ".gz") inflater_ = std::make_unique<Inflater>();
}

void File_bytes::fail(std::string fault, std::string expected) const {
    throw Input_error(Error_code::bad_input, name_, 0, std::move(fault), std::move(expected));
}

/// Reads the next block; false at the end. By blocks rather than by size: pipes have none, and a file may grow meanwhile.
bool File_bytes::fill() {
    block_.resize(block_size);
    in_.read(block_.data(), static_cast<std::streamsize>(block_.size()));
    if (in_.bad()) fail(std::string("cannot be read: ") + std::strerror(errno), "a readable file");
    block_.resize(static_cast<std::size_t>(in_.gcount()));
    taken_ += block_.size();
    return !block_.empty();
}

bool File_bytes::more(std::string& content) {
    if (inflater_) return inflate(content);
    if (!fill()) return false;
    content += block_;
    return true;
}

bool File_bytes::inflate(std::string& content) {
    z_stream& stream = inflater_->stream;
    const std::size_t before = content.size();
    while (content.size() == before) {
        if (stream.avail_in == 0) {
            if (!fill()) {
                if (inflater_->within && taken_ > 0) fail("is cut off", "a gzip file");
                return false;
            }
            stream.next_in = reinterpret_cast<Bytef*>(block_.data());
            stream.avail_in = static_cast<uInt>(block_.size());
            if (!inflater_->within) {  // what follows the end of a member is another one
                if (inflateReset(&stream) != Z_OK) fail("is damaged", "a gzip file");
                inflater_->within = true;
            }
        }
        content.resize(before + block_size);
        stream.next_out = reinterpret_cast<Bytef*>(content.data() + before);
        stream.avail_out = static_cast<uInt>(block_size);
        const int status = ::inflate(&stream, Z_NO_FLUSH);
        content.resize(before + block_size - stream.avail_out);
        if (status == Z_MEM_ERROR) throw std::bad_alloc();
        if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR)
            fail("is no gzip file or damaged", "a gzip file");
        if (status != Z_STREAM_END) continue;
        inflater_->within = stream.avail_in > 0;
        if (inflater_->within && inflateReset(&stream) != Z_OK) fail("is damaged", "a gzip file");
    }
    return true;
}

}  // namespace annulus
