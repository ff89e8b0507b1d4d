// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/formats/directory_lock.h>
#include <apps/formats/output_directory.h>
#include <apps/formats/text_output.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace annulus::inline v1 {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view private_prefix = ".annulus-";

[[noreturn]] void refuse(const fs::path& path, const std::string& what) {
    throw Error(Error_code::bad_input, path.string() + ": " + what);
}
[[noreturn]] void fail(const fs::path& path, const std::string& what, std::error_code code) {
    throw std::system_error(code, path.string() + ": " + what);
}
std::error_code last_error() { return {errno, std::generic_category()}; }

void write_all(const fs::path& file, std::string_view content) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor < 0) throw last_error();
    while (!content.empty()) {
        const ssize_t done = ::write(descriptor, content.data(), content.size());
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) {
            const std::error_code why = last_error();
            ::close(descriptor);
            throw why;
        }
        content.remove_prefix(static_cast<std::size_t>(done));
    }
    if (::close(descriptor) != 0) throw last_error();  // a full disk may be reported only here
}

/// Waits until a file, or the entries of a directory, are on the disk.
void synchronise(const fs::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0 && errno == EACCES) return;  // a directory may be written to and not read
    if (descriptor < 0) fail(path, "cannot be opened", last_error());
    const bool done = ::fsync(descriptor) == 0 || errno == EINVAL;  // some file systems do not support it
    const std::error_code why = last_error();
    ::close(descriptor);
    if (!done) fail(path, "cannot be written", why);
}

/// A directory with a unique name in `parent`, or an error.
fs::path private_directory_in(const fs::path& parent, std::error_code& code) {
    std::string name = (parent / (std::string(private_prefix) + "XXXXXX")).string();
    code.clear();
    if (::mkdtemp(name.data()) == nullptr) code = last_error();
    return name;
}

/// Whether this is a directory of private_directory_in that remained because its run was killed.
bool is_left_over(const fs::path& path) {
    const std::string name = path.filename().string();
    if (!name.starts_with(private_prefix) || name.size() != private_prefix.size() + 6) return false;
    std::error_code code;
    if (!fs::is_directory(fs::symlink_status(path, code))) return false;
    for (fs::directory_iterator entry(path, code); entry != fs::directory_iterator(); entry.increment(code))
        if (entry->path().filename() != "content") return false;
    return !code;
}

/// Whether something that is not a directory is there, including a dangling link.
bool is_in_the_way(const fs::path& path) {
    std::error_code code;
    const fs::file_status own = fs::symlink_status(path, code);  // read once: other runs make only directories
    return fs::is_symlink(own) ? !fs::is_directory(path, code) : fs::exists(own) && !fs::is_directory(own);
}

/// Whether it is a mount point, which cannot be renamed.
bool is_mount_point(const fs::path& path) {
    struct statx s {};
    if (::statx(AT_FDCWD, path.c_str(), 0, 0, &s) != 0) return true;
    return (s.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
}

}  // namespace

Output_directory::Output_directory(fs::path path, Replaced replaced, Accepted accepted)
    : path_(std::move(path)), replaced_(replaced) {
    if (path_.empty()) refuse("''", "cannot be the output directory");
    if (!path_.has_filename()) path_ = path_.parent_path();  // a trailing slash made the last component empty
    std::error_code code;
    exists_ = fs::exists(fs::symlink_status(path_, code));
    if (code && code != std::errc::no_such_file_or_directory && code != std::errc::not_a_directory)
        fail(path_, "cannot be examined", code);
    try {
        if (exists_) examine_contents(accepted);
        else make_parents();
        make_room_for_content();
    } catch (...) {
        clean_up();
        throw;
    }
}

Output_directory::~Output_directory() { clean_up(); }

void Output_directory::examine_contents(Accepted accepted) {
    std::error_code code;
    if (!fs::is_directory(path_, code)) refuse(path_, "is not a directory");
    const fs::path target = fs::canonical(path_, code);  // a link to a directory stays a link
    if (code) fail(path_, "cannot be examined", code);
    fs::directory_iterator entry(target, code);
    if (code) fail(path_, "cannot be examined", code);
    bool may_hold_files = false;
    for (; entry != fs::directory_iterator(); entry.increment(code)) {
        const std::string name = entry->path().filename().string();
        if (is_left_over(entry->path())) continue;
        may_hold_files = may_hold_files || accepted(path_);
        if (!may_hold_files)
            refuse(path_,
                   "holds other files; expected a new or empty directory, or one with results of annulus (or --force)");
        if (replaced_(name)) require_replaceable(path_ / name);
        one_by_one_ = one_by_one_ || !replaced_(name) || entry->is_directory(code);
    }
    if (code) fail(path_, "cannot be examined", code);
    target_ = target;
    one_by_one_ = one_by_one_ || target_ == fs::current_path(code) || is_mount_point(target_);
}

/// Another run may remove at any time the parents that it made: then some of them are missing, and making our own
/// directory fails.
void Output_directory::make_parents() {
    if (path_.filename() == "." || path_.filename() == "..") refuse(path_, "is not there");
    target_ = fs::absolute(path_);
    std::error_code code;
    std::vector<fs::path> missing;
    for (fs::path p = target_.parent_path(); !fs::exists(p, code) && p != p.parent_path(); p = p.parent_path())
        missing.push_back(p);
    for (auto p = missing.rbegin(); p != missing.rend(); ++p) {
        if (fs::create_directory(*p, code)) made_.push_back(*p);
        else if (code == std::errc::no_such_file_or_directory) return;
        else if (code == std::errc::file_exists && !is_in_the_way(*p)) return;
        else if (code == std::errc::not_a_directory) refuse(p->parent_path(), "is not a directory");
        else if (code) fail(*p, "cannot be made", code);
    }
    if (is_in_the_way(target_.parent_path())) refuse(path_.parent_path(), "is not a directory");
}

void Output_directory::make_room_for_content() {
    std::error_code code;
    fs::path made;
    if (!one_by_one_) made = private_directory_in(target_.parent_path(), code);
    // Parents that another run removed before anything of ours was in them.
    for (int turn = 0; !exists_ && code == std::errc::no_such_file_or_directory && turn < 100; ++turn) {
        make_parents();
        made = private_directory_in(target_.parent_path(), code);
    }
    if (exists_ && (one_by_one_ || code)) {  // we may write in it, but not in its parent
        one_by_one_ = true;
        made = private_directory_in(target_, code);
    }
    if (code) fail(path_, exists_ ? "cannot be written to" : "cannot be made", code);
    private_ = made;
    content_ = private_ / "content";
    if (::mkdir(content_.c_str(), 0777) != 0) fail(path_, "cannot be made", last_error());
    struct stat old {};
    if (exists_ && ::stat(target_.c_str(), &old) == 0) fs::permissions(content_, fs::perms(old.st_mode & 07777), code);
}

/// A name that no other file has. (The file of path_of() may not exist yet, but its name is reserved.)
fs::path Output_directory::new_name(std::string_view name) const {
    const fs::path plain(name);
    std::error_code code;
    if (name.empty() || plain.filename() != plain || name == "." || name == ".." ||
        fs::exists(fs::symlink_status(content_ / plain, code)))
        refuse(path_ / plain, "is not a plain and new file name");
    return plain;
}

fs::path Output_directory::path_of(std::string_view name) {
    files_.push_back(new_name(name));
    return content_ / files_.back();
}

void Output_directory::take(Output_directory& other) {
    for (const fs::path& name : other.files_) {
        const fs::path plain = new_name(name.native());
        std::error_code code;
        fs::rename(other.content_ / plain, content_ / plain, code);
        if (code == std::errc::cross_device_link) fs::copy_file(other.content_ / plain, content_ / plain, code);
        if (code) fail(path_ / plain, "cannot be written", code);
        files_.push_back(plain);
    }
    other.files_.clear();
}

void Output_directory::write(std::string_view name, std::string_view content) {
    const fs::path plain = new_name(name);
    try {
        write_all(content_ / plain, content);
    } catch (const std::error_code& why) {
        std::error_code ignored;
        fs::remove(content_ / plain,
                   ignored);  // a commit after this failure must not find half a file
        fail(path_ / plain, "cannot be written", why);
    }
    files_.push_back(plain);
}

void Output_directory::commit() {
    if (content_.empty()) return;
    if (!last_.empty()) {
        for (const fs::path& name : files_) synchronise(content_ / name);
        synchronise(content_);
    }
    if (!exists_) {
        // A directory that was made meanwhile is replaced if it is empty or has the results of another run.
        if (::rename(content_.c_str(), target_.c_str()) != 0) {
            const std::error_code why = last_error();
            if (!holds_results_only() || !exchange()) fail(path_, "cannot be put in its place", why);
        }
    } else if (one_by_one_ || !exchange()) {
        replace_one_by_one();  // also where the file system does not support exchange
    }
    made_.clear();
    if (!last_.empty()) synchronise(target_.parent_path());
    clean_up();  // the old directory is there after the exchange
}

bool Output_directory::exchange() {
    return ::renameat2(AT_FDCWD, content_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0;
}

bool Output_directory::holds_results_only() const {
    std::error_code code;
    bool only = fs::is_directory(fs::symlink_status(target_, code));
    for (fs::directory_iterator entry(target_, code); only && entry != fs::directory_iterator(); entry.increment(code))
        only = replaced_(entry->path().filename().string()) && entry->is_regular_file(code);
    return only && !code;
}

void Output_directory::replace_one_by_one() {
    const Directory_lock writing(target_, Directory_lock::Access::writing);
    std::error_code code;
    for (const fs::path& name : files_)
        if (fs::is_directory(fs::symlink_status(target_ / name, code)))
            refuse(path_ / name, "is a directory; expected a file or nothing");
    for (const fs::path& name : files_) require_replaceable(path_ / name);
    const auto remove = [&](const fs::path& file) {
        if (!fs::remove(file, code) && code) fail(file, "cannot be replaced", code);
    };
    if (!files_.empty()) remove(target_ / files_.front());
    std::vector<fs::path> stale, sorted = files_;
    std::sort(sorted.begin(), sorted.end());
    for (const auto& entry : fs::directory_iterator(target_, code)) {
        const fs::path name = entry.path().filename();
        const bool is_new = std::binary_search(sorted.begin(), sorted.end(), name);
        if (replaced_(name.string()) && !is_new && !entry.is_directory(code)) stale.push_back(entry.path());
    }
    for (const fs::path& file : stale)
        if (file.filename() != last_) remove(file);
    for (auto name = files_.rbegin(); name != files_.rend(); ++name) {
        fs::rename(content_ / *name, target_ / *name, code);
        if (code) fail(path_ / *name, "cannot be put in its place", code);
    }
    if (!last_.empty()) synchronise(target_);
    for (const fs::path& file : stale)
        if (file.filename() == last_) remove(file);
}

void Output_directory::clean_up() noexcept {
    std::error_code ignored;
    if (!private_.empty()) fs::remove_all(private_, ignored);
    private_.clear();
    content_.clear();
    // Only directories that are empty go: another process may have begun to use them.
    for (auto p = made_.rbegin(); p != made_.rend(); ++p) fs::remove(*p, ignored);
    made_.clear();
}

}  // namespace annulus::inline v1
