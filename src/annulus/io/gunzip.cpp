// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/io/gunzip.h>

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>

namespace annulus {

Source gunzip(const Source& packed, std::uint64_t most) {
    Source out{packed.name, {}};
    const auto fail = [&](const std::string& fault, const char* expected) {
        throw Input_error(Error_code::bad_input, packed.name, 0, fault, expected);
    };
    if (packed.content.size() > std::numeric_limits<uInt>::max()) fail("is 4 GiB or more", "a smaller file");
    z_stream stream{};
    if (inflateInit2(&stream, 15 + 16) != Z_OK) throw std::bad_alloc();
    const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, inflateEnd);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.content.data()));  // zlib does not write there
    stream.avail_in = static_cast<uInt>(packed.content.size());
    std::string block(1 << 16, '\0');
    while (true) {
        stream.next_out = reinterpret_cast<Bytef*>(block.data());
        stream.avail_out = static_cast<uInt>(block.size());
        const int status = inflate(&stream, Z_NO_FLUSH);
        out.content.append(block, 0, block.size() - stream.avail_out);
        if (out.content.size() > most) fail("holds more than " + std::to_string(most) + " bytes", "a smaller image");
        if (status == Z_STREAM_END) {
            if (stream.avail_in == 0) return out;
            if (inflateReset(&stream) != Z_OK) fail("is damaged", "a gzip file");
        } else if (status == Z_MEM_ERROR) {
            throw std::bad_alloc();
        } else if (status != Z_OK || (stream.avail_in == 0 && stream.avail_out != 0)) {
            fail(status == Z_OK || status == Z_BUF_ERROR ? "is cut off" : "is no gzip file or damaged", "a gzip file");
        }
    }
}

}  // namespace annulus
