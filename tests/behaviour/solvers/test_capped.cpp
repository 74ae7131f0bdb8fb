// haar-cg under a hardness: rough surfaces from few points at it to nearly all, in about as many products as without it.
#include <roughcontact/surface.h>

#include <algorithm>

#include "support/contact.h"
#include "support/registry.h"

namespace pairs {

namespace {

const Pair haar{"haar-cg", "fft"};
const Settings settings = {{RC_OPT_TOL, "1e-8"}};
constexpr std::int64_t side = 256;
constexpr double slope = 0.08, hardness = 0.1;  // rms; in units of the modulus
constexpr double most_excess = 1.65;            // products over those of the elastic contact, which needs no search for its load
const double mean_pressures[] = {0.01, 0.03, 0.05, 0.07, 0.09, 0.095, 0.0999};

Problem rough(std::int64_t nx, std::int64_t ny, std::int32_t boundary, double mean_pressure) {
  Problem problem;
  problem.system.nx = nx;
  problem.system.ny = ny;
  problem.system.boundary = boundary;
  problem.control = RC_CONTROL_LOAD;
  problem.target = mean_pressure * static_cast<double>(nx * ny);
  problem.gap.resize(problem.points());
  rc_surface_spectral_spec spec = RC_SURFACE_SPECTRAL_SPEC_INIT;
  spec.seed = 5;
  spec.nx = nx;
  spec.ny = ny;
  spec.q_rolloff = 0.2;
  spec.q_high = 1.5;
  spec.rms_height = 0;
  spec.rms_slope = slope;
  check(rc_surface_spectral(&spec, problem.gap.data()) == RC_OK, rc_surface_last_error());
  const double highest = *std::max_element(problem.gap.begin(), problem.gap.end());
  for (double& value : problem.gap) value = highest - value;
  return problem;
}

Problem capped(Problem problem, double most) {
  problem.system.hardness = most;
  return problem;
}

void products_are_those_of_elastic_contacts() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const double mean : mean_pressures) {
      const Problem problem = rough(side, side, boundary, mean);
      const Answer elastic = solved(problem, haar, settings), plastic = solved(capped(problem, hardness), haar, settings);
      const std::string scene = std::string(problem.periodic() ? "periodic" : "free") + ", mean pressure " + text(mean);
      report(scene + ": " + std::to_string(plastic.result.products) + " products, " + std::to_string(elastic.result.products) +
             " without a hardness, " + std::to_string(plastic.result.capped) + " points at it");
      check(plastic.result.capped > 0, scene + ": no point is at the hardness");
      check(static_cast<double>(plastic.result.products) <= most_excess * static_cast<double>(elastic.result.products),
            scene + ": too many products");
      check(std::string(plastic.result.note).empty() || std::string(plastic.result.note).find("haar-cg") == std::string::npos,
            scene + ": " + plastic.result.note);
    }
}

// Polonsky & Keer's method takes its steps on the points below the hardness alone.
void half_of_the_contact_at_the_hardness_by_polonsky_and_keer() {
  const Pair keer{"polonsky-keer", "fft"};
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const bool by_load : {true, false}) {
      Problem problem = rough(64, 67, boundary, 0.075);
      const double elastic = static_cast<double>(solved(problem, keer, settings).result.products);
      problem = capped(problem, hardness);
      const Answer expected = solved(problem, haar, settings);
      if (!by_load) {
        problem.target = expected.result.approach;
        problem.control = RC_CONTROL_APPROACH;
      }
      const Answer answer = solved(problem, keer, settings);
      const double share = static_cast<double>(answer.result.capped) / static_cast<double>(answer.result.contacts);
      report(std::string(problem.periodic() ? "periodic" : "free") + (by_load ? ", load" : ", approach") + ": " + text(share) +
             " of the contact at the hardness, " + std::to_string(answer.result.products) + " products, " + text(elastic) +
             " without a hardness");
      check(share > 0.35 && share < 0.65, "half of the contact is at the hardness");
      check_near(answer.p, expected.p, 1e-5 * hardness, "p");
      check(static_cast<double>(answer.result.products) <= 2 * elastic, "too many products");
    }
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  return run_group("solvers.capped",
                   RC_TESTS(products_are_those_of_elastic_contacts, half_of_the_contact_at_the_hardness_by_polonsky_and_keer),
                   argc, argv);
}
