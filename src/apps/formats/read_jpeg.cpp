// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/exif_orientation.h>
#include <apps/formats/read_gray_image.h>

#include <cstdio>  // which jpeglib.h needs

#include <jpeglib.h>

#include <jerror.h>

#include <csetjmp>

namespace annulus::inline v1 {

namespace {

constexpr int most_scans = 500;  ///< of a progressive picture, which has a dozen: each costs time for every pixel

/// libjpeg reports errors by longjmp: `header` and `pixels` construct no object between setjmp and their end.
class Jpeg {
  public:
    explicit Jpeg(const Source& source) : content_(source.content) {
        jpeg_std_error(&errors_);
        errors_.error_exit = on_error;
        errors_.emit_message = on_message;
        errors_.output_message = [](j_common_ptr) {};
        progress_.progress_monitor = on_progress;
        jpeg_.err = &errors_;
        jpeg_.client_data = this;
    }
    ~Jpeg() { jpeg_destroy_decompress(&jpeg_); }
    Jpeg(const Jpeg&) = delete;
    Jpeg& operator=(const Jpeg&) = delete;

    /// Reads up to the pixels.
    bool header() {
        if (setjmp(jump_) != 0) return false;
        jpeg_CreateDecompress(&jpeg_, JPEG_LIB_VERSION, sizeof jpeg_);
        jpeg_.progress = &progress_;
        jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(content_.data()),
                     static_cast<unsigned long>(content_.size()));
        jpeg_.src->fill_input_buffer = on_end;
        jpeg_save_markers(&jpeg_, exif_marker, 0xffff);
        jpeg_read_header(&jpeg_, TRUE);
        return true;
    }

    /// Reads all pixels, row by row from the top, as grey values; `row` has room for `width()` colours.
    bool pixels(std::uint16_t* to, std::uint8_t* row) {
        if (setjmp(jump_) != 0) return false;
        const bool coloured = jpeg_.jpeg_color_space != JCS_GRAYSCALE;
        jpeg_.out_color_space = coloured ? JCS_RGB : JCS_GRAYSCALE;
        jpeg_start_decompress(&jpeg_);
        while (jpeg_.output_scanline < jpeg_.output_height) {
            JSAMPROW rows[] = {row};
            std::uint16_t* const values = to + jpeg_.output_scanline * width();
            if (jpeg_read_scanlines(&jpeg_, rows, 1) != 1) return false;
            for (std::size_t i = 0; i < width(); ++i)
                values[i] = coloured ? luma(row[3 * i], row[3 * i + 1], row[3 * i + 2]) : row[i];
        }
        jpeg_finish_decompress(&jpeg_);
        return true;
    }

    [[nodiscard]] std::size_t width() const { return jpeg_.image_width; }
    [[nodiscard]] std::size_t height() const { return jpeg_.image_height; }
    [[nodiscard]] const jpeg_decompress_struct& state() const { return jpeg_; }

    /// Squares of 8 by 8 values, each of which takes a bit of the file, or more, in Huffman's code.
    [[nodiscard]] std::uint64_t blocks() const {
        std::uint64_t sum = 0;
        for (int k = 0; k < jpeg_.num_components; ++k)
            sum += std::uint64_t{jpeg_.comp_info[k].width_in_blocks} * jpeg_.comp_info[k].height_in_blocks;
        return sum;
    }

    [[nodiscard]] int orientation() const {
        for (auto* marker = jpeg_.marker_list; marker != nullptr; marker = marker->next)
            if (marker->marker == exif_marker)
                if (const int found = exif_orientation(
                        {reinterpret_cast<const char*>(marker->data), static_cast<std::size_t>(marker->data_length)});
                    found != 0)
                    return found;
        return 1;
    }

    /// What libjpeg said last; throws where memory ran out.
    [[nodiscard]] std::string fault() const {
        if (errors_.msg_code == JERR_OUT_OF_MEMORY) throw std::bad_alloc();
        return message_;
    }

  private:
    static constexpr int exif_marker = JPEG_APP0 + 1;

    [[noreturn]] static void give_up(j_common_ptr jpeg, const char* message) {
        auto* const self = static_cast<Jpeg*>(jpeg->client_data);
        std::snprintf(self->message_, sizeof self->message_, "%s", message);
        std::longjmp(self->jump_, 1);
    }
    static void on_error(j_common_ptr jpeg) {
        char message[JMSG_LENGTH_MAX];
        jpeg->err->format_message(jpeg, message);
        give_up(jpeg, message);
    }
    /// Warnings (a level below 0) are of damaged data, but for those of versions.
    static void on_message(j_common_ptr jpeg, int level) {
        const int code = jpeg->err->msg_code;
        if (level < 0 && code != JWRN_JFIF_MAJOR && code != JWRN_ADOBE_XFORM) on_error(jpeg);
    }
    static boolean on_end(j_decompress_ptr jpeg) { give_up(reinterpret_cast<j_common_ptr>(jpeg), "the file ends"); }
    static void on_progress(j_common_ptr jpeg) {
        if (jpeg->is_decompressor != 0 && reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > most_scans)
            give_up(jpeg, "it has more than 500 scans");
    }

    jpeg_decompress_struct jpeg_{};
    jpeg_error_mgr errors_{};
    jpeg_progress_mgr progress_{};
    std::jmp_buf jump_;
    char message_[JMSG_LENGTH_MAX] = {};
    std::string_view content_;
};

}  // namespace

Gray_image read_jpeg(const Source& source) {
    Jpeg jpeg(source);
    const auto fail = [&](std::string fault, std::string expected) {
        throw Input_error(Error_code::bad_input, source.name, 0, std::move(fault), std::move(expected));
    };
    if (!jpeg.header()) fail("is no whole JPEG: " + shown(jpeg.fault()), "a JPEG image");
    const auto& state = jpeg.state();
    const J_COLOR_SPACE colours = state.jpeg_color_space;
    if (colours == JCS_CMYK || colours == JCS_YCCK) fail("has the colours of print, CMYK", "a picture in grey or RGB");
    if (colours != JCS_GRAYSCALE && colours != JCS_YCbCr && colours != JCS_RGB)
        fail("has " + counted(static_cast<std::size_t>(state.num_components), "component"), "a picture in grey or RGB");
    if (state.arith_code) fail("has the arithmetic code", "a JPEG image in Huffman's code");
    Gray_image image;
    set_size(image, jpeg.width(), jpeg.height(), source.name, 0);
    if (jpeg.blocks() / 8 > source.content.size())
        fail("announces " + std::to_string(jpeg.width()) + " by " + std::to_string(jpeg.height()) + " pixels in " +
                 counted(source.content.size(), "byte"),
             "a file that can hold them");
    const int orientation = jpeg.orientation();
    image.white = 255;
    image.value.resize(image.width * image.height);
    std::vector<std::uint8_t> row(3 * image.width);
    if (!jpeg.pixels(image.value.data(), row.data())) fail("is no whole JPEG: " + shown(jpeg.fault()), "a JPEG image");
    return turned(std::move(image), orientation);
}

}  // namespace annulus::inline v1
