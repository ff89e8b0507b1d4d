// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/packing.h>

#include <annulus/error.h>

#include <new>
#include <utility>

namespace annulus::inline v1 {

std::string next_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    std::string line(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
}

std::string packed(const std::vector<Schedule::Job>& jobs) {
    std::string text;
    for (const auto& job : jobs) text += std::to_string(job.trial) + " " + std::to_string(job.threads) + "\n";
    return text;
}
std::vector<Schedule::Job> jobs_of(std::string_view text) {
    std::vector<Schedule::Job> jobs;
    while (!text.empty()) {
        const std::string line = next_line(text);
        const std::size_t space = line.find(' ');
        jobs.push_back({std::stoull(line.substr(0, space)), std::stoi(line.substr(space + 1))});
    }
    return jobs;
}

std::string packed(std::size_t trial, const Trial_result& r) {
    std::string text = nlohmann::ordered_json{
        {"trial", trial},
        {"seconds", r.seconds},
        {"peak_bytes", r.peak_bytes},
        {"lines",
         r.lines.size()}}.dump();
    for (const std::string& line : r.lines) text += "\n" + line;
    for (const auto& hard : r.hard.json()) text += "\n" + hard.dump();
    return text;
}
Trial_result result_of(std::string_view text, std::size_t hardest, std::size_t& trial) {
    const auto head = nlohmann::ordered_json::parse(next_line(text));
    Trial_result r(hardest);
    trial = head.at("trial").get<std::size_t>();
    r.seconds = head.at("seconds").get<double>();
    r.peak_bytes = head.at("peak_bytes").get<std::uint64_t>();
    for (auto n = head.at("lines").get<std::size_t>(); n > 0; --n) r.lines.push_back(next_line(text));
    while (!text.empty()) r.hard.add(nlohmann::ordered_json::parse(next_line(text)));
    return r;
}

std::string packed(const std::exception_ptr& why) {
    Error_code code = Error_code::environment;  // an internal fault or one of the machine
    std::string what = "unknown";
    try {
        std::rethrow_exception(why);
    } catch (const Error& e) {
        code = e.code();
        what = e.what();
    } catch (const std::bad_alloc&) {
        what = "out of memory";
    } catch (const std::exception& e) {
        what = e.what();
    } catch (...) {
    }
    return std::to_string(static_cast<int>(code)) + "\n" + what;
}
std::exception_ptr fault_of(std::string_view text) {
    const auto code = static_cast<Error_code>(std::stoi(next_line(text)));
    return std::make_exception_ptr(Error(code, std::string(text)));
}

}  // namespace annulus::inline v1
