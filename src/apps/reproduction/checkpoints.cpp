// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/checkpoints.h>

#include <annulus/error.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr const char* head = "reproduction.txt";

std::optional<std::string> content(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return file ? std::optional(text.str()) : std::nullopt;
}

}  // namespace

Checkpoints::Checkpoints(std::filesystem::path directory, const std::string& what) : directory_(std::move(directory)) {
    open_and_lock();
    try {
        const std::string there = content(directory_ / head).value_or("");
        if (there.empty()) {
            const std::string line = what + "\n";
            if (::pwrite(head_, line.data(), line.size(), 0) != static_cast<ssize_t>(line.size()))
                throw std::system_error(errno, std::generic_category(), (directory_ / head).string());
        } else if (there != what + "\n") {
            throw Error(Error_code::usage, directory_.string() + " holds parts of another reproduction (" +
                                               there.substr(0, there.find('\n')) +
                                               "); take it away, or name another directory");
        }
    } catch (...) {
        ::close(head_);
        throw;
    }
}
Checkpoints::~Checkpoints() { ::close(head_); }

void Checkpoints::open_and_lock() {
    namespace fs = std::filesystem;
    const fs::path file = directory_ / head;
    while (true) {
        if (!fs::exists(file) && fs::exists(directory_) && !fs::is_empty(directory_))
            throw Error(Error_code::usage,
                        directory_.string() +
                            " is there and holds no parts of a reproduction; take it away, or name another directory");
        fs::create_directories(directory_);
        head_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
        if (head_ < 0 && errno == ENOENT) continue;  // another process has just removed the directory
        if (head_ < 0) throw std::system_error(errno, std::generic_category(), file.string());
        if (::flock(head_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
            ::close(head_);
            throw Error(Error_code::bad_input,
                        directory_.string() + ": another reproduction is writing to it; expected one at a time");
        }
        struct stat ours {
        }, there{};
        if (::fstat(head_, &ours) == 0 && ::stat(file.c_str(), &there) == 0 && ours.st_ino == there.st_ino &&
            ours.st_dev == there.st_dev)
            return;
        ::close(head_);
    }
}

std::optional<Benchmark_record> Checkpoints::find(const std::string& name) const {
    const auto text = content(directory_ / (name + ".json"));
    if (!text) return std::nullopt;
    try {
        Benchmark_record benchmark = parse_benchmark(*text);
        if (benchmark.name == name) return benchmark;
    } catch (const Error&) {  // the part is computed again
    }
    return std::nullopt;
}

void Checkpoints::keep(const Benchmark_record& benchmark) const {
    write(benchmark.name + ".json", benchmark_text(benchmark));
}

void Checkpoints::remove() const { std::filesystem::remove_all(directory_); }

void Checkpoints::write(const std::string& name, const std::string& text) const {
    const std::filesystem::path unfinished = directory_ / (name + ".unfinished");
    errno = 0;
    std::ofstream file(unfinished, std::ios::binary | std::ios::trunc);
    file << text;
    file.close();
    if (!file) throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(), unfinished.string());
    std::filesystem::rename(unfinished, directory_ / name);
}

}  // namespace annulus::inline v1
