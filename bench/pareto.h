// Speed against accuracy: every method that makes sense, at a sequence of tolerances, and kernels and grids, against the truth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pareto_scene.h"

namespace bench {

struct ParetoRequest {
  std::vector<std::string> scenes = pareto_scene_names();
  std::vector<double> contacts{0.1, 0.01, 0.4, 0.9};  // shares of the cells, in the order of measuring
  std::vector<int> digits{2, 3, 4, 5, 6, 8, 10, 12};  // tolerances 10^-digits of methods
  std::vector<int> grid_digits{1, 2, 3, 4, 6, 8};     // and of the coarser and finer grids
  std::int64_t n = 256;                               // points a side of surfaces that are not measured, a power of two
  std::string surfaces;                               // folder with measured surfaces; empty: none
  std::int64_t threads = 1;
  double budget = 0.1;                // seconds for repeats of a solve
  double solve_limit = 2;             // seconds for one solve
  double method_limit = 4;            // seconds after which a method goes on to no tighter tolerance
  double time_limit = 0;              // seconds after which nothing begins; 0: none
  std::int64_t most_factored = 4000;  // candidates up to which factoring backends run
  std::string file;                   // JSON that is read at first and written after every method
  std::string csv;                    // the same as a table; empty: none
  std::string export_folder;          // where gaps and certified pressures go that other codes can be compared on; empty: nowhere
};

// Measures what this library has not measured before, each solve in a process of its own. Prints progress on stderr, counts on
// stdout.
void run_pareto(const ParetoRequest& request);

}  // namespace bench
