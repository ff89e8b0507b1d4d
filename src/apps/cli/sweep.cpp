// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/version.h>
#include <apps/cli/arguments.h>
#include <apps/cli/commands.h>
#include <apps/cli/companion.h>
#include <apps/cli/progress.h>
#include <apps/cli/result_files.h>
#include <apps/experiment/coordinator.h>
#include <apps/experiment/ranks.h>
#include <apps/experiment/sweep_files.h>
#include <apps/formats/input_error.h>
#include <apps/formats/text_input.h>
#include <apps/report/memory.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace annulus::inline v1::cli {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Sweep_call {
    Common_arguments common;
    std::string file;
    double memory = 0;  // GiB; 0: four fifths of the available memory
    bool check = false;
};

/// A specification in the form that is sent to all processes.
struct Spec_text {
    std::string name, directory, text;

    /// Separated by bytes 0, which none of the parts contains; names need not be UTF-8.
    [[nodiscard]] std::string packed(std::uint32_t identity) const {
        return std::to_string(identity) + '\0' + name + '\0' + directory + '\0' + text;
    }
    static Spec_text unpacked(std::string_view message, std::uint32_t& identity) {
        const auto next = [&message] {
            std::string one(message.substr(0, message.find('\0')));
            message.remove_prefix(std::min(message.size(), one.size() + 1));
            return one;
        };
        identity = static_cast<std::uint32_t>(std::stoul(next()));
        Spec_text text{next(), next(), {}};
        text.text = next();
        return text;
    }
    [[nodiscard]] Spec read() const { return read_spec(name, text, directory); }
};

Spec_text load(const std::string& file) {
    constexpr std::uint64_t most = std::uint64_t{64} << 20;
    Source source = load_file(file, most);
    if (source.content.find('\n') == std::string::npos)
        std::replace(source.content.begin(), source.content.end(), '\r', '\n');
    for (const unsigned char c : source.content)
        if (c == 0) throw Input_error(Error_code::bad_input, source.name, 0, "is no text", "TOML");
    return {source.name, file == "-" ? "" : fs::path(file).parent_path().string(), source.content};
}

/// The memory for experiments: that of --memory, or four fifths of the available memory of the machine.
std::uint64_t bytes_of(const Sweep_call& a) {
    if (a.memory > 0) return static_cast<std::uint64_t>(a.memory * 1024 * 1024 * 1024);
    const std::uint64_t available = available_memory();
    return available == 0 ? std::uint64_t{4} << 30 : available / 5 * 4;
}

/// The head of a journal. A journal can be continued only if its head is the same.
std::string head_of(const Spec& spec) {
    return Json{{"journal", "annulus sweep"},
                {"version", ANNULUS_VERSION_STRING},
                {"identity", spec.identity},
                {"trials", spec.trials.size()}}
        .dump();
}

/// Whether the directory has the results of this sweep.
bool is_done(const fs::path& directory, const Spec& spec) {
    std::error_code code;
    if (fs::exists(directory / journal_name, code)) return false;
    for (const std::string_view name : sweep_results)
        if (!fs::is_regular_file(directory / name, code)) return false;  // a pipe could block for ever
    std::ifstream file(directory / "sums.json", std::ios::binary);
    const Json json = Json::parse(file, nullptr, false);
    const auto has = [&json](const char* key, const Json& value) { return json.contains(key) && json[key] == value; };
    return has("command", "annulus sweep") && has("version", ANNULUS_VERSION_STRING) && has("identity", spec.identity);
}

/// The output directory while its journal grows. It is removed if the journal stays empty.
class Journal_place {
  public:
    Journal_place(const Sweep_call& a, const Spec& spec) : path_(a.common.output) {
        std::error_code code;
        if (!fs::exists(path_ / journal_name, code)) require_writable(a.common, is_sweep_file);
        try {
            make(fs::absolute(path_));
            journal_ = std::make_unique<Journal>(path_ / journal_name, head_of(spec), a.common.force);
        } catch (...) {
            take_away();
            throw;
        }
    }
    ~Journal_place() {
        if (journal_->size() > 0) return;
        std::error_code code;
        fs::remove(path_ / journal_name, code);
        take_away();
    }
    Journal_place(const Journal_place&) = delete;
    Journal_place& operator=(const Journal_place&) = delete;
    [[nodiscard]] Journal& journal() { return *journal_; }

  private:
    /// Creates a directory and its missing parents.
    void make(const fs::path& path) {
        std::error_code code;
        if (fs::exists(path, code) || path == path.parent_path()) return;
        make(path.parent_path());
        if (fs::create_directory(path)) made_.push_back(path);
    }
    void take_away() {
        std::error_code code;
        for (auto p = made_.rbegin(); p != made_.rend(); ++p) fs::remove(*p, code);
    }

    fs::path path_;
    std::vector<fs::path> made_;  // outermost first
    std::unique_ptr<Journal> journal_;
};

/// Ends the process at once, although threads are computing: finished trials are in the journal.
void stop_if_interrupted(const Coordinator& c, const Sweep_call& a) {
    if (!Interruption_guard::interrupted()) return;
    std::fprintf(stderr, "annulus: interrupted: %zu of %s kept in %s, and the same command goes on from there\n",
                 c.done(), c.all() == 1 ? "1 trial is" : (std::to_string(c.all()) + " trials are").c_str(),
                 a.common.output.c_str());
    Interruption_guard::end_if_interrupted();
}

void compute(const Sweep_call& a, const Spec& spec, Coordinator& c, Ranks& ranks) {
    const Interruption_guard guard;
    Progress progress("sweep", spec.trials.size(), a.common.quiet);
    const auto poll = [&] {
        stop_if_interrupted(c, a);
        progress.show(c.done(), ranks.size() > 1 ? counted(static_cast<std::uint64_t>(ranks.size()), "rank") : "");
    };
    const Workers workers(
        a.common.threads, spec,
        [&]() -> std::optional<Schedule::Job> {  // after a signal no job begins
            if (Interruption_guard::interrupted()) return std::nullopt;
            return c.wait_for_job(ranks.machine());
        },
        [&](const Schedule::Job& job, const Trial_result& r) { c.finish(job.trial, ranks.machine(), 0, r); },
        [&](const Schedule::Job& job, const std::exception_ptr& why) { c.fail(job.trial, ranks.machine(), why); });
    ranks.serve(c, a.common.threads, poll);
    while (!c.over()) {
        poll();
        c.wait(std::chrono::milliseconds(100));
    }
}

int run_first(const Sweep_call& a, Ranks& ranks) {
    const Spec_text text = load(a.file);
    const Spec spec = text.read();
    if (a.check) {
        if (!a.common.quiet)
            std::printf("%s: %s, hardest %zu, seed %llu\n", text.name.c_str(),
                        counted(spec.trials.size(), "trial").c_str(), spec.hardest,
                        static_cast<unsigned long long>(spec.seed));
        return done;
    }
    if (a.common.output.empty()) throw Error(Error_code::usage, "sweep needs --output DIR (or --check)");
    if (!a.common.force && is_done(a.common.output, spec)) {
        if (!a.common.quiet)
            std::printf("%s has these results already; --force computes them again\n", a.common.output.c_str());
        return done;
    }
    Journal_place place(a, spec);
    Coordinator coordinator(spec, place.journal(), a.common.threads * ranks.ranks_of_machine(), bytes_of(a));
    const std::size_t before = coordinator.done();
    std::string message = text.packed(spec.identity);
    ranks.share(message);
    compute(a, spec, coordinator, ranks);
    coordinator.rethrow();
    {
        const Interruption_guard guard;
        Output_directory out(a.common.output, is_sweep_file, [](const std::filesystem::path&) { return true; });
        out.goes_last(journal_name);
        write_sweep(spec, text.text, place.journal(), coordinator.entries(), coordinator.hardest(), out);
        out.commit();
    }
    if (!a.common.quiet) {
        std::printf("trials         %zu", spec.trials.size());
        if (before > 0) std::printf(", of which %zu %s done before", before, before == 1 ? "was" : "were");
        std::printf("\nwritten to     %s\n", a.common.output.c_str());
    }
    return done;
}

int run_other(const Sweep_call& a, Ranks& ranks) {
    std::string message;
    ranks.share(message);
    if (message.empty()) return done;
    try {
        std::uint32_t identity = 0;
        const Spec_text text = Spec_text::unpacked(message, identity);
        const Spec spec = text.read();
        if (spec.identity != identity)
            throw Input_error(Error_code::bad_input, text.name, 0,
                              "files that it names are not the same for rank " + std::to_string(ranks.rank()),
                              "the same for all ranks");
        ranks.work(spec, a.common.threads);
    } catch (...) {
        ranks.give_up(std::current_exception());
    }
    return done;
}

}  // namespace

Run add_sweep_command(CLI::App& app, const Invocation&) {
    auto* sub = app.add_subcommand("sweep", sweep_summary);
    const auto a = std::make_shared<Sweep_call>();
    sub->add_option("SPEC", a->file, "What to study: grids of experiments, in TOML (docs/formats.md)")->required();
    sub->add_flag("--check", a->check, "Read SPEC, print the number of trials, and stop");
    sub->add_option("--memory", a->memory,
                    "Memory for the experiments that run at the same time on each machine; default:\nfour fifths of "
                    "the available memory")
        ->type_name("GIB")
        ->check(number_within(0.001, 100000.0));
    add_common(*sub, a->common, "results.jsonl, sums.json, hard.jsonl, costs.jsonl and sweep.html");
    sub->get_option("--seed")->description("Accepted by all subcommands; the seed of a sweep is in SPEC");
    sub->get_option("--threads")->description("Threads of each process; results do not depend on it");
    sub->get_option("--force")->description("Start again, whatever the directory holds; files other than results stay");
    return [a] {
        Ranks ranks;
        return ranks.first() ? run_first(*a, ranks) : run_other(*a, ranks);
    };
}

}  // namespace annulus::inline v1::cli
