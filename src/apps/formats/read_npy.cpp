// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/file_bytes.h>
#include <apps/formats/npy_frames.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr std::string_view npy_magic = "\x93NUMPY";
constexpr const char* npy_arrays = "floats or integers of 4 or 8 bytes, frames x points x 2 or 3, or points x 2 or 3";
constexpr std::size_t longest_npy_header = 1 << 16;
constexpr std::array<const char*, 3> npy_axes{"x", "y", "z"};

/// `width` bytes as an integer.
std::uint64_t bits_of(std::string_view bytes, bool big) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[big ? i : bytes.size() - 1 - i]);
    return value;
}

std::string shape_in_words(const std::vector<std::uint64_t>& shape) {
    std::string text = "(";
    for (const std::uint64_t length : shape) text += (text.size() > 1 ? ", " : "") + std::to_string(length);
    return text + ")";
}

}  // namespace

Npy_frames::Npy_frames(File_bytes& bytes, const Frame_options& options) : Frame_reader(bytes, options), bytes_(bytes) {
    bytes.accept(Foreign::numpy);
}

void Npy_frames::fail(std::uint64_t record, std::string fault, std::string expected, Error_code code) const {
    throw Input_error(code, bytes_.name(), std::max<std::uint64_t>(record, 1), std::move(fault), std::move(expected));
}

/// Reads on until `size` bytes are in the buffer; false where the file ends before.
bool Npy_frames::fill(std::size_t size) {
    while (buffer_.size() - passed_ < size) {
        buffer_.erase(0, std::exchange(passed_, 0));
        const std::size_t before = buffer_.size();
        if (!bytes_.more(buffer_)) return false;
        taken_ += buffer_.size() - before;
        require_no_bomb(bytes_, taken_, 1);
    }
    return true;
}

void Npy_frames::begin() {
    begun_ = true;
    const auto cut_off = [this] { fail(1, "is cut off within its header", "an array of NumPy"); };
    if (!fill(npy_magic.size() + 2) || !std::string_view(buffer_).starts_with(npy_magic))
        fail(1, buffer_.empty() ? "is empty" : "is no array of NumPy", "an array of NumPy, as numpy.save writes it");
    const char major = buffer_[npy_magic.size()];
    if (major < 1 || major > 3) fail(1, "is of version " + std::to_string(major), "version 1, 2 or 3 of .npy");
    const std::size_t length_bytes = major == 1 ? 2 : 4, begins = npy_magic.size() + 2 + length_bytes;
    if (!fill(begins)) cut_off();
    const std::uint64_t length = bits_of(std::string_view(buffer_).substr(begins - length_bytes, length_bytes), false);
    if (length > longest_npy_header) fail(1, "has a header of " + std::to_string(length) + " bytes", "65536 at most");
    if (!fill(begins + static_cast<std::size_t>(length))) cut_off();
    Npy_header header;
    try {
        header = parse_npy_header(std::string_view(buffer_).substr(begins, static_cast<std::size_t>(length)));
    } catch (const Error& error) {
        fail(1, error.what(), npy_arrays);
    }
    passed_ = begins + static_cast<std::size_t>(length);
    const std::string& type = header.type;
    const bool numbers = type.size() == 3 && std::string_view("<>").find(type[0]) != std::string_view::npos &&
                         std::string_view("fiu").find(type[1]) != std::string_view::npos &&
                         (type[2] == '4' || type[2] == '8');
    if (!numbers) fail(1, "has elements of type " + shown(type), npy_arrays);
    big_ = type[0] == '>';
    kind_ = type[1];
    width_ = type[2] == '4' ? 4 : 8;
    const auto& shape = header.shape;
    const bool fits = (shape.size() == 2 || shape.size() == 3) && (shape.back() == 2 || shape.back() == 3);
    if (!fits) fail(1, "has the shape " + shape_in_words(shape), npy_arrays);
    if (header.fortran_order) fail(1, "is in Fortran's order", "C's, which numpy.ascontiguousarray gives");
    d_ = static_cast<std::size_t>(shape.back());
    points_ = shape[shape.size() - 2];
    frames_ = shape.size() == 3 ? shape[0] : 1;
    if (points_ == 0) fail(1, "has no points", "at least one");
    (void)reader_.room_for(points_, d_ * width_, "points");
    Taken_columns taken;
    if (wants_ids()) taken.emplace_back("id", place_as_id);
    for (std::size_t k = 0; k < d_; ++k)
        taken.emplace_back(npy_axes[k], (shape.size() == 3 ? "[:, :, " : "[:, ") + std::to_string(k) + "]");
    take_columns(std::move(taken));
}

bool Npy_frames::seek() {
    if (!begun_) begin();
    if (next_ < frames_) return true;
    if (fill(1)) fail(1, "has more numbers than its shape says", "the end of the file");
    return false;
}

double Npy_frames::value(std::size_t at, std::uint64_t record, std::size_t axis) const {
    const std::uint64_t bits = bits_of(std::string_view(buffer_).substr(passed_ + at, width_), big_);
    if (kind_ == 'f')
        return width_ == 8 ? std::bit_cast<double>(bits) : std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    const auto integer = width_ == 8 ? static_cast<std::int64_t>(bits)
                                     : std::int64_t{std::bit_cast<std::int32_t>(static_cast<std::uint32_t>(bits))};
    constexpr std::int64_t most = std::int64_t{1} << 53;
    const bool exact = kind_ == 'u' ? bits <= static_cast<std::uint64_t>(most) : integer >= -most && integer <= most;
    if (!exact)
        fail(record,
             std::string(npy_axes[axis]) + " is " + (kind_ == 'u' ? std::to_string(bits) : std::to_string(integer)),
             "integers of at most 2^53, which are doubles");
    return kind_ == 'u' ? static_cast<double>(bits) : static_cast<double>(integer);
}

void Npy_frames::read(Raw_frame& frame) {
    taken_ = 0;
    frame.number = next_++;
    frame.ids_are_places = true;
    frame.points.has_z = d_ == 3;
    frame.line = frame.number * points_ + 1;
    for (std::uint64_t i = 0; i < points_; ++i) {
        const std::uint64_t record = frame.line + i;
        if (!fill(d_ * width_))
            fail(record,
                 "the file ends before point " + std::to_string(i) + " of frame " + std::to_string(frame.number),
                 std::to_string(frames_) + " frames of " + counted(points_, "point") + ", as its shape says");
        Coordinates<3> p{};
        bool absent = wants_ids();
        for (std::size_t k = 0; k < d_; ++k) {
            p[k] = value(k * width_, record, k);
            absent = absent && std::isnan(p[k]);
        }
        passed_ += d_ * width_;
        if (absent) continue;
        for (std::size_t k = 0; k < d_; ++k)
            if (!std::isfinite(p[k]))
                fail(record, std::string(npy_axes[k]) + (std::isnan(p[k]) ? " is nan" : " is infinite"),
                     "a finite number", Error_code::not_finite);
        frame.points.points.push_back(p);
        frame.points.lines.push_back(record);
        if (wants_ids()) frame.id.push_back(i);
    }
}

void Npy_frames::refuse_more(const Raw_frame&) const {
    fail(1, "has " + std::to_string(frames_) + " frames", "one frame");
}

}  // namespace annulus::inline v1
