#include "random_problems.h"

#include <algorithm>
#include <cmath>

#include "support/naive.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

std::int32_t multiply(const double* x, double* y, std::int64_t n, void* user) {
  const Field& matrix = *static_cast<const Field*>(user);
  for (std::int64_t i = 0; i < n; ++i) {
    y[i] = 0;
    for (std::int64_t j = 0; j < n; ++j) y[i] += matrix[static_cast<std::size_t>(i * n + j)] * x[j];
  }
  return 0;
}

}  // namespace

double uniform(std::mt19937& generator) { return static_cast<double>(generator()) / 4294967296.0; }

double normal(std::mt19937& generator) {
  double sum = -6;
  for (int k = 0; k < 12; ++k) sum += uniform(generator);
  return sum;
}

Field normals(std::size_t n, std::mt19937& generator) {
  Field values(n);
  for (double& value : values) value = normal(generator);
  return values;
}

void make_random(unsigned seed, std::int64_t most, bool half_spaces_alone, RandomProblem& out) {
  std::mt19937 generator(seed + 1000003u);
  const auto pick = [&](auto... choices) {
    const std::string all[] = {choices...};
    return all[generator() % sizeof...(choices)];
  };
  const auto side = [&] { return 5 + static_cast<std::int64_t>(uniform(generator) * static_cast<double>(most - 4)); };
  Problem& problem = out.problem;
  rc_system& system = problem.system;
  const std::string kernel = pick("love", "love", "galerkin", "disc", "punch", "spectral", "spectral");
  system.nx = side();
  system.ny = side();
  system.modulus = 0.5 + 3 * uniform(generator);
  system.hx = system.hy = 0.3 + uniform(generator);
  problem.kernel = kernel;
  if (kernel == "spectral") system.boundary = RC_BOUNDARY_PERIODIC;
  if (kernel != "disc" && kernel != "punch" && uniform(generator) < 0.7) system.hy *= 0.4 + 1.6 * uniform(generator);
  problem.gap = rough_heights(system.nx, system.ny, seed);
  for (double& gap : problem.gap) gap = -0.5 * gap + 0.15 * uniform(generator);
  if (uniform(generator) < 0.35)
    for (std::size_t i = 0; i < problem.points(); ++i) problem.mask.push_back(uniform(generator) < 0.2 ? 0 : 1);
  const double lowest = problem.lowest_gap(), mean = sum(problem.gap) / static_cast<double>(problem.points());
  problem.target = lowest + (0.15 + 0.7 * uniform(generator)) * (mean - lowest);
  out.pair = {"auto", pick("auto", "fft", "dense")};
  if (out.pair.backend == "fft") out.pair.solver = pick("auto", "haar-cg");
  const std::string matrices = half_spaces_alone ? "" : pick("", "", "", "matrix", "product");
  if (!matrices.empty() && !problem.periodic()) {
    out.matrix = influence_matrix(problem);
    system.op = matrices == "matrix" ? RC_OPERATOR_DENSE : RC_OPERATOR_CALLBACK;
    system.dense = out.matrix.data();
    system.dense_ld = system.nx * system.ny;
    system.apply = multiply;
    system.user = &out.matrix;
    problem.kernel = "auto";
    out.pair = automatic;
  }
  out.name = std::to_string(seed) + " " + kernel + " " + matrices + " " + out.pair.name();
  if (uniform(generator) < 0.3) {
    system.hardness = (0.3 + 0.6 * uniform(generator)) * largest(solved(problem, out.pair).p);
    out.name += " hardness";
  }
  if (uniform(generator) < 0.5) {
    const rc_result found = solved(problem, out.pair).result;
    if (found.capped < found.contacts) problem = at_load(problem, found.load);  // else the load does not determine the approach
  }
  out.name += problem.control == RC_CONTROL_LOAD ? " load" : " approach";
}

}  // namespace pairs
