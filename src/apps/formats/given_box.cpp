// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/given_box.h>

#include <annulus/error.h>
#include <apps/formats/input_error.h>

namespace annulus::inline v1 {

bool is_periodic(const File_box& box, int d, const std::string& file, const std::string& open) {
    std::string directions;
    int count = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) {
        if (!box.periodic[k]) continue;
        directions += (count++ > 0 ? std::string(" and ") : std::string()) + "xyz"[k];
    }
    if (count == d || count == 0) return count == d;
    throw Input_error(Error_code::bad_input, file, box.line,
                      box.what + ": a box that is periodic in " + directions + " only",
                      "one that is periodic in every direction, or " + open + ", by which points are taken as they " +
                          "stand, with open boundaries");
}

template <int d>
Box<d> box_of(const File_box& box, const std::string& file, const std::string& open) {
    typename Box<d>::Vectors vectors{};
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            if (k < d) vectors[i][k] = box.vectors[i][k];
            else if (box.vectors[i][k] != 0)
                throw Input_error(Error_code::bad_input, file, box.line, box.what + ": a vector of the box has a z",
                                  "three dimensions, or two vectors without one");
        }
    try {
        return Box<d>(vectors);
    } catch (const Error& error) {
        throw Input_error(
            Error_code::bad_input, file, box.line, box.what + ": " + error.what(),
            "another box, or " + open + ", by which points are taken as they stand, with open boundaries");
    }
}

int dimension_of_box(const std::vector<double>& numbers, const std::string& option) {
    switch (numbers.size()) {
        case 2:
        case 4: return 2;
        case 3:
        case 9: return 3;
        default:
            throw Error(Error_code::usage, option + " has " + counted(numbers.size(), "number") +
                                               ", and a box has 2 or 4 in 2D, 3 or 9 in 3D");
    }
}

template <int d>
Box<d> box_of(const std::vector<double>& numbers, const std::string& option) {
    typename Box<d>::Vectors vectors{};
    if (numbers.size() == d) {
        for (std::size_t i = 0; i < d; ++i) vectors[i][i] = numbers[i];
    } else if (numbers.size() == d * d) {
        for (std::size_t i = 0; i < numbers.size(); ++i) vectors[i / d][i % d] = numbers[i];
    } else {
        throw Error(Error_code::usage, option + " has " + counted(numbers.size(), "number") + ", and a box in " +
                                           std::to_string(d) + "D has " + std::to_string(d) + " lengths or " +
                                           std::to_string(d * d) + " coordinates of vectors");
    }
    try {
        return Box<d>(vectors);
    } catch (const Error& error) {
        throw Error(Error_code::usage, option + ": " + error.what());
    }
}

template Box<2> box_of<2>(const File_box&, const std::string&, const std::string&);
template Box<3> box_of<3>(const File_box&, const std::string&, const std::string&);
template Box<2> box_of<2>(const std::vector<double>&, const std::string&);
template Box<3> box_of<3>(const std::vector<double>&, const std::string&);

}  // namespace annulus::inline v1
