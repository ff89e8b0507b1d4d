// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/reproduction/parts.h>

#include <annulus/arithmetic/error.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

namespace annulus {

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

Parts::Parts(std::filesystem::path directory, const std::string& what) : directory_(std::move(directory)) {
    if (const auto there = content(directory_ / head)) {
        if (*there != what + "\n")
            throw Error(Error_code::usage, directory_.string() + " holds parts of another reproduction (" +
                                               there->substr(0, there->find('\n')) +
                                               "); take it away, or name another directory");
        return;
    }
    if (std::filesystem::exists(directory_) && !std::filesystem::is_empty(directory_))
        throw Error(Error_code::usage,
                    directory_.string() +
                        " is there and holds no parts of a reproduction; take it away, or name another directory");
    std::filesystem::create_directories(directory_);
    write(head, what + "\n");
}

std::optional<Race_record> Parts::find(const std::string& name) const {
    const auto text = content(directory_ / (name + ".json"));
    if (!text) return std::nullopt;
    try {
        Race_record race = parse_race(*text);
        if (race.name == name) return race;
    } catch (const Error&) {  // it is made again
    }
    return std::nullopt;
}

void Parts::keep(const Race_record& race) const { write(race.name + ".json", race_text(race)); }

void Parts::remove() const { std::filesystem::remove_all(directory_); }

void Parts::write(const std::string& name, const std::string& text) const {
    const std::filesystem::path unfinished = directory_ / (name + ".unfinished");
    errno = 0;
    std::ofstream file(unfinished, std::ios::binary | std::ios::trunc);
    file << text;
    file.close();
    if (!file) throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(), unfinished.string());
    std::filesystem::rename(unfinished, directory_ / name);
}

}  // namespace annulus
