// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/journal.h>
#include <apps/formats/formatted.h>

#include <annulus/error.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr std::size_t mark = 9;  // eight digits and a space

std::string mark_of(std::string_view text) {
    return formatted("%08lx ", ::crc32_z(0, reinterpret_cast<const unsigned char*>(text.data()), text.size()));
}
/// The text of a complete line.
bool is_whole(std::string_view line) {
    return line.size() >= mark && mark_of(line.substr(mark)) == line.substr(0, mark);
}

}  // namespace

Journal::Journal(std::filesystem::path file, const std::string& head, bool begin_anew) : file_(std::move(file)) {
    open_and_lock();
    try {
        if (!begin_anew) read(head);
        if (::ftruncate(descriptor_, static_cast<off_t>(end_)) != 0) fail("cannot be cut");
        if (end_ == 0) write(mark_of(head) + head + "\n");
    } catch (...) {
        ::close(descriptor_);
        throw;
    }
}
Journal::~Journal() { ::close(descriptor_); }

void Journal::fail(const char* what) const {
    throw std::system_error(errno, std::generic_category(), file_.string() + ": " + what);
}

void Journal::open_and_lock() {
    while (true) {
        descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (descriptor_ < 0) fail("cannot be opened");
        if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
            ::close(descriptor_);
            throw Error(Error_code::bad_input,
                        file_.parent_path().string() + ": another sweep is writing to it; expected one at a time");
        }
        // The former owner may have replaced the directory by its results.
        struct stat ours {
        }, there{};
        if (::fstat(descriptor_, &ours) == 0 && ::stat(file_.c_str(), &there) == 0 && ours.st_ino == there.st_ino &&
            ours.st_dev == there.st_dev)
            return;
        ::close(descriptor_);
    }
}

/// `ended`: whether the line has its end. If the first line was cut off, nothing was stored.
void Journal::require_head(std::string_view line, const std::string& head, bool ended) const {
    const std::string wanted = mark_of(head) + head;
    if (ended ? line == wanted : wanted.starts_with(line)) return;
    const std::string place = file_.parent_path().string();
    if (is_whole(line))
        throw Error(Error_code::bad_input,
                    place +
                        ": holds a sweep of another specification, or by another version, that is not done; expected "
                        "the same, or another directory (or --force)");
    throw Error(
        Error_code::bad_input,
        place +
            ": the journal of a sweep in it is damaged at its beginning, or is something else; expected a sweep "
            "that is not done, or another directory (or --force)");
}

void Journal::read(const std::string& head) {
    std::array<char, 1 << 16> block{};
    std::string line;
    bool any = false;
    std::uint64_t at = 0, begin = 0;  // end of the data read; beginning of the line
    while (true) {
        const ssize_t n = ::pread(descriptor_, block.data(), block.size(), static_cast<off_t>(at));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail("cannot be read");
        if (n == 0) break;
        at += static_cast<std::uint64_t>(n);
        for (std::string_view rest(block.data(), static_cast<std::size_t>(n)); !rest.empty();) {
            const std::size_t stop = rest.find('\n');
            line += rest.substr(0, stop);
            if (stop == std::string_view::npos) break;
            rest.remove_prefix(stop + 1);
            if (!any) require_head(line, head, true);
            else if (is_whole(line)) place_.push_back({begin + mark, line.size() - mark});
            begin += line.size() + 1;
            if (!any || is_whole(line)) end_ = begin;
            any = true;
            line.clear();
        }
    }
    if (!any) require_head(line, head, false);
}

std::string Journal::entry(std::size_t i) const {
    const Place p = place_.at(i);
    std::string line(p.size + mark, '\0');
    std::size_t done = 0;
    while (done < line.size()) {
        const ssize_t n =
            ::pread(descriptor_, line.data() + done, line.size() - done, static_cast<off_t>(p.begin - mark + done));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail("cannot be read");
        if (n == 0) break;
        done += static_cast<std::size_t>(n);
    }
    if (!is_whole(line)) throw Error(Error_code::bad_input, file_.string() + ": was changed by another process");
    return line.substr(mark);
}

void Journal::append(std::string_view text) {
    std::string line = mark_of(text);
    line += text;
    line += '\n';
    const std::uint64_t begin = end_ + mark;
    write(line);
    place_.push_back({begin, text.size()});
}

void Journal::write(std::string_view line) {
    for (std::string_view rest = line; !rest.empty();) {
        const ssize_t n =
            ::pwrite(descriptor_, rest.data(), rest.size(), static_cast<off_t>(end_ + line.size() - rest.size()));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail("cannot be written");
        rest.remove_prefix(static_cast<std::size_t>(n));
    }
    end_ += line.size();
    const auto now = std::chrono::steady_clock::now();
    if (now - synchronised_ < std::chrono::seconds(1)) return;
    if (::fdatasync(descriptor_) != 0) fail("cannot be written");
    synchronised_ = now;
}

}  // namespace annulus::inline v1
