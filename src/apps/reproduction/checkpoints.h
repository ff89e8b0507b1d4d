// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/reproduction/records.h>

#include <filesystem>
#include <optional>
#include <string>

namespace annulus::inline v1 {

/// The finished parts of an unfinished reproduction: a directory with a file for each benchmark, and one that
/// identifies the reproduction. A file is complete or absent.
class Checkpoints {
  public:
    /// Makes the directory, or opens the existing one, and locks it. `what` is one line, all that results depend on.
    /// Throws Error(usage) if the existing parts belong to another reproduction, Error(bad_input) if another process
    /// uses it, std::system_error for failures of the system.
    Checkpoints(std::filesystem::path directory, const std::string& what);
    ~Checkpoints();
    Checkpoints(const Checkpoints&) = delete;
    Checkpoints& operator=(const Checkpoints&) = delete;
    /// Absent if there is none, or none that can be read.
    [[nodiscard]] std::optional<Benchmark_record> find(const std::string& name) const;
    void keep(const Benchmark_record& benchmark) const;
    /// Removes the directory, after the results are in place.
    void remove() const;

  private:
    void open_and_lock();
    void write(const std::string& name, const std::string& text) const;
    std::filesystem::path directory_;
    int head_ = -1;  ///< descriptor of the file that identifies the reproduction
};

}  // namespace annulus::inline v1
