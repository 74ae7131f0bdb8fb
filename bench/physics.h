// Area, mean gap, stiffness, patches and pressures of rough surfaces against load, beside the theories of rough contact.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

// Pressures are mean pressures over E* times the rms slope of the surface.
struct PhysicsRequest {
  std::vector<std::uint64_t> seeds{1, 2, 3, 4};
  double hurst = 0.8, roll_off = 4, cut_off = 64;  // waves a side
  std::int64_t points = 1024;                      // a side, of the curves over all pressures
  std::vector<double> pressures{0.005, 0.01, 0.02, 0.04, 0.08, 0.16, 0.3, 0.5, 0.75, 1, 1.5};
  std::vector<double> shown{0.01, 0.04, 0.16};                  // of them, those with distributions of patches and pressures
  std::vector<std::int64_t> sizes{256, 512, 1024, 2048, 4096};  // grids of the same surfaces
  std::vector<double> mesh_pressures{0.02, 0.16};
  std::int64_t mesh_seeds = 2;  // surfaces on all grids, the first ones
  double tol = 1e-8;
  std::int64_t threads = 1;
  std::string file;  // JSON that is read at first and written after every solve
};

// Solves that the file has from the same library are not repeated. Prints progress on stderr and tables on stdout.
void run_physics(const PhysicsRequest& request);

}  // namespace bench
