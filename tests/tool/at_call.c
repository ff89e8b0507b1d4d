// SPDX-License-Identifier: GPL-3.0-or-later
/* Preloaded into the tool by tool.py: sends a signal at a point of the program, not at a time.
 *
 * ANNULUS_AT="SIGNAL COUNT CALL [PART]": the process sends itself SIGNAL before its COUNT-th CALL on a file whose path
 * has PART in it, and goes on. CALL is the name of one of the functions below, without at, at2, 64 or data, or
 * `change` for all that change files, or `clock` for a call of a clock. ANNULUS_AT_RANK: only in that process of
 * mpirun. ANNULUS_THREADS=N: beside the first one so many threads are there at once, and no more.
 * C, because what is preloaded comes before the libraries of C++.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

static int signal_number;
static long count;
static char call[32];
static char part[256];
static atomic_long seen;
static atomic_long threads = 1L << 30;  // that may begin now; very many where there is no limit

__attribute__((constructor)) static void read_environment(void) {
    const char* const at = getenv("ANNULUS_AT");
    const char* const only = getenv("ANNULUS_AT_RANK");
    const char* const rank = getenv("OMPI_COMM_WORLD_RANK");
    if (getenv("ANNULUS_THREADS")) threads = atol(getenv("ANNULUS_THREADS"));
    if (only && (!rank || strcmp(only, rank) != 0)) return;
    if (at && sscanf(at, "%d %ld %31s %255s", &signal_number, &count, call, part) < 3) abort();
}

static void here(const char* name, int changes, const char* path, const char* other) {
    if (!signal_number || (strcmp(call, name) != 0 && !(changes && strcmp(call, "change") == 0))) return;
    if (part[0] && !(path && strstr(path, part)) && !(other && strstr(other, part))) return;
    if (atomic_fetch_add(&seen, 1) + 1 == count) raise(signal_number);
}

static void here_fd(const char* name, int changes, int fd) {
    char link[40], path[4096];
    if (!signal_number) return;
    snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
    const ssize_t n = readlink(link, path, sizeof path - 1);
    path[n > 0 ? n : 0] = 0;
    here(name, changes, path, NULL);
}

#define REAL(type, name, ...)         \
    static type (*real)(__VA_ARGS__); \
    if (!real) *(void**)&real = dlsym(RTLD_NEXT, name)

static int writes(int flags) { return (flags & O_ACCMODE) != O_RDONLY; }

#define OPEN(NAME)                                                                      \
    int NAME(const char* path, int flags, ...) {                                        \
        REAL(int, #NAME, const char*, int, ...);                                        \
        va_list more;                                                                   \
        va_start(more, flags);                                                          \
        const mode_t mode = flags & (O_CREAT | __O_TMPFILE) ? va_arg(more, mode_t) : 0; \
        va_end(more);                                                                   \
        here("open", writes(flags), path, NULL);                                        \
        return real(path, flags, mode);                                                 \
    }
#define OPENAT(NAME)                                                                    \
    int NAME(int at, const char* path, int flags, ...) {                                \
        REAL(int, #NAME, int, const char*, int, ...);                                   \
        va_list more;                                                                   \
        va_start(more, flags);                                                          \
        const mode_t mode = flags & (O_CREAT | __O_TMPFILE) ? va_arg(more, mode_t) : 0; \
        va_end(more);                                                                   \
        here("open", writes(flags), path, NULL);                                        \
        return real(at, path, flags, mode);                                             \
    }
OPEN(open)
OPEN(open64)
OPENAT(openat)
OPENAT(openat64)

ssize_t read(int fd, void* data, size_t n) {
    REAL(ssize_t, "read", int, void*, size_t);
    here_fd("read", 0, fd);
    return real(fd, data, n);
}
ssize_t write(int fd, const void* data, size_t n) {
    REAL(ssize_t, "write", int, const void*, size_t);
    here_fd("write", 1, fd);
    return real(fd, data, n);
}
size_t fwrite(const void* data, size_t size, size_t n, FILE* file) {
    REAL(size_t, "fwrite", const void*, size_t, size_t, FILE*);
    here_fd("write", 1, fileno(file));
    return real(data, size, n, file);
}
FILE* fopen(const char* path, const char* mode) {
    REAL(FILE*, "fopen", const char*, const char*);
    here("open", strpbrk(mode, "wa+") != NULL, path, NULL);
    return real(path, mode);
}
#define PWRITE(NAME, OFFSET)                                      \
    ssize_t NAME(int fd, const void* data, size_t n, OFFSET at) { \
        REAL(ssize_t, #NAME, int, const void*, size_t, OFFSET);   \
        here_fd("pwrite", 1, fd);                                 \
        return real(fd, data, n, at);                             \
    }
PWRITE(pwrite, off_t)
PWRITE(pwrite64, off64_t)

#define ON_FD(NAME, CALL)      \
    int NAME(int fd) {         \
        REAL(int, #NAME, int); \
        here_fd(CALL, 1, fd);  \
        return real(fd);       \
    }
ON_FD(fsync, "fsync")
ON_FD(fdatasync, "fsync")

#define ON_PATH(NAME)                  \
    int NAME(const char* path) {       \
        REAL(int, #NAME, const char*); \
        here(#NAME, 1, path, NULL);    \
        return real(path);             \
    }
ON_PATH(unlink)
ON_PATH(rmdir)
ON_PATH(remove)

int unlinkat(int at, const char* path, int flags) {
    REAL(int, "unlinkat", int, const char*, int);
    here("unlink", 1, path, NULL);
    return real(at, path, flags);
}
int mkdir(const char* path, mode_t mode) {
    REAL(int, "mkdir", const char*, mode_t);
    here("mkdir", 1, path, NULL);
    return real(path, mode);
}
char* mkdtemp(char* path) {
    REAL(char*, "mkdtemp", char*);
    here("mkdir", 1, path, NULL);
    return real(path);
}
int rename(const char* from, const char* to) {
    REAL(int, "rename", const char*, const char*);
    here("rename", 1, from, to);
    return real(from, to);
}
int renameat2(int from_at, const char* from, int to_at, const char* to, unsigned flags) {
    REAL(int, "renameat2", int, const char*, int, const char*, unsigned);
    here("rename", 1, from, to);
    return real(from_at, from, to_at, to, flags);
}
struct Start {
    void* (*run)(void*);
    void* with;
};
static void* run_counted(void* given) {
    const struct Start start = *(struct Start*)given;
    free(given);
    void* const result = start.run(start.with);
    atomic_fetch_add(&threads, 1);
    return result;
}
int pthread_create(pthread_t* thread, const pthread_attr_t* how, void* (*run)(void*), void* with) {
    REAL(int, "pthread_create", pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    struct Start* const start = malloc(sizeof *start);
    if (!start || atomic_fetch_sub(&threads, 1) <= 0) {
        atomic_fetch_add(&threads, 1);
        free(start);
        return EAGAIN;
    }
    *start = (struct Start){run, with};
    return real(thread, how, run_counted, start);
}
int clock_gettime(clockid_t clock, struct timespec* now) {
    REAL(int, "clock_gettime", clockid_t, struct timespec*);
    here("clock", 0, NULL, NULL);
    return real(clock, now);
}
