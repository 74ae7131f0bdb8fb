#include "sparse.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace sparse_contact {

using pairs::check;

Field Sparse::everywhere() const {
  Field all(static_cast<std::size_t>(result.points), 0.0);
  for (std::size_t k = 0; k < p.size(); ++k) all[static_cast<std::size_t>(index[k])] = p[k];
  return all;
}

SparseContact::SparseContact(const Problem& problem, const Settings& settings, const pairs::Pair& pair) {
  Settings all{{RC_OPT_TOL, "1e-8"}};
  all.insert(all.end(), settings.begin(), settings.end());
  rc_contact* made = nullptr;
  check(rc_contact_create(&problem.system, pairs::make_options(pair, problem.kernel, all).get(), &made) == RC_OK,
        rc_last_error());
  contact_.reset(made);
}

Sparse SparseContact::solve(const Problem& problem, bool borrow) const {
  Sparse answer;
  answer.result = RC_RESULT_INIT;
  rc_step step = problem.step();
  step.borrow = borrow;
  answer.status = rc_contact_solve(contact_.get(), &step, &answer.result);
  answer.message = rc_last_error();
  if (answer.status != RC_OK) return answer;
  std::int64_t n = 0;
  check(rc_contact_points(contact_.get(), 0, {}, {}, &n) == RC_OK, rc_last_error());
  pairs::check_equal(n, answer.result.contacts, "contact points");
  answer.index.resize(static_cast<std::size_t>(n));
  answer.p.resize(answer.index.size());
  check(rc_contact_points(contact_.get(), n, RC_OUT(answer.index.data()), RC_OUT(answer.p.data()), &n) == RC_OK, rc_last_error());
  check(std::is_sorted(answer.index.begin(), answer.index.end()), "contact points ascend");
  return answer;
}

Sparse solved(const Problem& problem, const char* backend, const Settings& settings) {
  const Sparse answer = SparseContact(problem, settings).solve(problem);
  check(answer.status == RC_OK, answer.message);
  check(std::string(answer.result.backend) == backend, std::string("backend ") + answer.result.backend);
  return answer;
}

Problem self_affine(std::int64_t nx, std::int64_t ny, unsigned seed, double depth, std::int64_t first) {
  Problem problem;
  problem.system.nx = nx;
  problem.system.ny = ny;
  problem.gap.assign(problem.points(), 0.0);
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const std::int64_t n = std::max(nx, ny);
  for (std::int64_t wave = first; wave <= n / 4; wave += std::max<std::int64_t>(1, wave / 5)) {
    for (int each = 0; each < 4; ++each) {
      const double turn = 2 * std::numbers::pi * uniform(), shift = 2 * std::numbers::pi * uniform();
      const double k = 2 * std::numbers::pi * static_cast<double>(wave) / static_cast<double>(n);
      const double kx = k * std::cos(turn), ky = k * std::sin(turn), height = std::pow(static_cast<double>(wave), -0.8);
      for (std::int64_t y = 0; y < ny; ++y) {
        const double row = ky * static_cast<double>(y) + shift;
        for (std::int64_t x = 0; x < nx; ++x)
          problem.gap[static_cast<std::size_t>(y * nx + x)] += height * std::cos(kx * static_cast<double>(x) + row);
      }
    }
  }
  double sum = 0, square = 0;
  for (const double gap : problem.gap) {
    sum += gap;
    square += gap * gap;
  }
  const double mean = sum / static_cast<double>(problem.points());
  const double deviation = std::sqrt(square / static_cast<double>(problem.points()) - mean * mean);
  for (double& gap : problem.gap) gap *= 10 / deviation;  // some cells high, as seen from a cell of side 1
  problem.target = problem.lowest_gap() + 10 * depth;
  return problem;
}

}  // namespace sparse_contact
