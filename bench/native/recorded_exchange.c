/* rc_mpi_exchange that writes down what a rank does in a solve: the processor's seconds before each exchange, and what the
   exchange carries. replay.c does the same exchanges again, on a network. exchange.c is linked with its own function renamed. */
#include "recorded_exchange.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

rc_exchange rc_mpi_plain_exchange(struct rc_mpi_link* link);

enum { most_patterns = 4096 };

static rc_exchange plain;
static FILE* out;
static int64_t* patterns[most_patterns]; /* lists of bytes by rank, each written once */
static int known;
static double since; /* of the burst that goes on */

static double processor_seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void burst(void) {
  if (out) fprintf(out, "c %.9f\n", processor_seconds() - since);
}
static void go_on(void) { since = processor_seconds(); }

static int pattern(const int64_t* bytes) {
  const size_t size = (size_t)plain.ranks * sizeof *bytes;
  if (!out) return 0;
  for (int k = 0; k < known; ++k)
    if (memcmp(patterns[k], bytes, size) == 0) return k;
  if (known == most_patterns || !(patterns[known] = malloc(size))) abort();
  memcpy(patterns[known], bytes, size);
  fprintf(out, "p");
  for (int64_t r = 0; r < plain.ranks; ++r) fprintf(out, " %lld", (long long)bytes[r]);
  fprintf(out, "\n");
  return known++;
}

static const char* gather(void* user, const void* mine, const int64_t* bytes, void* all) {
  burst();
  const int which = pattern(bytes);
  if (out) fprintf(out, "g %d\n", which);
  const char* const failed = plain.gather(user, mine, bytes, all);
  go_on();
  return failed;
}

static const char* transpose(void* user, const void* from, const int64_t* sent, void* into, const int64_t* received) {
  burst();
  const int one = pattern(sent), other = pattern(received);
  if (out) fprintf(out, "t %d %d\n", one, other);
  const char* const failed = plain.transpose(user, from, sent, into, received);
  go_on();
  return failed;
}

static const char* shift(void* user, int64_t to, const void* from, int64_t sent, int64_t source, void* into, int64_t received) {
  burst();
  if (out) fprintf(out, "s %lld %lld %lld %lld\n", (long long)to, (long long)sent, (long long)source, (long long)received);
  const char* const failed = plain.shift(user, to, from, sent, source, into, received);
  go_on();
  return failed;
}

rc_exchange rc_mpi_exchange(struct rc_mpi_link* link) {
  rc_exchange exchange = plain = rc_mpi_plain_exchange(link);
  exchange.gather = gather;
  exchange.transpose = transpose;
  exchange.shift = shift;
  return exchange;
}

void record_begin(void) {
  const char* const folder = getenv("RC_RECORD_TO");
  char path[4096];
  if (!folder) return;
  snprintf(path, sizeof path, "%s/%d", folder, (int)plain.rank);
  out = fopen(path, "w");
  if (!out) abort();
  go_on();
}

void record_end(void) {
  if (!out) return;
  burst();
  if (fclose(out) != 0) abort();
  out = NULL;
}
