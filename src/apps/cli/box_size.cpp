// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/box_size.h>

#include <annulus/error.h>
#include <apps/formats/input_error.h>
#include <apps/formats/number_list.h>

#include <vector>

namespace annulus::inline v1::cli {

namespace {

std::vector<double> numbers_of_size(const std::string& words) {
    if (words.empty()) throw Error(Error_code::usage, "--domain box needs its lengths: --size Lx,Ly or Lx,Ly,Lz");
    return parse_numbers("--size", words);
}

}  // namespace

int dimension_of_size(const std::string& words) {
    const std::size_t count = numbers_of_size(words).size();
    if (count == 2 || count == 4) return 2;
    if (count == 3 || count == 6) return 3;
    throw Error(Error_code::usage, "--size has " + counted(count, "number") +
                                       ", and a box has 2 or 3 lengths, or 4 or 6 coordinates of two corners");
}

template <int d>
Sized_box<d> box_of_size(const std::string& words) {
    const std::vector<double> numbers = numbers_of_size(words);
    Sized_box<d> box;
    const bool corners = numbers.size() == 2 * d;
    for (std::size_t k = 0; k < d; ++k) {
        box.lower[k] = corners ? numbers[k] : 0;
        box.upper[k] = corners ? numbers[d + k] : numbers[k];
        const double length = box.upper[k] - box.lower[k];
        if (!(length >= 1e-100 && length <= 1e100))
            throw Error(Error_code::usage, "--size: the lengths of a box must lie between 1e-100 and 1e100");
    }
    return box;
}

template Sized_box<2> box_of_size<2>(const std::string&);
template Sized_box<3> box_of_size<3>(const std::string&);

}  // namespace annulus::inline v1::cli
