// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/arithmetic/error.h>
#include <annulus/io/output_directory.h>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace annulus {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
    throw Error(Error_code::bad_input, path.string() + ": " + what);
}

std::string reason(const std::error_code& code) { return code.message(); }

}  // namespace

Output_directory::Output_directory(fs::path path) : path_(std::move(path)) {
    if (path_.empty()) fail("''", "cannot be the output directory");
    // A trailing slash would make the last component empty.
    if (!path_.has_filename()) path_ = path_.parent_path();
    std::error_code code;
    std::vector<fs::path> missing;
    for (fs::path p = path_; !p.empty() && !fs::exists(p, code); p = p.parent_path()) missing.push_back(p);
    std::reverse(missing.begin(), missing.end());
    for (const fs::path& p : missing) {
        if (fs::create_directory(p, code)) {
            made_.push_back(p);
        } else if (code) {
            remove_directories();
            fail(p, "cannot be made: " + reason(code));
        }
    }
    if (!fs::is_directory(path_, code)) {
        remove_directories();
        fail(path_, "is not a directory");
    }
}

Output_directory::~Output_directory() {
    take_back();
    remove_directories();
}

void Output_directory::write(std::string_view name, std::string_view content) {
    const fs::path plain(name);
    if (name.empty() || plain.filename() != plain || name == "." || name == "..")
        fail(path_ / plain, "is not a plain file name");
    const fs::path final_name = path_ / plain;
    auto known = std::find_if(files_.begin(), files_.end(), [&](const File& f) { return f.final_name == final_name; });
    if (known == files_.end()) {
        files_.push_back({final_name, unused_name(name), {}, false, false});
        known = files_.end() - 1;
    }
    errno = 0;
    std::ofstream out(known->temporary, std::ios::binary | std::ios::trunc);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();  // a full disk may show only here
    if (out) return;
    const std::string why = errno != 0 ? std::strerror(errno) : "unknown error";
    // Half a file must not be there for a commit that comes in spite of this.
    std::error_code ignored;
    fs::remove(known->temporary, ignored);
    files_.erase(known);
    fail(final_name, "cannot be written: " + why);
}

void Output_directory::commit() {
    try {
        for (File& file : files_) put_in_place(file);
    } catch (...) {
        take_back();
        throw;
    }
    std::error_code ignored;
    for (const File& file : files_)
        if (file.has_backup) fs::remove(file.backup, ignored);
    files_.clear();
    made_.clear();
}

fs::path Output_directory::unused_name(std::string_view name) {
    fs::path candidate;
    std::error_code code;
    do {
        candidate = path_ / ("." + std::string(name) + "." + std::to_string(::getpid()) + "." +
                             std::to_string(names_++) + ".tmp");
    } while (fs::exists(fs::symlink_status(candidate, code)));
    return candidate;
}

/// Renaming over a file is atomic, so a reader sees the old file or the new one and never none.
void Output_directory::put_in_place(File& file) {
    std::error_code code;
    const auto status = fs::symlink_status(file.final_name, code);
    if (fs::is_directory(status)) fail(file.final_name, "is a directory; expected a file or nothing");
    if (fs::exists(status)) {
        file.backup = unused_name(file.final_name.filename().string());
        fs::create_hard_link(file.final_name, file.backup, code);
        if (code) fs::rename(file.final_name, file.backup, code);  // where there are no hard links
        if (code) fail(file.final_name, "cannot be replaced: " + reason(code));
        file.has_backup = true;
    }
    fs::rename(file.temporary, file.final_name, code);
    if (code) fail(file.final_name, "cannot be written: " + reason(code));
    file.in_place = true;
}

void Output_directory::take_back() noexcept {
    std::error_code ignored;
    for (const File& file : files_) {
        if (file.has_backup) {
            fs::rename(file.backup, file.final_name, ignored);
            // Renaming between two names of one file does nothing, and leaves both.
            fs::remove(file.backup, ignored);
        } else if (file.in_place) {
            fs::remove(file.final_name, ignored);
        }
        fs::remove(file.temporary, ignored);
    }
    files_.clear();
}

void Output_directory::remove_directories() noexcept {
    std::error_code ignored;
    // Only directories that are empty go: somebody else may have begun to use them.
    for (auto p = made_.rbegin(); p != made_.rend(); ++p) fs::remove(*p, ignored);
    made_.clear();
}

}  // namespace annulus
