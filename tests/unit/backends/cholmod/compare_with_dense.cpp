// compare_with_dense [SIDE]: processor time of nnls with the backends dense and cholmod over a loading sequence on a rough
// surface of SIDE x SIDE points, and of polonsky-keer. Figures depend on the BLAS that CHOLMOD runs on.
#include <roughcontact/roughcontact.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "support/unit_system.h"

namespace {

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double loading_sequence(const char* solver, const char* backend, std::int64_t side, std::int64_t& contacts) {
  std::vector<double> gap(static_cast<std::size_t>(side * side));
  for (std::int64_t i = 0; i < side * side; ++i) {
    const double x = static_cast<double>(i % side), y = static_cast<double>(i / side);
    gap[static_cast<std::size_t>(i)] =
        2.0 + std::cos(0.21 * x + 0.17 * y) + std::cos(0.4 * x - 0.33 * y) + 0.3 * std::cos(1.1 * y);
  }
  rc_system system = support::unit_system();
  system.nx = system.ny = side;
  rc_options* options = nullptr;
  rc_contact* contact = nullptr;
  if (rc_options_create(nullptr, &options) != RC_OK || rc_options_set_text(options, RC_OPT_SOLVER, solver) != RC_OK ||
      rc_options_set_text(options, RC_OPT_BACKEND, backend) != RC_OK || rc_contact_create(&system, options, &contact) != RC_OK) {
    std::fprintf(stderr, "%s\n", rc_last_error());
    std::exit(1);
  }
  const double begin = processor_seconds();
  for (int k = 1; k <= 8; ++k) {
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_APPROACH;
    step.undeformed_gap.data = gap.data();
    step.target = 0.7 * k;
    rc_result result = RC_RESULT_INIT;
    if (rc_contact_solve(contact, &step, &result) != RC_OK) {
      std::fprintf(stderr, "%s\n", rc_last_error());
      std::exit(1);
    }
    contacts = result.contacts;
  }
  const double seconds = processor_seconds() - begin;
  rc_contact_destroy(contact);
  rc_options_destroy(options);
  return seconds;
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t side = argc > 1 ? std::atoll(argv[1]) : 50;
  for (const char* solver : {"nnls", "polonsky-keer"}) {
    std::int64_t contacts = 0;
    const double dense = loading_sequence(solver, "dense", side, contacts);
    const double cholmod = loading_sequence(solver, "cholmod", side, contacts);
    std::printf("%s, %lld points, %lld contacts at the end: dense %.2f s, cholmod %.2f s, ratio %.2f\n", solver,
                static_cast<long long>(side * side), static_cast<long long>(contacts), dense, cholmod, cholmod / dense);
  }
}
