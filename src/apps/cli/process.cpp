// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/arguments.h>
#include <apps/cli/process.h>

#include <fcntl.h>
#include <gmp.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

namespace annulus::inline v1::cli {

namespace {

// GMP allocates in C functions that have unwind tables, and before it changes a number: only scratch memory leaks.
void* allocate(std::size_t size) {
    if (void* p = std::malloc(size)) return p;
    throw std::bad_alloc();
}
void* reallocate(void* old, std::size_t, std::size_t size) {
    if (void* p = std::realloc(old, size)) return p;
    throw std::bad_alloc();
}
void release(void* p, std::size_t) { std::free(p); }

/// The terminate handler: reports an exception that cannot be caught, because it left a destructor or a noexcept
/// function.
[[noreturn]] void last_words() {
    const char* what = "an internal error";
    try {
        if (const std::exception_ptr e = std::current_exception()) std::rethrow_exception(e);
    } catch (const std::bad_alloc&) {
        what = "out of memory";
    } catch (...) {
    }
    std::fprintf(stderr, "annulus: %s\n", what);
    std::_Exit(our_fault);
}

}  // namespace

void prepare_process() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0 && errno == EBADF)
            (void)open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // any use of it is an error
    signal(SIGXFSZ, SIG_IGN);
    mp_set_memory_functions(allocate, reallocate, release);
    std::set_terminate(last_words);
}

void finish_output() {
    errno = 0;
    if (std::fflush(stdout) != 0) throw std::system_error(errno, std::generic_category(), "standard output");
    if (std::ferror(stdout) != 0) throw std::runtime_error("standard output: not all could be written");  // before now
}

}  // namespace annulus::inline v1::cli
