// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/formats/file_bytes.h>
#include <apps/formats/format.h>
#include <apps/formats/text_output.h>

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <new>
#include <system_error>
#include <utility>

namespace annulus::inline v1 {

struct Text_output::Deflater {
    z_stream stream{};
    std::array<char, 1 << 16> block{};

    Deflater() {
        if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK)
            throw std::bad_alloc();
    }
    ~Deflater() { deflateEnd(&stream); }
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;
};

void Text_output::fail() const {
    throw std::system_error(errno, std::generic_category(), out_ == stdout ? "standard output" : file_.string());
}

void require_replaceable(const std::filesystem::path& file) {
    if (is_standard_input(file)) return;
    if (const std::string kind = special_kind(file); !kind.empty())
        throw Error(Error_code::bad_input,
                    file.string() + ": is " + kind + ", which no file is to replace; expected a new name, or a file");
}

std::string special_kind(const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);  // follows links
    switch (status.type()) {
        case std::filesystem::file_type::character:
        case std::filesystem::file_type::block: return "a device";
        case std::filesystem::file_type::fifo: return "a pipe";
        case std::filesystem::file_type::socket: return "a socket";
        default: return {};
    }
}

Text_output::Text_output(const std::filesystem::path& file) : file_(file) {
    if (is_standard_input(file)) {
        out_ = stdout;
        return;
    }
    require_replaceable(file);
    if (is_packed(file)) deflater_ = std::make_unique<Deflater>();
    std::error_code ignored;
    errno = EISDIR;
    if (std::filesystem::is_directory(file, ignored)) fail();  // now, not when all is written
    // Never writes through an existing file or link; a file that a killed process left may have our process number, as
    // in containers.
    int descriptor = -1;
    errno = EEXIST;
    for (int tries = 0; descriptor < 0 && errno == EEXIST && tries < 1000; ++tries) {
        beside_ = file;
        beside_ += ".partial-" + std::to_string(::getpid()) + (tries == 0 ? "" : "-" + std::to_string(tries));
        descriptor = ::open(beside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    }
    if (descriptor < 0) fail();
    out_ = ::fdopen(descriptor, "wb");
    if (out_ == nullptr) {
        ::close(descriptor);
        ::unlink(beside_.c_str());
        fail();
    }
}

Text_output::~Text_output() {
    if (out_ == nullptr || out_ == stdout) return;
    std::fclose(out_);
    ::unlink(beside_.c_str());
}

void Text_output::put(const char* bytes, std::size_t size) {
    errno = 0;
    if (std::fwrite(bytes, 1, size, out_) != size) fail();
}

void Text_output::deflate(std::string_view text, int flush) {
    z_stream& stream = deflater_->stream;
    std::string in(text);  // zlib takes a non-const pointer but does not write
    stream.next_in = reinterpret_cast<Bytef*>(in.data());
    stream.avail_in = static_cast<uInt>(in.size());
    do {
        stream.next_out = reinterpret_cast<Bytef*>(deflater_->block.data());
        stream.avail_out = static_cast<uInt>(deflater_->block.size());
        (void)::deflate(&stream, flush);
        put(deflater_->block.data(), deflater_->block.size() - stream.avail_out);
    } while (stream.avail_out == 0);
}

void Text_output::write(std::string_view text) {
    constexpr std::size_t most = std::size_t{1} << 30;  // zlib counts in 32 bits
    if (!deflater_) return put(text.data(), text.size());
    for (; !text.empty(); text.remove_prefix(std::min(most, text.size()))) deflate(text.substr(0, most), Z_NO_FLUSH);
}

void Text_output::commit() {
    if (deflater_) deflate({}, Z_FINISH);
    errno = 0;
    if (std::fflush(out_) != 0) fail();
    if (out_ == stdout) return;
    require_replaceable(file_);  // it may have been made meanwhile
    if (std::fclose(std::exchange(out_, nullptr)) != 0 || ::rename(beside_.c_str(), file_.c_str()) != 0) {
        const int error = errno;
        ::unlink(beside_.c_str());
        errno = error;
        fail();
    }
}

}  // namespace annulus::inline v1
