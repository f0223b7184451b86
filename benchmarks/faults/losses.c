// What a power loss needs to know of a process: preloaded, it writes down every change of names below
// a folder and keeps what each fsync made durable, and kills at the n-th of these operations.
//
//     ESG_LOSS_ROOT     the folder
//     ESG_LOSS_JOURNAL  another folder: journal (a line an operation), snap/ (files as synced), counter
//     ESG_LOSS_AT       the operation that nobody survives; 0: none
//
// Nothing is forced to the disk: what is durable follows from the journal alone (losses.py).
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

static char root[PATH_MAX], folder[PATH_MAX];
static long at;
static atomic_long *counter;

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

// From the environment when it is loaded; by a call in a fork of a process that loaded it before.
__attribute__((constructor)) void esg_loss_begin(void) {
    const char *r = getenv("ESG_LOSS_ROOT"), *j = getenv("ESG_LOSS_JOURNAL"), *a = getenv("ESG_LOSS_AT");
    if (!r || !j) return;
    snprintf(root, sizeof root, "%s/", r);
    snprintf(folder, sizeof folder, "%s", j);
    at = a ? atol(a) : 0;
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%.4000s/counter", folder);
    int fd = syscall(SYS_openat, AT_FDCWD, path, O_RDWR | O_CLOEXEC, 0);
    if (fd < 0) return;
    void *map = mmap(NULL, sizeof(atomic_long), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    close(fd);
    counter = map == MAP_FAILED ? NULL : map;
}

static int named(int dir, const char *path, char *out) {  // absolute; whether it is below the root
    if (!counter || !path) return 0;
    if (path[0] == '/') {
        snprintf(out, PATH_MAX, "%s", path);
    } else {
        char base[PATH_MAX / 2], link[64];
        if (dir == AT_FDCWD) {
            if (!getcwd(base, sizeof base)) return 0;
        } else {
            snprintf(link, sizeof link, "/proc/self/fd/%d", dir);
            ssize_t n = readlink(link, base, sizeof base - 1);
            if (n < 0) return 0;
            base[n] = 0;
        }
        snprintf(out, PATH_MAX, "%.2000s/%.2000s", base, path);
    }
    return strncmp(out, root, strlen(root)) == 0;
}

static long count(void) {
    long n = atomic_fetch_add(counter, 1) + 1;
    if (at && n >= at) {
        raise(SIGKILL);
    }
    return n;
}

static void tell(const char *what, const char *a, const char *b) {
    char path[PATH_MAX], line[2 * PATH_MAX + 16];
    int size = snprintf(line, sizeof line, "%s\t%s\t%s\n", what, a, b);
    snprintf(path, sizeof path, "%.4000s/journal", folder);
    int kept = errno;
    int fd = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600);
    if (fd >= 0) {
        if (write(fd, line, size) != size) raise(SIGKILL);
        close(fd);
    }
    errno = kept;
}

static int absent(const char *path) {
    struct stat found;
    int kept = errno;
    int gone = fstatat(AT_FDCWD, path, &found, AT_SYMLINK_NOFOLLOW) != 0;
    errno = kept;
    return gone;
}

// Files are made by opening them.
static int opened(const char *name, int dir, const char *path, int flags, mode_t mode) {
    int (*real)(int, const char *, int, ...) = NEXT(openat64);
    char full[PATH_MAX];
    int made = (flags & O_CREAT) && named(dir, path, full) && absent(full);
    if (made) count();
    int fd = real(dir, path, flags, mode);
    if (made && fd >= 0) tell("make", full, "");
    return fd;
}

#define MODE(flags, mode)                                  \
    mode_t mode = 0;                                       \
    if ((flags) & (O_CREAT | __O_TMPFILE)) {               \
        va_list rest;                                      \
        va_start(rest, flags);                             \
        mode = va_arg(rest, mode_t);                       \
        va_end(rest);                                      \
    }

int open(const char *path, int flags, ...) { MODE(flags, mode) return opened("open", AT_FDCWD, path, flags, mode); }
int open64(const char *path, int flags, ...) { MODE(flags, mode) return opened("open", AT_FDCWD, path, flags, mode); }
int openat(int dir, const char *path, int flags, ...) { MODE(flags, mode) return opened("open", dir, path, flags, mode); }
int openat64(int dir, const char *path, int flags, ...) { MODE(flags, mode) return opened("open", dir, path, flags, mode); }
int creat(const char *path, mode_t mode) { return opened("creat", AT_FDCWD, path, O_CREAT | O_WRONLY | O_TRUNC, mode); }
int creat64(const char *path, mode_t mode) { return opened("creat", AT_FDCWD, path, O_CREAT | O_WRONLY | O_TRUNC, mode); }

#define FOPEN(name)                                                              \
    FILE *name(const char *path, const char *mode) {                             \
        char full[PATH_MAX];                                                     \
        int made = strpbrk(mode, "wa") && named(AT_FDCWD, path, full) && absent(full); \
        if (made) count();                                                       \
        FILE *file = NEXT(name)(path, mode);                                     \
        if (made && file) tell("make", full, "");                                \
        return file;                                                             \
    }
FOPEN(fopen)
FOPEN(fopen64)

#define MKSTEMP(name, parameters, arguments)                    \
    int name parameters {                                       \
        char full[PATH_MAX];                                    \
        int fd = NEXT(name) arguments;                          \
        if (fd >= 0 && named(AT_FDCWD, pattern, full)) {        \
            tell("make", full, "");                             \
            count();                                            \
        }                                                       \
        return fd;                                              \
    }
MKSTEMP(mkstemp, (char *pattern), (pattern))
MKSTEMP(mkstemp64, (char *pattern), (pattern))
MKSTEMP(mkstemps, (char *pattern, int tail), (pattern, tail))
MKSTEMP(mkostemp, (char *pattern, int flags), (pattern, flags))
MKSTEMP(mkostemps, (char *pattern, int tail, int flags), (pattern, tail, flags))

// Changes of names: one path, or two.
#define ONE(name, parameters, arguments, dir, path, what) \
    int name parameters {                                 \
        char full[PATH_MAX];                              \
        int inside = named(dir, path, full);              \
        if (inside) count();                              \
        int end = NEXT(name) arguments;                   \
        if (inside && end == 0) tell(what, full, "");     \
        return end;                                       \
    }
ONE(mkdir, (const char *p, mode_t m), (p, m), AT_FDCWD, p, "folder")
ONE(mkdirat, (int d, const char *p, mode_t m), (d, p, m), d, p, "folder")
ONE(rmdir, (const char *p), (p), AT_FDCWD, p, "remove")
ONE(unlink, (const char *p), (p), AT_FDCWD, p, "remove")
ONE(unlinkat, (int d, const char *p, int f), (d, p, f), d, p, "remove")
ONE(remove, (const char *p), (p), AT_FDCWD, p, "remove")

#define TWO(name, parameters, arguments, d1, p1, d2, p2, what)              \
    int name parameters {                                                   \
        char from[PATH_MAX], to[PATH_MAX];                                  \
        int one = named(d1, p1, from), other = named(d2, p2, to);           \
        if (one || other) count();                                          \
        int end = NEXT(name) arguments;                                     \
        if ((one || other) && end == 0) tell(what, from, to);               \
        return end;                                                         \
    }
TWO(rename, (const char *a, const char *b), (a, b), AT_FDCWD, a, AT_FDCWD, b, "rename")
TWO(renameat, (int d, const char *a, int e, const char *b), (d, a, e, b), d, a, e, b, "rename")
TWO(renameat2, (int d, const char *a, int e, const char *b, unsigned f), (d, a, e, b, f), d, a, e, b, "rename")
TWO(link, (const char *a, const char *b), (a, b), AT_FDCWD, a, AT_FDCWD, b, "link")
TWO(linkat, (int d, const char *a, int e, const char *b, int f), (d, a, e, b, f), d, a, e, b, "link")

int symlink(const char *text, const char *path) {
    char full[PATH_MAX];
    int inside = named(AT_FDCWD, path, full);
    if (inside) count();
    int end = NEXT(symlink)(text, path);
    if (inside && end == 0) tell("symlink", full, text);
    return end;
}
int symlinkat(const char *text, int dir, const char *path) {
    char full[PATH_MAX];
    int inside = named(dir, path, full);
    if (inside) count();
    int end = NEXT(symlinkat)(text, dir, path);
    if (inside && end == 0) tell("symlink", full, text);
    return end;
}

// What is forced to the disk is kept as it is now.
static int synced(int fd) {
    char link[64], full[PATH_MAX], kept[PATH_MAX], buffer[65536];
    struct stat facts;
    if (!counter) return 0;
    snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
    ssize_t n = readlink(link, full, sizeof full - 1);
    if (n < 0) return 0;
    full[n] = 0;
    if (strncmp(full, root, strlen(root)) != 0 && strncmp(full, root, strlen(root) - 1) != 0) return 0;
    long number = count();
    if (fstat(fd, &facts) != 0) return 0;
    if (S_ISDIR(facts.st_mode)) {
        tell("sync-folder", full, "");
        return 0;
    }
    snprintf(kept, sizeof kept, "%.4000s/snap/%ld", folder, number);
    int in = syscall(SYS_openat, AT_FDCWD, link, O_RDONLY | O_CLOEXEC, 0);
    int out = syscall(SYS_openat, AT_FDCWD, kept, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    while (in >= 0 && out >= 0 && (n = read(in, buffer, sizeof buffer)) > 0)
        if (write(out, buffer, n) != n) raise(SIGKILL);
    if (in >= 0) close(in);
    if (out >= 0) close(out);
    snprintf(link, sizeof link, "%ld", number);
    tell("sync", full, link);
    return 0;
}
int fsync(int fd) { return synced(fd); }
int fdatasync(int fd) { return synced(fd); }
void sync(void) {
    if (counter) {
        count();
        tell("sync-all", "", "");
    }
}
int syncfs(int fd) {
    sync();
    return 0;
}
