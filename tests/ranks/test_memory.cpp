// A rank that gets no memory in a solve of sparse contact: whichever allocation it is, every rank has the same status and
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

// An allocation of one rank fails: every `step`-th of the first `dense`, then ever fewer, each time on another rank.
void every_allocation(const scene& s, std::int64_t dense, std::int64_t step) {
  const rc_system system = system_of(&s);
  std::int64_t first = 0, count = 0;
  rc_mpi_contact* contact = nullptr;
  check(rc_mpi_rows(MPI_COMM_WORLD, &system, &first, &count) == RC_OK, s.name, 0, "rows");
  const auto n = static_cast<std::size_t>(s.nx * count);
  std::vector<double> gap(n + 1), p(n + 1);
  std::vector<std::uint8_t> mask(n + 1);
  fill_rows(&s, first, count, gap.data(), mask.data());
  rc_step one = RC_STEP_INIT;
  one.control = s.control;
  one.target = target_of(&s);
  one.undeformed_gap = gap.data();
  one.warm_start = 0;
  if (s.mask != whole) one.mask = mask.data();
  check(rc_mpi_contact_create(MPI_COMM_WORLD, &system, nullptr, &contact) == RC_OK, s.name, 0, "create");
  if (!contact) MPI_Abort(MPI_COMM_WORLD, 1);
  const auto solved = [&](std::int64_t fails_at, bool& failed) {
    rc_step given = one;
    rc_result result = RC_RESULT_INIT;
    result.p = p.data();
    support::fail_allocation(fails_at);
    const rc_status status = rc_mpi_contact_solve(contact, &given, &result);
    failed = support::allocation_failed();
    support::fail_allocation(0);
    return status;
  };

  bool failed = false;
  check(solved(0, failed) == RC_OK, s.name, 0, "solve");
  const std::vector<double> known = p;
  int tried = 0, reached = 1, told = 0;
  for (std::int64_t at = 1; reached; at += at <= dense ? step : at / 8, ++tried) {
    const int victim = tried % ranks;
    const rc_status status = solved(rank == victim ? at : 0, failed);
    const std::string text = std::to_string(status) + " " + rc_last_error();
    reached = failed;
    MPI_Bcast(&reached, 1, MPI_INT, victim, MPI_COMM_WORLD);
    check(everywhere(text), s.name, at, "the same on every rank");
    check(status == RC_OK || (reached && status == RC_ERR_MEMORY), s.name, at, "status");
    told += status != RC_OK;
    if (status == RC_OK) check(p == known, s.name, at, "pressures without that memory");
    if (tried % 4 == 0) {
      check(solved(0, failed) == RC_OK, s.name, at, "the solve after it");
      check(p == known, s.name, at, "its pressures");
    }
  }
  rc_mpi_contact_destroy(contact);
  check(told > 0, s.name, 0, "failures that were told");
  if (rank == 0) std::printf("%s: %d allocations failed, %d failures\n", s.name, tried, told);
}

}  // namespace

int main(int argc, char** argv) {
  int worst = 0;
  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const scene all[] = {
      {"sparse", 520, 512, RC_BOUNDARY_FREE, RC_CONTROL_LOAD, 0.01, 0, holes, "mixed", 0, 0, nullptr},
      {"sparse, periodic", 520, 512, RC_BOUNDARY_PERIODIC, RC_CONTROL_LOAD, 0.01, 0, whole, "mixed", 0, 0, nullptr}};
  const bool quick = std::getenv("RC_TEST_QUICK") != nullptr;
  for (const scene& s : all) every_allocation(s, quick ? 200 : 1000, quick ? 11 : 3);
  MPI_Allreduce(&failures, &worst, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return worst > 0;
}
