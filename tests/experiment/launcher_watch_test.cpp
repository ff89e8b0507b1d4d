// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/launcher_watch.h>

#include <support/catch.h>

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <optional>

namespace annulus {
namespace {

/// A process starts another one, which writes its process id, has a watch or none, and then waits for ever. Returns
/// whether the second ends with the first, which is terminated. The second holds the end of a pipe, which closes when
/// it has ended.
bool ends_with_its_launcher(bool watched) {
    std::array<int, 2> alive{}, go{};
    if (::pipe(alive.data()) != 0 || ::pipe(go.data()) != 0) return false;
    const pid_t launcher = ::fork();
    if (launcher == 0) {
        ::close(go[1]);
        if (::fork() == 0) {
            ::close(go[0]);
            std::optional<Launcher_watch> watch;
            if (watched) watch.emplace();
            const pid_t self = ::getpid();
            [[maybe_unused]] const ssize_t said = ::write(alive[1], &self, sizeof self);
            while (true) ::pause();
        }
        char c = 0;
        [[maybe_unused]] const ssize_t ignored = ::read(go[0], &c, 1);
        ::_exit(0);
    }
    ::close(alive[1]);
    ::close(go[0]);
    pid_t rank = 0;
    const bool runs = ::read(alive[0], &rank, sizeof rank) == sizeof rank;
    pollfd end{alive[0], POLLIN, 0};
    const bool stays = ::poll(&end, 1, 300) == 0;  // while its launcher is there
    ::close(go[1]);
    ::waitpid(launcher, nullptr, 0);
    // A tenth of a second is enough where a processor is free. The test waits only a limited time.
    const bool ended = ::poll(&end, 1, watched ? 1'800'000 : 500) == 1;
    if (runs && !ended) ::kill(rank, SIGKILL);
    ::close(alive[0]);
    return runs && stays && ended;
}

TEST_CASE("a rank ends with the process that started it") {
    CHECK(ends_with_its_launcher(true));
    CHECK_FALSE(ends_with_its_launcher(false));
}

TEST_CASE("a watch can be taken away") {
    { const Launcher_watch watch; }
    SUCCEED();
}

}  // namespace
}  // namespace annulus
