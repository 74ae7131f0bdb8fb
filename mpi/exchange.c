#include "exchange.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

enum {
  most = 1 << 30, /* bytes of one message: MPI counts in int */
  window = 16     /* other ranks with which a transposition exchanges at a time */
};

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

/* Writes the ranks' byte counts and offsets as int; 0 if one does not fit. */
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

/* The bytes of the next message, if so many are left. */
static int piece(int64_t left) {
  if (left < 0) return 0;
  return (int)(left < most ? left : most);
}

/* Bytes to one rank and from another, in pieces of `most` bytes, whose numbers are known to all. After a failure the others are
   still sent, because a rank waits for each. */
static const char* shift(void* user, int64_t to, const void* from, int64_t sent, int64_t source, void* into, int64_t received) {
  struct rc_mpi_link* link = user;
  const char *give = from, *failed = NULL;
  char* take = into;
  for (; sent > 0 || received > 0; sent -= most, received -= most, give += most, take += most) {
    const int out = piece(sent), in = piece(received);
    const int code = MPI_Sendrecv(give, out, MPI_BYTE, out > 0 ? (int)to : MPI_PROC_NULL, 1, take, in, MPI_BYTE,
                                  in > 0 ? (int)source : MPI_PROC_NULL, 1, link->comm, MPI_STATUS_IGNORE);
    if (!failed) failed = said(link, "MPI_Sendrecv", code);
  }
  return failed;
}

/* Messages to and from `window` other ranks are under way at a time, so that their latencies overlap and none is swamped. Larger
   ones than `most` bytes go in pieces. MPI_Alltoallv counts in int, which is too small for large grids, and ranks would have to
   agree on where it is. */
static const char* transpose(void* user, const void* from, const int64_t* sent, void* into, const int64_t* received) {
  struct rc_mpi_link* link = user;
  const int ranks = link->ranks, rank = link->rank;
  int64_t *give = link->places, *take = link->places + ranks, given = 0, taken = 0;
  const char* failed = NULL;
  for (int r = 0; r < ranks; given += sent[r], taken += received[r], ++r) {
    give[r] = given;
    take[r] = taken;
  }
  memcpy((char*)into + take[rank], (const char*)from + give[rank], (size_t)sent[rank]);
  for (int first = 1; first < ranks; first += window)
    for (int64_t at = 0, left = 1; left > 0; at += most) {
      MPI_Request requests[2 * window];
      int count = 0;
      left = 0;
      for (int k = first; k < ranks && k < first + window; ++k) {
        const int to = (rank + k) % ranks, source = (rank - k + ranks) % ranks;
        const int out = piece(sent[to] - at), in = piece(received[source] - at);
        left |= sent[to] - at > most || received[source] - at > most;
        requests[count] = requests[count + 1] = MPI_REQUEST_NULL;
        if (in > 0) {
          const int code = MPI_Irecv((char*)into + take[source] + at, in, MPI_BYTE, source, 2, link->comm, &requests[count]);
          if (!failed) failed = said(link, "MPI_Irecv", code);
        }
        if (out > 0) {
          const int code = MPI_Isend((const char*)from + give[to] + at, out, MPI_BYTE, to, 2, link->comm, &requests[count + 1]);
          if (!failed) failed = said(link, "MPI_Isend", code);
        }
        count += 2;
      }
      const int code = MPI_Waitall(count, requests, MPI_STATUSES_IGNORE);
      if (!failed) failed = said(link, "MPI_Waitall", code);
    }
  return failed;
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
