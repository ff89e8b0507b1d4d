// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/file_bytes.h>
#include <apps/formats/format.h>
#include <apps/formats/input_error.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr std::size_t block_size = 1 << 16;

}  // namespace

struct File_bytes::Inflater {
    z_stream stream{};
    bool within = true;  ///< a member is begun and not at its end

    Inflater() {
        if (inflateInit2(&stream, 15 + 16) != Z_OK) throw std::bad_alloc();
    }
    ~Inflater() { inflateEnd(&stream); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    /// Sets the input to be inflated next; it must not move meanwhile.
    void take(std::string& block) {
        stream.next_in = reinterpret_cast<Bytef*>(block.data());
        stream.avail_in = static_cast<uInt>(block.size());
    }
};

bool is_standard_input(const std::filesystem::path& file) { return file == "-"; }

File_bytes::~File_bytes() {
    if (file_ >= 0 && !standard_input_) ::close(file_);
}

File_bytes::File_bytes(const std::filesystem::path& file)
    : name_(is_standard_input(file) ? "standard input" : file.string()), standard_input_(is_standard_input(file)) {
    if (standard_input_) {
        file_ = STDIN_FILENO;
        return;
    }
    std::error_code code;
    const auto status = std::filesystem::status(file, code);
    if (status.type() == std::filesystem::file_type::not_found) fail("does not exist", "a file");
    if (std::filesystem::is_directory(status)) fail("is a directory", "a file");
    if (std::filesystem::is_character_file(status) || std::filesystem::is_block_file(status))
        fail("is a device, which may have no end", "a file or a pipe");
    if (is_packed(file)) inflater_ = std::make_unique<Inflater>();
    file_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);  // last: a throwing constructor runs no destructor
    if (file_ < 0) fail(std::string("cannot be opened: ") + std::strerror(errno), "a readable file");
}

std::optional<std::uint64_t> File_bytes::size() const {
    struct stat status {};
    if (::fstat(file_, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return static_cast<std::uint64_t>(status.st_size);
}

std::unique_ptr<File_bytes> File_bytes::again() const {
    return size() && !standard_input_ ? std::make_unique<File_bytes>(name_) : nullptr;
}

void File_bytes::fail(std::string fault, std::string expected) const {
    throw Input_error(Error_code::bad_input, name_, 0, std::move(fault), std::move(expected));
}

/// Reads the next block; false at the end. By blocks rather than by size: pipes have none, and a file may grow
/// meanwhile.
bool File_bytes::fill() {
    block_.resize(block_size);
    ssize_t got = 0;
    do got = ::read(file_, block_.data(), block_.size());
    while (got < 0 && errno == EINTR);
    if (got < 0) fail(std::string("cannot be read: ") + std::strerror(errno), "a readable file");
    block_.resize(static_cast<std::size_t>(got));
    taken_ += block_.size();
    return !block_.empty();
}

/// The first bytes of a file tell whether it is packed; a pipe may deliver them one by one.
void File_bytes::read_beginning() {
    begun_ = true;
    std::string begin;
    while (begin.size() < telling_bytes && fill()) begin += block_;
    block_ = std::move(begin);
    if (!inflater_ && !begins_as_gzip(block_)) return;
    if (!inflater_) inflater_ = std::make_unique<Inflater>();
    inflater_->take(block_);
}

bool File_bytes::take(std::string& content) {
    if (!begun_) read_beginning();
    if (inflater_) return inflate(content);
    if (block_.empty() && !fill()) return false;
    content += block_;
    block_.clear();
    return true;
}

bool File_bytes::more(std::string& content) {
    const std::size_t before = content.size();
    const bool any = take(content);
    if (!std::exchange(told_, true)) {
        const std::string_view begin = std::string_view(content).substr(before);
        const auto kind = foreign_kind(begin);
        if (kind && (kind->kind == Foreign::other || kind->kind != accepted_))
            fail(std::string(kind->fault), std::string(kind->expected));
        if (kind && kind->kind == Foreign::utf16) decoder_ = std::make_unique<Utf16_decoder>(begin);
    }
    if (decoder_) decode(content, before, !any);
    return any;
}

/// Replaces what was just read, from `before` on, by the same in UTF-8.
void File_bytes::decode(std::string& content, std::size_t before, bool ends) {
    const std::string wide = content.substr(before);
    content.resize(before);
    if (!decoder_->append(wide, content)) fail("has half of a pair of surrogates", "text in UTF-16, as it begins");
    if (ends && !decoder_->complete()) fail("ends within a character", "text in UTF-16, as it begins");
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
            inflater_->take(block_);
            if (!inflater_->within) {  // another member follows
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

}  // namespace annulus::inline v1
