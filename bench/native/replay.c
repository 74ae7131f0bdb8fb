/* replay FOLDER: does what recorded_exchange.c has written down, for SimGrid's SMPI: each burst takes the seconds that are
   written there, each exchange is that of mpi/exchange.c with as many bytes. Rank 0 prints a line of JSON. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exchange.h"

static void stop(const char* what) {
  fprintf(stderr, "replay: %s\n", what);
  MPI_Abort(MPI_COMM_WORLD, 1);
}

static void* room(size_t bytes) {
  void* const memory = calloc(bytes > 0 ? bytes : 1, 1);
  if (!memory) stop("no memory");
  return memory;
}

static int64_t sum(const int64_t* bytes, int count) {
  int64_t all = 0;
  for (int r = 0; r < count; ++r) all += bytes[r];
  return all;
}

/* One buffer for what is sent and one for what is received, which only grow. */
static void fit(char** buffer, int64_t* size, int64_t wanted) {
  if (wanted <= *size) return;
  free(*buffer);
  *buffer = room((size_t)wanted);
  *size = wanted;
}

int main(int argc, char** argv) {
  struct rc_mpi_link link = {MPI_COMM_WORLD, 0, 1, NULL, NULL, ""};
  char path[4096], kind;
  int64_t** patterns = NULL;
  int known = 0;
  char *give = NULL, *take = NULL;
  int64_t give_size = 0, take_size = 0;
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &link.rank);
  MPI_Comm_size(MPI_COMM_WORLD, &link.ranks);
  link.counts = room((size_t)link.ranks * 2 * sizeof(int));
  link.places = room((size_t)link.ranks * 2 * sizeof(int64_t));
  const rc_exchange exchange = rc_mpi_exchange(&link);
  if (argc < 2) stop("no folder is given");
  snprintf(path, sizeof path, "%s/%d", argv[1], link.rank);
  FILE* const in = fopen(path, "r");
  if (!in) stop(path);
  MPI_Barrier(MPI_COMM_WORLD);
  const double begin = MPI_Wtime();
  while (fscanf(in, " %c", &kind) == 1) {
    const char* failed = NULL;
    if (kind == 'c') {
      double seconds = 0;
      if (fscanf(in, "%lf", &seconds) != 1) stop("a burst has no seconds");
      smpi_execute(seconds);
    } else if (kind == 'p') {
      int64_t* const bytes = room((size_t)link.ranks * sizeof(int64_t));
      for (int r = 0; r < link.ranks; ++r)
        if (fscanf(in, "%" SCNd64, &bytes[r]) != 1) stop("a list of bytes is too short");
      patterns = realloc(patterns, (size_t)(known + 1) * sizeof *patterns);
      if (!patterns) stop("no memory");
      patterns[known++] = bytes;
    } else if (kind == 'g') {
      int which = 0;
      if (fscanf(in, "%d", &which) != 1 || which >= known) stop("a gather without its bytes");
      fit(&give, &give_size, patterns[which][link.rank]);
      fit(&take, &take_size, sum(patterns[which], link.ranks));
      failed = exchange.gather(exchange.user, give, patterns[which], take);
    } else if (kind == 't') {
      int sent = 0, received = 0;
      if (fscanf(in, "%d %d", &sent, &received) != 2 || sent >= known || received >= known)
        stop("a transposition without its bytes");
      fit(&give, &give_size, sum(patterns[sent], link.ranks));
      fit(&take, &take_size, sum(patterns[received], link.ranks));
      failed = exchange.transpose(exchange.user, give, patterns[sent], take, patterns[received]);
    } else if (kind == 's') {
      int64_t to = 0, sent = 0, source = 0, received = 0;
      if (fscanf(in, "%" SCNd64 " %" SCNd64 " %" SCNd64 " %" SCNd64, &to, &sent, &source, &received) != 4)
        stop("a shift is not complete");
      fit(&give, &give_size, sent);
      fit(&take, &take_size, received);
      failed = exchange.shift(exchange.user, to, give, sent, source, take, received);
    } else {
      stop("not a record");
    }
    if (failed) stop(failed);
  }
  const double seconds = MPI_Wtime() - begin;
  double most = 0;
  MPI_Reduce(&seconds, &most, 1, MPI_DOUBLE, MPI_MAX, 0, MPI_COMM_WORLD);
  if (link.rank == 0) printf("{\"seconds\": %.6g}\n", most);
  MPI_Finalize();
  return 0;
}
