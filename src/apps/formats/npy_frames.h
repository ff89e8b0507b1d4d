// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/frame_readers.h>
#include <apps/formats/npy_header.h>

#include <cstdint>
#include <string>

namespace annulus::inline v1 {

/// An array of NumPy, .npy of version 1 to 3: frames x points x d, or one frame of points x d, d being 2 or 3, in C
/// order, of floats or integers of 4 or 8 bytes in either order of bytes. The id of a point is its index. A point of a
/// motion all of whose coordinates are NaN is absent from the frame; every other coordinate must be finite. Integers
/// beyond 2^53, which no double is, are refused. A frame is held at a time. The line of a point is its number in the
/// array, from 1.
class Npy_frames : public Frame_reader {
  public:
    Npy_frames(File_bytes& bytes, const Frame_options& options);

  private:
    bool seek() override;
    void read(Raw_frame& frame) override;
    void refuse_more(const Raw_frame& frame) const override;
    [[noreturn]] void fail(std::uint64_t record, std::string fault, std::string expected,
                           Error_code code = Error_code::bad_input) const;
    void begin();
    [[nodiscard]] bool fill(std::size_t size);
    [[nodiscard]] double value(std::size_t at, std::uint64_t record, std::size_t axis) const;

    File_bytes& bytes_;
    std::string buffer_;  ///< bytes read and not yet passed, from passed_ on
    std::size_t passed_ = 0;
    std::uint64_t taken_ = 0;  ///< bytes that were handed out since the frame began
    bool begun_ = false;
    char kind_ = 'f';        ///< of a number: f float, i integer, u without a sign
    std::size_t width_ = 8;  ///< bytes of a number
    bool big_ = false;       ///< the most significant byte first
    std::size_t d_ = 0;
    std::uint64_t frames_ = 0, points_ = 0;
    std::uint64_t next_ = 0;  ///< number of the next frame
};

}  // namespace annulus::inline v1
