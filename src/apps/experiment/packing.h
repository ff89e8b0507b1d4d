// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/experiment/schedule.h>
#include <apps/experiment/trial.h>

#include <exception>
#include <string>
#include <string_view>
#include <vector>

// Messages between ranks, as text.
namespace annulus::inline v1 {

/// Removes the next line of text and returns it.
[[nodiscard]] std::string next_line(std::string_view& text);

[[nodiscard]] std::string packed(const std::vector<Schedule::Job>& jobs);
[[nodiscard]] std::vector<Schedule::Job> jobs_of(std::string_view text);

[[nodiscard]] std::string packed(std::size_t trial, const Trial_result& result);
[[nodiscard]] Trial_result result_of(std::string_view text, std::size_t hardest, std::size_t& trial);

/// Of an exception that is not an Error the message is kept, and that no input caused it.
[[nodiscard]] std::string packed(const std::exception_ptr& why);
[[nodiscard]] std::exception_ptr fault_of(std::string_view text);

}  // namespace annulus::inline v1
