/* What replay.c makes of three functions of MPI in mpi/exchange.c. SMPI lets a sender of few bytes go on at once, and keeps such
   sends of all ranks in one list, in which it looks for each that ends: that took most of the time with 256 ranks. Here they are
   sends that are waited for, of which each rank has its own list; those of few bytes are waited for once they have arrived, which
   takes no simulated time. All ranks are in one process: they look into each other's numbers of what has arrived. */
#include "replay_sends.h"

#include <stdlib.h>

enum { few = 65536, most_requests = 32 }; /* bytes: SMPI's option smpi/send-is-detached-thresh; requests of a window */

typedef struct sent {
  MPI_Request request;
  int to, number; /* of those to that rank */
} sent;

static const int** arrived_at; /* by rank: how many messages it has from each other one */
static int *arrived, *given;   /* by rank: from it, to it */
static sent* sends;            /* of few bytes, and not waited for yet; by age */
static int begun, ended, room;
static int rank;
static struct {
  MPI_Request* request;
  int from;
} receives[most_requests];
static int receiving;

static int keep(sent one) {
  if (begun == room && ended > 0) {
    for (int k = ended; k < begun; ++k) sends[k - ended] = sends[k];
    begun -= ended;
    ended = 0;
  }
  if (begun == room) {
    room = room > 0 ? 2 * room : 64;
    sends = realloc(sends, (size_t)room * sizeof *sends);
    if (!sends) return MPI_ERR_NO_MEM;
  }
  sends[begun++] = one;
  return MPI_SUCCESS;
}

static int drop(int also_what_is_under_way) {
  int code = MPI_SUCCESS;
  for (; ended < begun && code == MPI_SUCCESS; ++ended) {
    if (!also_what_is_under_way && arrived_at[sends[ended].to][rank] < sends[ended].number) break;
    code = MPI_Wait(&sends[ended].request, MPI_STATUS_IGNORE);
  }
  return code;
}

void replay_sends_begin(MPI_Comm comm) {
  int ranks;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &ranks);
  arrived = calloc((size_t)ranks * 2, sizeof *arrived);
  arrived_at = malloc((size_t)ranks * sizeof *arrived_at);
  if (!arrived || !arrived_at) MPI_Abort(comm, 1);
  given = arrived + ranks;
  MPI_Allgather(&arrived, sizeof arrived, MPI_BYTE, arrived_at, sizeof arrived, MPI_BYTE, comm);
}

void replay_sends_end(void) { drop(1); }

int replay_isend(const void* from, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm, MPI_Request* request) {
  sent one = {MPI_REQUEST_NULL, to, ++given[to]};
  const int code = MPI_Issend(from, count, type, to, tag, comm, &one.request);
  *request = count < few ? MPI_REQUEST_NULL : one.request;
  return code == MPI_SUCCESS && count < few ? keep(one) : code;
}

int replay_irecv(void* into, int count, MPI_Datatype type, int from, int tag, MPI_Comm comm, MPI_Request* request) {
  if (receiving == most_requests) return MPI_ERR_COUNT;
  receives[receiving].request = request;
  receives[receiving++].from = from;
  return MPI_Irecv(into, count, type, from, tag, comm, request);
}

/* One after the other: SMPI's own looks at all of them for each that ends. */
int replay_waitall(int count, MPI_Request requests[], MPI_Status* statuses) {
  int code = MPI_SUCCESS;
  (void)statuses;
  for (int k = 0; k < receiving && code == MPI_SUCCESS; ++k) {
    code = MPI_Wait(receives[k].request, MPI_STATUS_IGNORE);
    ++arrived[receives[k].from];
  }
  receiving = 0;
  for (int k = 0; k < count && code == MPI_SUCCESS; ++k)
    if (requests[k] != MPI_REQUEST_NULL) code = MPI_Wait(&requests[k], MPI_STATUS_IGNORE);
  return code == MPI_SUCCESS ? drop(0) : code;
}
