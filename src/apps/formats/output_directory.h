// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// The directory a run writes to: it appears as a whole on `commit()`, or not at all.
///
/// Content goes to a fresh directory that no other user can enter (mkdtemp), beside the final one where possible. The
/// commit renames it, exchanging it with an older one. Where the existing directory cannot be renamed (it is the
/// working directory or a mount point, or holds other files, which stay), its files are replaced one by one, each
/// atomically: the file that was written first is removed first and replaced last, so that all others are in place
/// whenever it is there.
///
/// Refusals throw Error(bad_input), failures of the system std::system_error; both messages begin with "PATH: ".
class Output_directory {
  public:
    /// Names of files of earlier results, which a commit replaces, or removes where it has no file of that name.
    using Replaced = bool (*)(std::string_view name);

    /// Whether a directory that is not empty may be written to. It is called after a file was found there, so that a
    /// run that puts its results there meanwhile is not mistaken for another program.
    using Accepted = bool (*)(const std::filesystem::path& directory);

    /// Makes missing parents. Throws when the directory exists and is neither empty nor accepted.
    Output_directory(std::filesystem::path path, Replaced replaced, Accepted accepted);
    /// Without a commit nothing is left, parents included.
    ~Output_directory();
    Output_directory(const Output_directory&) = delete;
    Output_directory& operator=(const Output_directory&) = delete;

    /// Writes one file; `name` is a plain file name that was not written before.
    void write(std::string_view name, std::string_view content);

    /// The path to which another library writes one file, which must exist before the commit; `name` as above. For
    /// files that are written piece by piece.
    [[nodiscard]] std::filesystem::path path_of(std::string_view name);
    /// This earlier file is removed only after all new files are in place and on the disk: a crash of the machine
    /// leaves the one or the others.
    void goes_last(std::string name) { last_ = std::move(name); }
    /// Takes over the files written to another one, which is empty afterwards.
    void take(Output_directory& other);

    /// Puts the directory in its place. A second call does nothing. When it throws, older results are unchanged, except
    /// that files replaced one by one may be replaced in part.
    void commit();

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  private:
    [[nodiscard]] std::filesystem::path new_name(std::string_view name) const;
    void examine_contents(Accepted accepted);
    void make_parents();
    void make_room_for_content();
    [[nodiscard]] bool exchange();
    [[nodiscard]] bool holds_results_only() const;
    void replace_one_by_one();
    void clean_up() noexcept;

    std::filesystem::path path_;    ///< as it was given
    std::filesystem::path target_;  ///< absolute, without links
    Replaced replaced_;
    std::string last_;  ///< the last to be replaced; empty: none
    bool exists_ = false;
    bool one_by_one_ = false;
    std::vector<std::filesystem::path> made_;   ///< parents, outermost first
    std::filesystem::path private_;             ///< of mode 0700, so that no link can be laid in our way
    std::filesystem::path content_;             ///< in it, with the mode of the result
    std::vector<std::filesystem::path> files_;  ///< plain names, in the order of writing
};

}  // namespace annulus::inline v1
