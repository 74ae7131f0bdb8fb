// A rank that gets no memory while a contact is created or solved: whichever allocation it is, every rank has the same status and
// message, none waits for ever, and the next solve of the same contact gives what it gave before.
#include <roughcontact/mpi.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

extern "C" {
#include "scenes.h"
}
#include "support/failing_new.h"

namespace {

int rank, ranks, failures;
rc_exchange exchange = RC_EXCHANGE_INIT;

void check(bool holds, const char* scene_name, std::int64_t at, const char* what) {
  if (holds) return;
  ++failures;
  std::fprintf(stderr, "rank %d: %s, allocation %lld: %s: %s\n", rank, scene_name, static_cast<long long>(at), what,
               rc_last_error());
}

// Whether all ranks have this text.
bool everywhere(const std::string& text) {
  char first[600] = "";
  std::snprintf(first, sizeof first, "%s", text.c_str());
  MPI_Bcast(first, sizeof first, MPI_CHAR, 0, MPI_COMM_WORLD);
  int mine = text == first, all = 0;
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  return all != 0;
}

// A contact of a scene, and its answer.
class Job {
 public:
  explicit Job(const scene& s) : j_(job_of(&exchange, &s, 1)), n_(static_cast<std::size_t>(s.nx * j_.count)) {
    j_.step.warm_start = 0;
  }
  ~Job() {
    drop();
    free_job(j_);
  }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  bool made() const { return contact_ != nullptr; }
  void drop() {
    rc_contact_destroy(contact_);
    contact_ = nullptr;
  }
  // Creates the contact, where there is none, and solves. fails_at: the allocation that fails, 0: none; whether it was reached.
  rc_status run(std::int64_t fails_at, bool& failed) {
    support::fail_allocation(fails_at);
    rc_status status = contact_ ? RC_OK : rc_ranks_contact_create(&exchange, &j_.system, j_.options, &contact_);
    if (status == RC_OK) status = rc_contact_solve(contact_, &j_.step, &j_.result);
    failed = support::allocation_failed();
    support::fail_allocation(0);
    return status;
  }

  std::vector<double> p() const { return {j_.p, j_.p + n_}; }

 private:
  job j_;
  const std::size_t n_;
  rc_contact* contact_ = nullptr;
};

// An allocation of one rank fails: every `step`-th of the first `dense`, then ever fewer, each time on another rank. anew: of the
// contact's creation and its first solve; else of a later solve.
void every_allocation(const scene& s, bool anew, std::int64_t dense, std::int64_t step) {
  Job job(s);
  bool failed = false;
  check(job.run(0, failed) == RC_OK, s.name, 0, "create and solve");
  const std::vector<double> known = job.p();
  int tried = 0, reached = 1, said = 0;
  for (std::int64_t at = 1; reached; at += at <= dense ? step : at / 8, ++tried) {
    const int victim = tried % ranks;
    if (anew) job.drop();
    const rc_status status = job.run(rank == victim ? at : 0, failed);
    const std::string text = std::to_string(status) + " " + rc_last_error();
    reached = failed;
    MPI_Bcast(&reached, 1, MPI_INT, victim, MPI_COMM_WORLD);
    check(everywhere(text), s.name, at, "the same on every rank");
    check(everywhere(job.made() ? "made" : "none"), s.name, at, "a contact on every rank or none");
    check(status == RC_OK || (reached && status == RC_ERR_MEMORY), s.name, at, "status");
    said += status != RC_OK;
    if (status == RC_OK) check(job.p() == known, s.name, at, "pressures without that memory");
    if (tried % 4 == 0) {
      check(job.run(0, failed) == RC_OK, s.name, at, "the solve after it");
      check(job.p() == known, s.name, at, "its pressures");
    }
  }
  check(said > 0, s.name, 0, "failures that were reported");
  if (rank == 0) std::printf("%s, %s: %d allocations failed, %d failures\n", s.name, anew ? "anew" : "again", tried, said);
}

}  // namespace

int main(int argc, char** argv) {
  int worst = 0;
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  check(rc_mpi_exchange_create(MPI_COMM_WORLD, &exchange) == RC_OK, "all", 0, "exchange");
  constexpr std::int32_t free = RC_BOUNDARY_FREE, periodic = RC_BOUNDARY_PERIODIC, load = RC_CONTROL_LOAD;
  const scene dense[] = {{"dense", 64, 72, free, load, 0.05, 0, holes, "mixed", 0, 2, nullptr},
                         {"dense, periodic", 64, 64, periodic, RC_CONTROL_APPROACH, 0.04, 0, whole, "double", 0, 0, nullptr},
                         {"coarse grids", 300, 280, free, load, 0.4, 0, whole, "mixed", 0, 0, nullptr},
                         {"same", 20, 24, free, load, 0.05, 0, holes, "mixed", 0, 0, nullptr}};
  const scene sparse[] = {{"sparse", 520, 512, free, load, 0.01, 0, holes, "mixed", 0, 0, nullptr},
                          {"sparse, periodic", 520, 512, periodic, load, 0.01, 0, whole, "mixed", 0, 0, nullptr}};
  const bool quick = std::getenv("RC_TEST_QUICK") != nullptr;
  for (const scene& s : dense)
    for (const bool anew : {true, false}) every_allocation(s, anew, quick ? 400 : 500, quick ? 3 : 1);
  for (const scene& s : sparse) every_allocation(s, false, quick ? 200 : 400, quick ? 11 : 3);
  MPI_Allreduce(&failures, &worst, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  rc_mpi_exchange_destroy(&exchange);
  MPI_Finalize();
  return worst > 0;
}
