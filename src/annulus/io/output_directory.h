// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace annulus {

/// The directory a run writes to: its files appear all together on `commit()`, or not at all.
///
/// Content goes to temporary names beside the final ones and is renamed at the end. Without a commit the destructor
/// removes it, and the directories that the constructor made. Faults throw Error(bad_input, "PATH: ...").
class Output_directory {
  public:
    /// Makes the directory and its parents where they are missing.
    explicit Output_directory(std::filesystem::path path);
    ~Output_directory();
    Output_directory(const Output_directory&) = delete;
    Output_directory& operator=(const Output_directory&) = delete;

    /// Writes one file; `name` is a plain file name. Writing a name again replaces what was written before.
    void write(std::string_view name, std::string_view content);

    /// Puts every file in its place, replacing older ones. When one cannot be, those already in place are taken back,
    /// older files are as they were, and nothing new is left. A second call has nothing to do.
    void commit();

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  private:
    struct File {
        std::filesystem::path final_name;
        std::filesystem::path temporary;
        std::filesystem::path backup;  ///< a second name of the older file while it may be needed again
        bool has_backup = false;
        bool in_place = false;
    };

    [[nodiscard]] std::filesystem::path unused_name(std::string_view name);
    void put_in_place(File& file);
    void take_back() noexcept;
    void remove_directories() noexcept;

    std::filesystem::path path_;
    std::vector<std::filesystem::path> made_;  ///< directories, outermost first
    std::vector<File> files_;
    unsigned names_ = 0;
};

}  // namespace annulus
