// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/read_gray_image.h>

#include <charconv>
#include <vector>

namespace annulus::inline v1 {

namespace {

/// Words between white space; # starts a comment that goes to the end of its line.
class Tokens {
  public:
    explicit Tokens(const Source& source) : name_(source.name), rest_(source.content) {}

    /// A whole number from `least` to `most`; `noun` names it in the fault.
    std::uint64_t whole(const std::string& noun, std::uint64_t least, std::uint64_t most) {
        const std::string_view word = next();
        const std::string range = noun + ", from " + std::to_string(least) + " to " + std::to_string(most);
        if (word.empty()) fail("the file ends", range);
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size() || value < least || value > most)
            fail(noun + " is " + shown(word), range);
        return value;
    }

    /// Empty at the end of the file.
    std::string_view next() {
        while (!rest_.empty() && (is_space(rest_.front()) || rest_.front() == '#')) {
            if (rest_.front() == '#') rest_.remove_prefix(std::min(rest_.find_first_of("\n\r"), rest_.size()));
            else take();
        }
        std::size_t size = 0;
        while (size < rest_.size() && !is_space(rest_[size])) ++size;
        const std::string_view word = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return word;
    }

    void take() {
        if (rest_.front() == '\n') ++line_;
        rest_.remove_prefix(1);
    }
    [[nodiscard]] std::string_view rest() const { return rest_; }
    [[nodiscard]] std::uint64_t line() const { return line_; }
    [[noreturn]] void fail(std::string fault, std::string expected) const {
        throw Input_error(Error_code::bad_input, name_, line_, std::move(fault), std::move(expected));
    }

  private:
    static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

    const std::string& name_;
    std::string_view rest_;
    std::uint64_t line_ = 1;
};

/// The samples of P2 or P3: words.
std::vector<std::uint16_t> plain_samples(Tokens& words, std::uint64_t samples, std::uint64_t white) {
    if (words.rest().size() < 2 * samples)
        words.fail("is too short for " + std::to_string(samples) + " values", "a value for each pixel and channel");
    std::vector<std::uint16_t> values;
    values.reserve(samples);
    for (std::uint64_t i = 0; i < samples; ++i)
        values.push_back(static_cast<std::uint16_t>(words.whole("a value", 0, white)));
    if (const std::string_view more = words.next(); !more.empty())
        words.fail("goes on with " + shown(more), "one picture");
    return values;
}

/// Those of P5 or P6: a byte each, or two where white is above 255, the higher one first. `channels` is for faults.
std::vector<std::uint16_t> binary_samples(Tokens& words, std::uint64_t samples, std::uint64_t white,
                                          std::uint64_t channels) {
    const std::uint64_t bytes = white > 255 ? 2 : 1;
    if (!words.rest().empty()) words.take();  // one white space before the values
    const std::string_view data = words.rest();
    if (data.size() != samples * bytes)
        words.fail("has " + counted(data.size(), "byte") + " after its header",
                   std::to_string(samples * bytes) + " for one picture");
    std::vector<std::uint16_t> values;
    values.reserve(samples);
    for (std::uint64_t i = 0; i < samples; ++i) {
        const auto byte = [&](std::uint64_t k) {
            return static_cast<unsigned>(static_cast<unsigned char>(data[bytes * i + k]));
        };
        const unsigned value = bytes == 1 ? byte(0) : 256 * byte(0) + byte(1);
        if (value > white)
            words.fail("pixel " + std::to_string(i / channels + 1) + " is " + std::to_string(value),
                       "a value up to " + std::to_string(white));
        values.push_back(static_cast<std::uint16_t>(value));
    }
    return values;
}

}  // namespace

Gray_image read_pnm(const Source& source, bool coloured) {
    Tokens words(source);
    const std::string plain = coloured ? "P3" : "P2", binary = coloured ? "P6" : "P5";
    const std::string_view magic = words.next();
    if (magic != plain && magic != binary) words.fail("begins with " + shown(magic), plain + " or " + binary);
    constexpr std::uint64_t most = std::uint64_t{1} << 32;
    const std::uint64_t width = words.whole("the width", 1, most), height = words.whole("the height", 1, most);
    Gray_image image;
    set_size(image, width, height, source.name, words.line());
    image.white = static_cast<std::uint16_t>(words.whole("the value of white", 1, 65535));
    const std::uint64_t channels = coloured ? 3 : 1, samples = width * height * channels;
    image.value = magic == plain ? plain_samples(words, samples, image.white)
                                 : binary_samples(words, samples, image.white, channels);
    if (!coloured) return image;
    for (std::uint64_t i = 0; i < width * height; ++i)
        image.value[i] = luma(image.value[3 * i], image.value[3 * i + 1], image.value[3 * i + 2]);
    image.value.resize(width * height);
    return image;
}

}  // namespace annulus::inline v1
