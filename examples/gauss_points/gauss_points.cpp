// gauss_points [THREADS]: eight masses on a row of springs fall onto eight different rough patches and bounce. Every second patch
// has a hardness. Elastic patches always take their contact laws; the others take theirs while they are loaded for the first
// time, and the solver when they bounce back.
#include <roughcontact/surface.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "chain.h"

namespace {

constexpr int points = 8, side = 64;
constexpr double pitch = 1e-6, modulus = 70e9, hardness = 1e9;                   // cells of 1 um, Pa
constexpr double least_pressure = 1e6, most_pressure = 200e6, tolerance = 1e-2;  // of the laws

ContactLaw rough_patch(std::uint64_t seed) {
  rc_surface_spectral_spec spec = RC_SURFACE_SPECTRAL_SPEC_INIT;
  spec.seed = seed;
  spec.nx = spec.ny = side;
  spec.hx = spec.hy = pitch;
  spec.rms_height = 0.2e-6;
  std::vector<double> heights(side * side);
  if (rc_surface_spectral(&spec, heights.data()) != RC_OK) throw ContactLawError(rc_surface_last_error());

  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = side;
  system.hx = system.hy = pitch;
  system.modulus = modulus;
  if (seed % 2 == 0) system.hardness = hardness;
  ContactLaw law(system, heights);
  law.subtract_bulk(ContactLaw::square_stiffness(modulus, side * pitch));
  law.tabulate(least_pressure, most_pressure, tolerance);
  return law;
}

}  // namespace

int main(int count, char** arguments) {
  const int threads = count > 1 ? std::atoi(arguments[1]) : 1;
  try {
    std::vector<ContactLaw> laws;
    for (std::uint64_t seed = 1; seed <= points; ++seed) laws.push_back(rough_patch(seed));
    Chain chain;
    chain.mass = 1e-6;   // kg
    chain.spring = 1e5;  // N/m
    chain.push = 0.1;    // N
    chain.position.assign(points, -0.05e-6);
    chain.velocity.assign(points, 0.05);  // m/s

    std::puts("time [us]  Newton   contact force [N]   mean displacement [um]  points by law");
    for (const ChainStep& step : run(chain, laws, 0.5e-6, 24, threads)) {
      double mean = 0;
      for (const double u : step.position) mean += u / points;
      std::printf("%9.1f  %6d   %17.6f   %22.6f  %13d\n", step.time * 1e6, step.newton_iterations, step.contact_force, mean * 1e6,
                  step.tabulated);
    }
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 1;
  }
  return 0;
}
