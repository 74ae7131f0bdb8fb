#include "exchange.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

enum { most = 1 << 30 }; /* bytes of one message: MPI counts in int */

static const char* said(struct rc_mpi_link* link, const char* what, int code) {
  char text[MPI_MAX_ERROR_STRING] = "";
  int length = 0;
  if (code == MPI_SUCCESS) return NULL;
  MPI_Error_string(code, text, &length);
  snprintf(link->text, sizeof link->text, "%s failed: %s", what, text);
  return link->text;
}

const char* rc_mpi_refuse(MPI_Comm comm) {
  int flag = 0;
  if (MPI_Initialized(&flag) != MPI_SUCCESS || !flag) return "MPI is not initialised; call MPI_Init first";
  if (MPI_Finalized(&flag) != MPI_SUCCESS || flag) return "MPI is finalised already";
  if (comm == MPI_COMM_NULL) return "the communicator is MPI_COMM_NULL";
  if (MPI_Comm_test_inter(comm, &flag) != MPI_SUCCESS) return "the communicator is not valid";
  if (flag) return "the communicator is an intercommunicator; merge it with MPI_Intercomm_merge";
  return NULL;
}

/* Whether so many bytes for each rank can be told in int, and where they begin. */
static int fits(int ranks, const int64_t* bytes, int* count, int* place) {
  int64_t all = 0;
  for (int r = 0; r < ranks; ++r) {
    if (all > INT_MAX || bytes[r] > INT_MAX) return 0;
    place[r] = (int)all;
    count[r] = (int)bytes[r];
    all += bytes[r];
  }
  return 1;
}

static const char* gather(void* user, const void* mine, const int64_t* bytes, void* all) {
  struct rc_mpi_link* link = user;
  int *count = link->counts, *place = count + link->ranks;
  char* to = all;
  if (fits(link->ranks, bytes, count, place))
    return said(link, "MPI_Allgatherv",
                MPI_Allgatherv(mine, count[link->rank], MPI_BYTE, all, count, place, MPI_BYTE, link->comm));
  for (int r = 0; r < link->ranks; to += bytes[r++]) {
    if (r == link->rank) memmove(to, mine, (size_t)bytes[r]);
    for (int64_t at = 0; at < bytes[r]; at += most) {
      const int64_t left = bytes[r] - at;
      const int code = MPI_Bcast(to + at, (int)(left < most ? left : most), MPI_BYTE, r, link->comm);
      if (code != MPI_SUCCESS) return said(link, "MPI_Bcast", code);
    }
  }
  return NULL;
}

/* Messages between pairs, as MPI_Alltoallv would send them: its counts in int are too small for large grids, and ranks would have
   to agree on where they are. Each is cut into pieces of `most` bytes, whose number is known to both ranks. */
static const char* transpose(void* user, const void* from, const int64_t* sent, void* into, const int64_t* received) {
  struct rc_mpi_link* link = user;
  const char* failed = NULL;
  int more = 1;
  for (int64_t at = 0; more; at += most) {
    const char* give = from;
    char* take = into;
    int open = 0, code = MPI_SUCCESS;
    more = 0;
    for (int r = 0; r < link->ranks; take += received[r], give += sent[r], ++r) {
      const int64_t in = received[r] - at, out = sent[r] - at;
      if (r == link->rank) {
        if (at == 0) memcpy(take, give, (size_t)in);
        continue;
      }
      if (in > 0) code = MPI_Irecv(take + at, (int)(in < most ? in : most), MPI_BYTE, r, 1, link->comm, &link->open[open++]);
      if (code != MPI_SUCCESS && !failed) failed = said(link, "MPI_Irecv", code);
      if (out > 0) code = MPI_Isend(give + at, (int)(out < most ? out : most), MPI_BYTE, r, 1, link->comm, &link->open[open++]);
      if (code != MPI_SUCCESS && !failed) failed = said(link, "MPI_Isend", code);
      more = more || in > most || out > most;
    }
    code = MPI_Waitall(open, link->open, link->done);
    if (code != MPI_SUCCESS && !failed) failed = said(link, "MPI_Waitall", code);
  }
  return failed;
}

static const char* shift(void* user, int64_t to, const void* from, int64_t sent, int64_t source, void* into, int64_t received) {
  struct rc_mpi_link* link = user;
  const int next = to < 0 ? MPI_PROC_NULL : (int)to, previous = source < 0 ? MPI_PROC_NULL : (int)source;
  const char* give = from;
  char* take = into;
  do {
    const int out = (int)(sent < most ? sent : most), in = (int)(received < most ? received : most);
    const int code = MPI_Sendrecv(give, out, MPI_BYTE, next, 2, take, in, MPI_BYTE, previous, 2, link->comm, MPI_STATUS_IGNORE);
    if (code != MPI_SUCCESS) return said(link, "MPI_Sendrecv", code);
    give += out;
    take += in;
    sent -= out;
    received -= in;
  } while (sent > 0 || received > 0);
  return NULL;
}

rc_exchange rc_mpi_exchange(struct rc_mpi_link* link) {
  rc_exchange exchange = RC_EXCHANGE_INIT;
  exchange.rank = link->rank;
  exchange.ranks = link->ranks;
  exchange.user = link;
  exchange.gather = gather;
  exchange.transpose = transpose;
  exchange.shift = shift;
  return exchange;
}
