// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace annulus {

/// The directory a run writes to: it appears as a whole on `commit()`, or not at all.
///
/// Content goes to a fresh directory that no other user can enter (mkdtemp), beside the one to be written where that
/// can be. The commit renames it, in exchange for an older one. Where the directory that is there cannot be renamed
/// (it is the working directory or a mount point, or holds other files, which stay), its files are replaced one by
/// one, each at once: the first that was written is taken away first and comes last, so that where it is all others
/// are.
///
/// Refusals throw Error(bad_input), what the system cannot do std::system_error; both say "PATH: ...".
class Output_directory {
  public:
    /// Names of files that a commit replaces or, where it has none of that name, takes away: those of earlier results.
    using Replaced = bool (*)(std::string_view name);

    /// Makes missing parents. Throws when the directory is there and not empty, unless it `may_hold_files`.
    Output_directory(std::filesystem::path path, Replaced replaced, bool may_hold_files);
    /// Without a commit nothing is left, parents included.
    ~Output_directory();
    Output_directory(const Output_directory&) = delete;
    Output_directory& operator=(const Output_directory&) = delete;

    /// Writes one file; `name` is a plain file name that was not written before.
    void write(std::string_view name, std::string_view content);

    /// Where another library writes one file, which is to be there before the commit; `name` as above. For what is
    /// written bit by bit.
    [[nodiscard]] std::filesystem::path path_of(std::string_view name);
    /// Of earlier files this one is not taken away before all that was written is in place, and on the disk: a crash
    /// of the machine leaves the one or the other.
    void goes_last(std::string name) { last_ = std::move(name); }
    /// Takes over what was written to another one, which has nothing left.
    void take(Output_directory& other);

    /// Puts the directory in its place. A second call has nothing to do. When it throws, older results are as they
    /// were, but for those replaced one by one, which may be in part.
    void commit();

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  private:
    [[nodiscard]] std::filesystem::path new_name(std::string_view name) const;
    void look_at_what_is_there(bool may_hold_files);
    void make_parents();
    void make_room_for_content();
    [[nodiscard]] bool exchange();
    [[nodiscard]] bool holds_results_only() const;
    void replace_one_by_one();
    void clean_up() noexcept;

    std::filesystem::path path_;    ///< as it was given
    std::filesystem::path target_;  ///< absolute, without links
    Replaced replaced_;
    std::string last_;  ///< of those that are replaced; none: empty
    bool exists_ = false;
    bool one_by_one_ = false;
    std::vector<std::filesystem::path> made_;   ///< parents, outermost first
    std::filesystem::path private_;             ///< of mode 0700, so that no link can be laid in our way
    std::filesystem::path content_;             ///< in it, with the mode of the result
    std::vector<std::filesystem::path> files_;  ///< plain names, in the order of writing
};

}  // namespace annulus
