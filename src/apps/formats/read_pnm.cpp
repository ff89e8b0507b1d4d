// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/printable.h>
#include <apps/formats/read_gray_image.h>

#include <netpbm/pam.h>

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <memory>
#include <mutex>

namespace annulus::inline v1 {

namespace {

/// Netpbm reports errors by longjmp: `header` and `pixels` construct no object between setjmp and their end. Its state
/// is global, so only one object exists at a time.
class Pnm {
  public:
    explicit Pnm(const Source& source)
        : source_(source),
          file_(fmemopen(const_cast<char*>(source.content.data()), source.content.size(), "rb"), std::fclose) {
        if (!file_) throw std::bad_alloc();
        pm_setusererrormsgfn(on_error);
        pm_setusermessagefn([](const char*) {});
        message_[0] = '\0';
    }
    ~Pnm() {
        if (row_ != nullptr) pnm_freepamrow(row_);
        pm_setjmpbuf(nullptr);
        pm_setusererrormsgfn(nullptr);
        pm_setusermessagefn(nullptr);
    }
    Pnm(const Pnm&) = delete;
    Pnm& operator=(const Pnm&) = delete;

    /// Reads up to the pixels.
    bool header() {
        if (setjmp(jump_) != 0) return false;
        pm_setjmpbuf(&jump_);
        pnm_readpaminit(file_.get(), &picture_, PAM_STRUCT_SIZE(tuple_type));
        return true;
    }

    /// Reads all pixels, row by row from the top, as grey values.
    bool pixels(std::uint16_t* to) {
        if (setjmp(jump_) != 0) return false;
        pm_setjmpbuf(&jump_);
        row_ = pnm_allocpamrow(&picture_);
        for (; rows_ < picture_.height; ++rows_) {
            pnm_readpamrow(&picture_, row_);
            write_row(to + std::ptrdiff_t{rows_} * picture_.width);
        }
        return true;
    }

    [[nodiscard]] const pam& picture() const { return picture_; }
    /// Whether values are text.
    [[nodiscard]] bool is_plain() const {
        return picture_.format == PBM_FORMAT || picture_.format == PGM_FORMAT || picture_.format == PPM_FORMAT;
    }
    /// The content that is not read yet.
    [[nodiscard]] std::string_view rest() const { return std::string_view(source_.content).substr(place()); }

    /// The number of bytes that hold the pixels, at least; exactly where they are binary.
    [[nodiscard]] std::uint64_t bytes() const {
        const auto width = static_cast<std::uint64_t>(picture_.width),
                   height = static_cast<std::uint64_t>(picture_.height);
        const std::uint64_t samples = width * height * picture_.depth;
        if (is_plain()) return picture_.format == PBM_FORMAT ? samples : 2 * samples - 1;
        return picture_.format == RPBM_FORMAT ? (width + 7) / 8 * height : samples * picture_.bytes_per_sample;
    }

    /// The line of what was read last; 0 among binary values.
    [[nodiscard]] std::uint64_t line() const {
        if (row_ != nullptr && !is_plain()) return 0;
        const std::string_view read = std::string_view(source_.content).substr(0, place());
        return 1 + static_cast<std::uint64_t>(std::count(read.begin(), read.end() - (read.empty() ? 0 : 1), '\n'));
    }

    [[nodiscard]] static std::string fault() { return "is no whole picture: " + printable(message_); }

  private:
    void write_row(std::uint16_t* to) const {
        for (int i = 0; i < picture_.width; ++i)
            to[i] =
                picture_.depth == 3 ? luma(row_[i][0], row_[i][1], row_[i][2]) : static_cast<std::uint16_t>(row_[i][0]);
    }
    [[nodiscard]] std::size_t place() const { return static_cast<std::size_t>(std::ftell(file_.get())); }
    static void on_error(const char* message) { std::snprintf(message_, sizeof message_, "%s", message); }

    static inline char message_[200];
    static inline std::mutex only_one_;

    std::lock_guard<std::mutex> lock_{only_one_};
    const Source& source_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    pam picture_{};
    tuple* row_ = nullptr;
    int rows_ = 0;
    std::jmp_buf jump_;
};

}  // namespace

Gray_image read_pnm(Source source) {
    const auto fail_at = [&](std::uint64_t line, std::string fault, std::string expected) {
        throw Input_error(Error_code::bad_input, source.name, line, std::move(fault), std::move(expected));
    };
    const std::string any = "a PBM, PGM or PPM picture, P1 to P6";
    // Netpbm leaks what it has read of a header of PAM that is none.
    if (source.content.starts_with("P7")) fail_at(1, "is a PAM picture, P7", any);
    // Netpbm reads the character after each number, so a line end has to follow the last one, too.
    if (source.content.starts_with("P1") || source.content.starts_with("P2") || source.content.starts_with("P3"))
        source.content += '\n';
    Pnm pnm(source);
    const auto fail = [&](std::string fault, std::string expected) {
        fail_at(pnm.line(), std::move(fault), std::move(expected));
    };
    if (!pnm.header()) fail(Pnm::fault(), any);
    const pam& picture = pnm.picture();
    Gray_image image;
    set_size(image, static_cast<std::uint64_t>(picture.width), static_cast<std::uint64_t>(picture.height), source.name,
             pnm.line());
    const std::size_t left = pnm.rest().size();
    if (left < pnm.bytes() || (!pnm.is_plain() && left > pnm.bytes()))
        fail("has " + counted(left, "byte") + " after its header",
             std::to_string(pnm.bytes()) + (pnm.is_plain() ? " at least for its values" : " for one picture"));
    image.white = static_cast<std::uint16_t>(picture.maxval);
    image.value.resize(image.width * image.height);
    if (!pnm.pixels(image.value.data()))
        fail(Pnm::fault(), "a value from 0 to " + std::to_string(picture.maxval) + " for each pixel and channel");
    if (const std::size_t more = pnm.rest().find_first_not_of(" \t\n\v\f\r"); more != std::string_view::npos)
        fail("goes on after its picture", "one picture");
    return image;
}

}  // namespace annulus::inline v1
