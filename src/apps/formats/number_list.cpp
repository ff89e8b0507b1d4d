// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/number_list.h>

#include <annulus/error.h>
#include <apps/formats/input_error.h>
#include <apps/formats/parse_double.h>

namespace annulus::inline v1 {

double parse_number(const std::string& option, std::string_view word) {
    double value = 0;
    const Number_kind kind = parse_double(word, value);
    if (kind == Number_kind::finite) return value;
    const bool digits = word.find_first_of("0123456789") != std::string_view::npos;  // and no "inf"
    throw Error(Error_code::usage, option + ": " + shown(word) +
                                       (kind == Number_kind::too_large && digits ? " is beyond what a double can hold"
                                                                                 : " is not a number"));
}

std::vector<double> parse_numbers(const std::string& option, std::string_view words) {
    std::vector<double> numbers;
    for (std::string_view rest = words;;) {
        const std::size_t end = rest.find(',');
        numbers.push_back(parse_number(option, rest.substr(0, end)));
        if (end == std::string_view::npos) return numbers;
        rest.remove_prefix(end + 1);
    }
}

}  // namespace annulus::inline v1
