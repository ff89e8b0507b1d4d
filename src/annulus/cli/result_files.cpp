// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/arithmetic/error.h>
#include <annulus/cli/result_files.h>

namespace annulus::cli {

/// The message is not seen: the guard ends the process while the exception is on its way.
void Result_files::stop_if_interrupted() const {
    if (guard_.interrupted()) throw Error(Error_code::bad_input, "interrupted");
}

void Result_files::write(std::string_view name, std::string_view content) {
    stop_if_interrupted();
    out_.write(name, content);
}

void Result_files::commit() {
    stop_if_interrupted();
    out_.commit();
}

void require_writable(const std::string& directory) { Result_files(directory).write("probe", ""); }

}  // namespace annulus::cli
