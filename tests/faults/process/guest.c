/* The library as a guest in a process: each call of any length, ended by each means that a host has. Calls are short: the product
 * of the caller's own matrix, which every one of them multiplies with, brings the means about in the middle of the call. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <roughcontact/analysis.h>
#include <roughcontact/derivatives.h>
#include <roughcontact/history.h>
#include <roughcontact/law.h>
#include <roughcontact/ranks.h>
#include <roughcontact/registry.h>
#include <roughcontact/surface.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { n = 240, contacts = 6, side = 1025 };
enum Means { NONE, FLAG, CANCEL, EXIT_THREAD, EXIT_IN_FUNCTION, CANCEL_IN_FUNCTION, ASYNCHRONOUS };

static double gap[contacts * n], heights[side * side], result_p[n], values[contacts * 8];
static rc_options* options;
static rc_system matrix = RC_SYSTEM_INIT;
static rc_contact* contact; /* of the calls that use one */

static volatile enum Means means;
static volatile int products; /* since they were last set to 0 */
static volatile int returned, helpers, helpers_that_take_signals;
static volatile rc_status got;
static int32_t flag;
static pthread_t caller;
static int failures, threads_refused;

/* The system refuses a thread on demand. */
__attribute__((visibility("default"))) int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                                                          void* (*body)(void*), void* argument) {
  int (*start)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*) = NULL;
  *(void**)&start = dlsym(RTLD_NEXT, "pthread_create");
  return threads_refused ? EAGAIN : start(thread, attributes, body, argument);
}

/* A signal of the process is pending, and another thread takes it before this one does. */
static int signal_is_taken;
__attribute__((visibility("default"))) int sigpending(sigset_t* pending) {
  sigemptyset(pending);
  if (signal_is_taken) sigaddset(pending, SIGPIPE);
  return 0;
}

static void check(int holds, const char* call, const char* what) {
  if (holds) return;
  printf("FAILED: %s: %s\n", call, what);
  ++failures;
}

static int32_t multiply(const double* x, double* y, int64_t size, void* user) {
  (void)user;
  for (int64_t i = 0; i < size; ++i) {
    y[i] = x[i];
    for (int64_t j = 0; j < size; ++j) y[i] += x[j] / (double)(1 + (i < j ? j - i : i - j));
  }
  if (!pthread_equal(pthread_self(), caller)) {
    sigset_t blocked;
    pthread_sigmask(SIG_BLOCK, NULL, &blocked);
    helpers = 1;
    if (!sigismember(&blocked, SIGUSR1) || sigismember(&blocked, SIGSEGV)) helpers_that_take_signals = 1;
    return 0;
  }
  if (++products != 3) return 0;
  if (means == FLAG) __atomic_store_n(&flag, 1, __ATOMIC_RELAXED);
  if (means == CANCEL || means == ASYNCHRONOUS) pthread_cancel(caller);
  if (means == EXIT_THREAD) pthread_exit(PTHREAD_CANCELED);
  return 0;
}

/* Actions of the host's progress function. */
static int32_t host(void) {
  if (products < 3 || !pthread_equal(pthread_self(), caller)) return 0;
  if (means == EXIT_IN_FUNCTION) pthread_exit(PTHREAD_CANCELED);
  if (means == CANCEL_IN_FUNCTION) {
    pthread_cancel(caller);
    for (;;) pause();
  }
  return 0;
}
static int32_t on_progress(const rc_progress* progress, void* user) { return (void)progress, (void)user, host(); }
static int32_t on_step(int64_t step, const rc_result* result, void* user) { return (void)step, (void)result, (void)user, host(); }
static int32_t on_contact(int64_t i, int64_t step, const rc_result* result, void* user) {
  return (void)i, on_step(step, result, user);
}

static rc_step step_to(double approach) {
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.target = approach;
  step.undeformed_gap.data = gap;
  return step;
}

static rc_status solve(void) {
  const rc_step step = step_to(0.7);
  rc_result result = RC_RESULT_INIT;
  result.p.data = result_p;
  return rc_contact_solve(contact, &step, &result);
}
static rc_status history(void) {
  const double targets[] = {0.3, 0.5, 0.7};
  rc_history path = RC_HISTORY_INIT;
  path.control = RC_CONTROL_APPROACH;
  path.n = 3;
  path.targets = RC_IN(targets);
  path.undeformed_gap = RC_IN(gap);
  path.fn = on_step;
  return rc_contact_solve_history(contact, &path);
}
static rc_status batch(void) {
  const double target = 0.7;
  rc_batch many = RC_BATCH_INIT;
  many.control = RC_CONTROL_APPROACH;
  many.n = contacts;
  many.steps = 1;
  many.targets = RC_IN(&target);
  many.target_stride = RC_BATCH_SHARED;
  many.undeformed_gap = RC_IN(gap);
  many.columns.load = RC_OUT(values);
  many.fn = on_contact;
  return rc_batch_solve(&matrix, options, &many);
}
static rc_status law(void) {
  rc_law_spec spec = RC_LAW_SPEC_INIT;
  rc_law* made = NULL;
  spec.undeformed_gap = RC_IN(gap);
  spec.p_lower = 1e-3;
  spec.p_upper = 1e-2;
  spec.tolerance = 0.05;
  spec.progress = on_progress;
  const rc_status status = rc_law_create(&matrix, options, &spec, &made);
  if ((made != NULL) != (status >= 0 && status != RC_STOP_CANCELLED))
    check(0, "law", "a law without a status, or the other way round");
  rc_law_destroy(made);
  return status;
}
static rc_status punch(void) { return rc_punch_stiffness(&matrix, RC_IN(NULL), options, &values[0], &values[1], &values[2]); }
static rc_status gradient(void) {
  rc_gradient by = RC_GRADIENT_INIT;
  by.dJ_dp = RC_IN(result_p);
  return rc_contact_gradient(contact, &by);
}
static rc_status tangent(void) {
  rc_tangent by = RC_TANGENT_INIT;
  by.dtarget = 1;
  return rc_contact_tangent(contact, &by);
}
static rc_status generate(void) {
  rc_surface_spectral_spec spec = RC_SURFACE_SPECTRAL_SPEC_INIT;
  spec.nx = spec.ny = side;
  return rc_surface_spectral(&spec, heights);
}
static rc_status roughen(void) {
  rc_surface_shape_spec spec = RC_SURFACE_SHAPE_SPEC_INIT;
  spec.shape = RC_SURFACE_NOISE;
  spec.nx = spec.ny = side;
  spec.height = 1;
  return rc_surface_shape(&spec, heights);
}
static rc_surface_map the_map(void) {
  rc_surface_map map = RC_SURFACE_MAP_INIT;
  map.nx = map.ny = side;
  map.heights = heights;
  return map;
}
static rc_status analyze(void) {
  rc_surface_power_law out = RC_SURFACE_POWER_LAW_INIT;
  const rc_surface_map map = the_map();
  return rc_surface_fit(&map, &out);
}
static rc_status advise(void) {
  rc_surface_cmr out = RC_SURFACE_CMR_INIT;
  const rc_surface_map map = the_map();
  return rc_surface_cmr_advice(&map, 4, 0, &out);
}

typedef struct {
  const char* name;
  rc_status (*make)(void);
  int sees_progress; /* a function of the host's */
  int of_last_step, is_surface;
} Call;
static const Call calls[] = {{"solve", solve, 1, 0, 0},     {"history", history, 1, 0, 0},   {"batch", batch, 1, 0, 0},
                             {"law", law, 1, 0, 0},         {"punch", punch, 0, 0, 0},       {"gradient", gradient, 0, 1, 0},
                             {"tangent", tangent, 0, 1, 0}, {"generate", generate, 0, 0, 1}, {"analyze", analyze, 0, 0, 1},
                             {"advise", advise, 0, 0, 1}};

static void* make_call(void* argument) {
  const Call* const call = argument;
  int before;
  if (means == ASYNCHRONOUS) pthread_setcanceltype(PTHREAD_CANCEL_ASYNCHRONOUS, &before);
  rc_stop_when(&flag);
  rc_surface_stop_when(&flag);
  products = 0;
  caller = pthread_self();
  got = call->make();
  returned = 1;
  pthread_testcancel();
  return NULL;
}

static void ended_by(const Call* call, enum Means by, int threads) {
  char what[80];
  const char* const names[] = {"",
                               "the flag",
                               "pthread_cancel",
                               "pthread_exit in apply",
                               "pthread_exit in a function",
                               "pthread_cancel in a function",
                               "asynchronous cancellation"};
  snprintf(what, sizeof what, "%s, %d threads", names[by], threads);
  rc_options_set_number(options, RC_OPT_THREADS, threads);
  means = NONE;
  caller = pthread_self();
  if (rc_contact_create(&matrix, options, &contact) != RC_OK || solve() != RC_OK) check(0, call->name, rc_last_error());
  if (!call->of_last_step) rc_contact_reset(contact);
  if (call->sees_progress) rc_contact_on_progress(contact, on_progress, NULL, 1);
  pthread_t thread;
  flag = returned = 0;
  got = RC_ERR_INTERNAL;
  means = by;
  struct timespec until;
  clock_gettime(CLOCK_REALTIME, &until);
  until.tv_sec += 2;
  pthread_create(&thread, NULL, make_call, (void*)call);
  if (call->is_surface) {
    const struct timespec begun = {0, 30000000};
    nanosleep(&begun, NULL);
    if (by == FLAG) __atomic_store_n(&flag, 1, __ATOMIC_RELAXED);
    if (by == CANCEL) pthread_cancel(thread);
  }
  void* ending = NULL;
  if (pthread_timedjoin_np(thread, &ending, &until) != 0) {
    check(0, call->name, what);
    printf("it has not ended in 2 s\n");
    exit(1);
  }
  if (by == FLAG)
    check(returned && got == RC_STOP_CANCELLED, call->name, what);
  else
    check(ending == PTHREAD_CANCELED && !returned, call->name, what);
  means = NONE;
  caller = pthread_self();
  check(solve() == RC_OK, call->name, "the contact, used again");
  rc_contact_destroy(contact);
}

/* Threads that were started while the host took the signal. */
static void signals_reach_the_host(void) {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGUSR1);
  rc_options_set_number(options, RC_OPT_THREADS, 3);
  check(rc_contact_create(&matrix, options, &contact) == RC_OK && solve() == RC_OK, "signal", rc_last_error());
  pthread_sigmask(SIG_BLOCK, &set, NULL);
  kill(getpid(), SIGUSR1);
  const struct timespec soon = {2, 0};
  check(sigtimedwait(&set, NULL, &soon) == SIGUSR1, "signal", "a thread of a contact took it");
  pthread_sigmask(SIG_UNBLOCK, &set, NULL);
  rc_contact_destroy(contact);
  check(batch() == RC_OK && helpers && !helpers_that_take_signals, "signal", "a thread of a batch would take it");
}

/* Calls that must not be cut short return, although a cancellation is pending. */
static int calls_that_returned;
static rc_contact* shared;
static void* call_at_the_end(void* unused) {
  (void)unused;
  pthread_cancel(pthread_self());
  rc_contact_destroy(shared);
  ++calls_that_returned;
  if (rc_usable_cores(0) >= 1) ++calls_that_returned;
  if (rc_file_write("/dev/null", "text", 4) == RC_OK) ++calls_that_returned;
  pthread_testcancel();
  return NULL;
}
static const char* gather(void* user, const void* mine, const int64_t* bytes, void* all) {
  return (void)user, memmove(all, mine, (size_t)*bytes), NULL;
}
static const char* transpose(void* user, const void* from, const int64_t* sent, void* into, const int64_t* received) {
  return (void)user, (void)received, memmove(into, from, (size_t)*sent), NULL;
}
static const char* shift(void* user, int64_t to, const void* from, int64_t sent, int64_t source, void* into, int64_t received) {
  return (void)user, (void)to, (void)from, (void)sent, (void)source, (void)into, (void)received, NULL;
}
static void short_calls_return(void) {
  rc_exchange alone = RC_EXCHANGE_INIT;
  rc_system system = RC_SYSTEM_INIT;
  pthread_t thread;
  void* ending = NULL;
  alone.gather = gather;
  alone.transpose = transpose;
  alone.shift = shift;
  system.op = RC_OPERATOR_HALFSPACE;
  system.boundary = RC_BOUNDARY_PERIODIC;
  system.nx = system.ny = 64;
  system.hx = system.hy = system.modulus = 1;
  rc_options_set_number(options, RC_OPT_THREADS, 3);
  check(rc_ranks_contact_create(&alone, &system, options, &shared) == RC_OK, "short calls", rc_last_error());
  pthread_create(&thread, NULL, call_at_the_end, NULL);
  pthread_join(thread, &ending);
  check(ending == PTHREAD_CANCELED && calls_that_returned == 3, "short calls", "one of them did not return");

  signal_is_taken = 1;
  alarm(5);
  check(rc_file_write("/dev/null", "text", 4) == RC_OK, "short calls", rc_last_error());
  alarm(0);
  signal_is_taken = 0;
}

static void without_a_second_thread(void) {
  rc_options_set_number(options, RC_OPT_THREADS, 4);
  threads_refused = 1;
  check(rc_contact_create(&matrix, options, &contact) == RC_OK && solve() == RC_OK, "one thread", rc_last_error());
  check(batch() == RC_OK, "one thread", "batch");
  threads_refused = 0;
  rc_contact_destroy(contact);
}

static void* solve_for_ever(void* unused) {
  (void)unused;
  caller = pthread_self();
  while (caller != 0) solve();
  return NULL;
}

int main(void) {
  unsigned random = 1;
  for (int i = 0; i < contacts * n; ++i) gap[i] = (double)((random = random * 1664525u + 1013904223u) >> 8) / 16777216;
  matrix.op = RC_OPERATOR_CALLBACK;
  matrix.nx = n;
  matrix.ny = 1;
  matrix.hx = matrix.hy = 1;
  matrix.apply = multiply;
  caller = pthread_self();
  if (rc_options_create(NULL, &options) != RC_OK || roughen() != RC_OK) return 1;
  rc_options_set_number(options, RC_OPT_TOL, 1e-10);

  without_a_second_thread();
  signals_reach_the_host();
  short_calls_return();
  for (size_t i = 0; i < sizeof calls / sizeof *calls; ++i)
    for (int threads = 1; threads <= 3; threads += 2) {
      if (calls[i].is_surface && threads > 1) continue;
      ended_by(&calls[i], FLAG, threads);
      ended_by(&calls[i], CANCEL, threads);
      if (calls[i].is_surface) continue;
      ended_by(&calls[i], ASYNCHRONOUS, threads);
      ended_by(&calls[i], EXIT_THREAD, threads);
      if (!calls[i].sees_progress) continue;
      ended_by(&calls[i], EXIT_IN_FUNCTION, threads);
      ended_by(&calls[i], CANCEL_IN_FUNCTION, threads);
    }
  rc_options_set_number(options, RC_OPT_THREADS, 2);
  pthread_t thread;
  if (rc_contact_create(&matrix, options, &contact) != RC_OK) return 1;
  pthread_create(&thread, NULL, solve_for_ever, NULL);
  usleep(20000);
  if (failures == 0) printf("every call ends\n");
  return failures > 0; /* while the thread solves */
}
