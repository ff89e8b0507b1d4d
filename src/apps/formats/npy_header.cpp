// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/formats/input_error.h>
#include <apps/formats/npy_header.h>

#include <charconv>

namespace annulus::inline v1 {

namespace {

/// The literal of a Python dictionary, as far as NumPy writes it.
class Dictionary {
  public:
    explicit Dictionary(std::string_view text) : rest_(text) {}

    Npy_header read() {
        Npy_header header;
        bool has_type = false, has_order = false, has_shape = false;
        require('{');
        while (!take('}')) {
            const std::string key = text();
            require(':');
            if (key == "descr") {
                header.type = text();
                has_type = true;
            } else if (key == "fortran_order") {
                header.fortran_order = truth();
                has_order = true;
            } else if (key == "shape") {
                header.shape = numbers();
                has_shape = true;
            } else {
                fail("has the key " + shown(key));
            }
            if (take('}')) break;
            require(',');
        }
        if (!has_type || !has_order || !has_shape) fail("lacks descr, fortran_order or shape");
        return header;
    }

  private:
    [[noreturn]] static void fail(const std::string& what) {
        throw Error(Error_code::bad_input, "the header of the array " + what);
    }
    void skip_blanks() {
        while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\n')) rest_.remove_prefix(1);
    }
    bool take(char c) {
        skip_blanks();
        if (rest_.empty() || rest_[0] != c) return false;
        rest_.remove_prefix(1);
        return true;
    }
    void require(char c) {
        if (!take(c)) fail("has no '" + std::string(1, c) + "' before " + shown(rest_));
    }
    std::string text() {
        const char quote = take('"') ? '"' : '\'';
        if (quote == '\'' && !take('\'')) fail("has no text before " + shown(rest_) + " (records are not supported)");
        const std::size_t end = rest_.find(quote);
        if (end == std::string_view::npos) fail("ends within a text");
        std::string result(rest_.substr(0, end));
        rest_.remove_prefix(end + 1);
        return result;
    }
    bool truth() {
        skip_blanks();
        for (const std::string_view word : {"True", "False"})
            if (rest_.starts_with(word)) {
                rest_.remove_prefix(word.size());
                return word == "True";
            }
        fail("has neither True nor False before " + shown(rest_));
    }
    std::vector<std::uint64_t> numbers() {
        std::vector<std::uint64_t> result;
        require('(');
        while (!take(')')) {
            skip_blanks();
            std::uint64_t value = 0;
            const auto [end, code] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
            if (code != std::errc()) fail("has no length of 64 bits before " + shown(rest_));
            rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
            result.push_back(value);
            if (take(')')) break;
            require(',');
        }
        return result;
    }

    std::string_view rest_;
};

}  // namespace

Npy_header parse_npy_header(std::string_view text) { return Dictionary(text).read(); }

}  // namespace annulus::inline v1
