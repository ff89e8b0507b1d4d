// SPDX-License-Identifier: GPL-3.0-or-later
// Moving_mesh<2> of two versions of the library in one program: both work, and their types differ.
#include <exception>
#include <iostream>
#include <string>
#include <typeinfo>

std::string use_first(bool fails);
std::string use_second(bool fails);

/// The type of the error that a version throws.
std::string error_of(std::string (*use)(bool)) {
    try {
        (void)use(true);
    } catch (const std::exception& e) {
        return typeid(e).name();
    }
    return "no error";
}

int main() {
    const std::string first = use_first(false), second = use_second(false);
    const std::string first_error = error_of(use_first), second_error = error_of(use_second);
    std::cout << "two versions: " << first << " and " << second << "; " << first_error << " and " << second_error
              << "\n";
    const auto of = [](const std::string& name, const char* version) { return name.find(version) != name.npos; };
    return of(first, "2v1") && of(second, "5other") && of(first_error, "2v1") && of(second_error, "5other") ? 0 : 1;
}
