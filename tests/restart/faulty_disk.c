/* A disk that is slow or fails, for programs started with LD_PRELOAD: the program under test is the one its users have.
 *   FAULTY_DISK_DELAY_US=N    every operation takes N microseconds more, and a write is done in two halves
 *   FAULTY_DISK_FAIL=A-B      the operations number A to B (from 1) fail, after half of what they are to write
 *   FAULTY_DISK_ERRNO=N       with this error; 28, no space left on device, unless it is given
 * Operations are those that change files: open to create, write, truncate, flush, rename. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static long delay, first_to_fail, last_to_fail, error_number;
static atomic_long n_operations;

__attribute__((constructor)) static void read_settings(void) {
  const char *text = getenv("FAULTY_DISK_DELAY_US");
  delay = text ? atol(text) : 0;
  text = getenv("FAULTY_DISK_FAIL");
  if (text) sscanf(text, "%ld-%ld", &first_to_fail, &last_to_fail);
  text = getenv("FAULTY_DISK_ERRNO");
  error_number = text ? atol(text) : ENOSPC;
}

/* Counts an operation; whether it is to fail. */
static int begin(void) {
  const long number = ++n_operations;
  if (delay > 0) usleep((useconds_t)delay);
  return number >= first_to_fail && number <= last_to_fail;
}

static int fail(void) {
  errno = (int)error_number;
  return -1;
}

static int is_file(int descriptor) {
  struct stat status;
  return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

#define REAL(result, name, ...) ((result(*)(__VA_ARGS__))dlsym(RTLD_NEXT, #name))

ssize_t write(int descriptor, const void *bytes, size_t size) {
  ssize_t (*real)(int, const void *, size_t) = REAL(ssize_t, write, int, const void *, size_t);
  if (!is_file(descriptor)) return real(descriptor, bytes, size);
  if (begin()) {
    if (size > 1 && real(descriptor, bytes, size / 2) < 0) return -1;
    return fail();
  }
  if (delay == 0 || size < 2) return real(descriptor, bytes, size);
  const ssize_t n_first = real(descriptor, bytes, size / 2);
  usleep((useconds_t)delay);
  return n_first;
}

ssize_t writev(int descriptor, const struct iovec *parts, int n_parts) {
  if (is_file(descriptor) && begin()) return fail();
  return REAL(ssize_t, writev, int, const struct iovec *, int)(descriptor, parts, n_parts);
}

static int open_by(int (*real)(const char *, int, ...), const char *path, int flags, mode_t mode) {
  if ((flags & O_CREAT) != 0 && begin()) return fail();
  return real(path, flags, mode);
}

#define DEFINE_OPEN(name)                                                     \
  int name(const char *path, int flags, ...) {                                \
    va_list more;                                                             \
    va_start(more, flags);                                                    \
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;    \
    va_end(more);                                                             \
    return open_by(REAL(int, name, const char *, int, ...), path, flags, mode); \
  }
DEFINE_OPEN(open)
DEFINE_OPEN(open64)

#define DEFINE_TRUNCATE(name)                          \
  int name(int descriptor, off_t size) {               \
    if (begin()) return fail();                        \
    return REAL(int, name, int, off_t)(descriptor, size); \
  }
DEFINE_TRUNCATE(ftruncate)
DEFINE_TRUNCATE(ftruncate64)

int fsync(int descriptor) {
  if (begin()) return fail();
  return REAL(int, fsync, int)(descriptor);
}

int rename(const char *from, const char *to) {
  if (begin()) return fail();
  return REAL(int, rename, const char *, const char *)(from, to);
}
