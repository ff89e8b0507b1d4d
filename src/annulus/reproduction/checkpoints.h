// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/reproduction/records.h>

#include <filesystem>
#include <optional>
#include <string>

namespace annulus {

/// The finished parts of a reproduction that is not finished: a directory with a file for each race, and one that
/// says what all are parts of. A file is complete or absent.
class Checkpoints {
  public:
    /// Makes the directory, or finds what is there, and keeps other processes out. `what` is one line, all that
    /// results depend on. Throws Error(usage) where the parts that are there are of something else, Error(bad_input)
    /// where another process is at it, std::system_error for what the system cannot do.
    Checkpoints(std::filesystem::path directory, const std::string& what);
    ~Checkpoints();
    Checkpoints(const Checkpoints&) = delete;
    Checkpoints& operator=(const Checkpoints&) = delete;
    /// Absent where there is none, or none that can be read.
    [[nodiscard]] std::optional<Benchmark_record> find(const std::string& name) const;
    void keep(const Benchmark_record& benchmark) const;
    /// Takes the directory away, after the results are in place.
    void remove() const;

  private:
    void open_and_lock();
    void write(const std::string& name, const std::string& text) const;
    std::filesystem::path directory_;
    int head_ = -1;  ///< descriptor of the file that says what all are parts of
};

}  // namespace annulus
