/* Preloaded into a program (LD_PRELOAD), makes one of its calls fail, or sends it a signal there. glibc only.
 *
 * RC_FAULT        which calls count, from the start of main on:
 *                 alloc   malloc, calloc, realloc, aligned_alloc, posix_memalign, memalign
 *                 write   write, fwrite, fputs, fflush; the file of a stream is full from then on
 *                 close   close, fclose; the file is closed nevertheless
 *                 open, rename, fsync
 * RC_FAULT_AT     k: the k-th of them fails; 0 (default): none, they are only counted
 * RC_FAULT_EVERY  1: every k-th fails; 2: all from the k-th on
 * RC_FAULT_LEAST, RC_FAULT_MOST   alloc: sizes that count [bytes]
 * RC_FAULT_HOW    "short": half of it is written; a number: this signal is sent, and the call made; default: fails
 * RC_FAULT_LOG    file that gets a line "struck N" at every fault, "calls N" at a regular end
 *
 * Children do not inherit the fault. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { no_call, alloc_call, write_call, close_call, open_call, rename_call, fsync_call };
static const char* const names[] = {"", "alloc", "write", "close", "open", "rename", "fsync"};

static int counted = no_call;
static long at = 0, every = 0, least = 0, most = 0;
static int shortened = 0, signal_number = 0;
static const char* log_name = NULL;
static atomic_long calls;

static long number(const char* name, long otherwise) {
  const char* text = getenv(name);
  return text ? atol(text) : otherwise;
}

/* By system calls alone: nothing here may be counted or fail. */
static void log_line(const char* what, long count) {
  char line[64];
  if (!log_name) return;
  const int length = snprintf(line, sizeof line, "%s %ld\n", what, count);
  const long file = syscall(SYS_openat, AT_FDCWD, log_name, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) return;
  syscall(SYS_write, file, line, (size_t)length);
  syscall(SYS_close, file);
}

static void begin(void) {
  const char *const call = getenv("RC_FAULT"), *const how = getenv("RC_FAULT_HOW");
  at = number("RC_FAULT_AT", 0);
  every = number("RC_FAULT_EVERY", 0);
  least = number("RC_FAULT_LEAST", 0);
  most = number("RC_FAULT_MOST", 0);
  log_name = getenv("RC_FAULT_LOG");
  shortened = how && strcmp(how, "short") == 0;
  signal_number = how ? atoi(how) : 0;
  unsetenv("LD_PRELOAD");
  for (int k = alloc_call; call && k <= fsync_call; ++k)
    if (strcmp(call, names[k]) == 0) counted = k;
}

__attribute__((destructor)) static void end(void) {
  const long count = atomic_load(&calls);
  if (counted != no_call) log_line("calls", count);
  counted = no_call;
}

typedef int main_function(int, char**, char**);
typedef int start_function(main_function*, int, char**, void (*)(void), void (*)(void), void (*)(void), void*);
static main_function* own_main;

static int main_with_faults(int argc, char** argv, char** environment) {
  begin();
  return own_main(argc, argv, environment);
}

/* What calls main, after the constructors of libraries and program, which have no one to tell of a failure. */
start_function __libc_start_main;
int __libc_start_main(main_function* program, int argc, char** argv, void (*init)(void), void (*fini)(void),
                      void (*end_of_linker)(void), void* stack) {
  start_function* start = NULL;
  void* const found = dlsym(RTLD_NEXT, "__libc_start_main");
  memcpy(&start, &found, sizeof start);
  own_main = program;
  return start(main_with_faults, argc, argv, init, fini, end_of_linker, stack);
}

/* True where this call is to fail. */
static int strikes(int call) {
  if (call != counted) return 0;
  const long k = atomic_fetch_add(&calls, 1) + 1;
  if (at == 0 || !(k == at || (every == 1 && k % at == 0) || (every == 2 && k > at))) return 0;
  const int error = errno;
  log_line("struck", k);
  if (signal_number) kill(getpid(), signal_number);
  errno = error;
  return signal_number == 0;
}

static int refuses(size_t size) {
  if (counted != alloc_call || size < (size_t)least || (most > 0 && size > (size_t)most)) return 0;
  return strikes(alloc_call);
}

static int fails(int error) {
  errno = error;
  return -1;
}

/* glibc's functions by their other names. */
extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);
extern size_t _IO_fwrite(const void*, size_t, size_t, FILE*);
extern int _IO_fputs(const char*, FILE*);
extern int _IO_fflush(FILE*);
extern int _IO_fclose(FILE*);

static void* no_memory(void) {
  errno = ENOMEM;
  return NULL;
}

void* malloc(size_t size) { return refuses(size) ? no_memory() : __libc_malloc(size); }
void* calloc(size_t count, size_t size) { return refuses(count * size) ? no_memory() : __libc_calloc(count, size); }
void* realloc(void* old, size_t size) { return refuses(size) ? no_memory() : __libc_realloc(old, size); }
void* memalign(size_t alignment, size_t size) { return refuses(size) ? no_memory() : __libc_memalign(alignment, size); }
void* aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }
int posix_memalign(void** out, size_t alignment, size_t size) {
  void* const found = refuses(size) ? NULL : __libc_memalign(alignment, size);
  if (!found) return ENOMEM;
  *out = found;
  return 0;
}

/* The stream's own buffer and error mark do as they would on a full disk. */
static void fill_up(FILE* stream) {
  const int file = fileno(stream);
  const long full = syscall(SYS_openat, AT_FDCWD, "/dev/full", O_WRONLY | O_CLOEXEC, 0);
  if (file >= 0 && full >= 0) syscall(SYS_dup3, full, file, O_CLOEXEC);
  if (full >= 0) syscall(SYS_close, full);
}

ssize_t write(int file, const void* bytes, size_t size) {
  if (!strikes(write_call)) return syscall(SYS_write, file, bytes, size);
  return shortened && size > 1 ? syscall(SYS_write, file, bytes, size / 2) : fails(ENOSPC);
}

size_t fwrite(const void* bytes, size_t size, size_t count, FILE* stream) {
  if (strikes(write_call)) {
    if (shortened) _IO_fwrite(bytes, size, count / 2, stream);
    if (shortened) _IO_fflush(stream);
    fill_up(stream);
  }
  return _IO_fwrite(bytes, size, count, stream);
}

int fputs(const char* text, FILE* stream) {
  if (strikes(write_call)) fill_up(stream);
  return _IO_fputs(text, stream);
}

int fflush(FILE* stream) {
  if (stream && strikes(write_call)) fill_up(stream);
  return _IO_fflush(stream);
}

int close(int file) {
  const int struck = strikes(close_call);
  const int closed = (int)syscall(SYS_close, file);
  return struck ? fails(EIO) : closed;
}

int fclose(FILE* stream) {
  const int struck = strikes(close_call);
  const int closed = _IO_fclose(stream);
  return struck ? fails(EIO) : closed;
}

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const int mode = flags & O_CREAT ? va_arg(rest, int) : 0;
  va_end(rest);
  return strikes(open_call) ? fails(EMFILE) : (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
}

int rename(const char* from, const char* to) {
  return strikes(rename_call) ? fails(EIO) : (int)syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0u);
}
int fsync(int file) { return strikes(fsync_call) ? fails(EIO) : (int)syscall(SYS_fsync, file); }
