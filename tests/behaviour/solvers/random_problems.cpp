#include "random_problems.h"

#include <algorithm>
#include <cmath>

namespace pivoting {

namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  double uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double symmetric() { return 2 * uniform() - 1; }
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(bits_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 bits_;
};

double& at(RandomProblem& problem, std::int64_t i, std::int64_t j) {
  return problem.matrix[static_cast<std::size_t>(i * problem.n + j)];
}

// F F' + ridge I for n x rank factors.
template <class Value> void from_factors(RandomProblem& problem, std::int64_t rank, double ridge, Value value) {
  const std::int64_t n = problem.n;
  Field factor(static_cast<std::size_t>(n * rank));
  for (double& each : factor) each = value();
  for (std::int64_t i = 0; i < n; ++i)
    for (std::int64_t j = 0; j < n; ++j) {
      double& entry = at(problem, i, j);
      entry = i == j ? ridge : 0;
      for (std::int64_t k = 0; k < rank; ++k)
        entry += factor[static_cast<std::size_t>(i * rank + k)] * factor[static_cast<std::size_t>(j * rank + k)];
    }
}

// Off-diagonals that are not positive, rows that are a little more than balanced.
void make_m_matrix(RandomProblem& problem, Random& random) {
  for (std::int64_t i = 0; i < problem.n; ++i)
    for (std::int64_t j = 0; j < i; ++j) at(problem, i, j) = at(problem, j, i) = random.uniform() < 0.5 ? 0 : -random.uniform();
  for (std::int64_t i = 0; i < problem.n; ++i) {
    double sum = 0;
    for (std::int64_t j = 0; j < problem.n; ++j) sum += j == i ? 0 : std::abs(at(problem, i, j));
    at(problem, i, i) = sum + 0.01 + random.uniform();
  }
}

// Influence that falls with the distance of random points, as of asperities; a small diagonal makes it far from an inverse
// M-matrix.
void make_influence(RandomProblem& problem, Random& random) {
  Field x, y;
  for (std::int64_t i = 0; i < problem.n; ++i) {
    x.push_back(4 * random.uniform());
    y.push_back(4 * random.uniform());
  }
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j)
      problem.matrix[i * x.size() + j] = std::exp(-std::hypot(x[i] - x[j], y[i] - y[j])) + (i == j ? 0.01 : 0);
}

Field times(const RandomProblem& problem, const Field& p) {
  Field result;
  for (std::int64_t i = 0; i < problem.n; ++i) {
    double sum = 0;
    for (std::int64_t j = 0; j < problem.n; ++j)
      sum += problem.matrix[static_cast<std::size_t>(i * problem.n + j)] * p[static_cast<std::size_t>(j)];
    result.push_back(sum);
  }
  return result;
}

// Chooses p and w, both zero at every third point or so, and u to fit. Integers keep the ties exact.
void from_solution(RandomProblem& problem, Random& random, bool integers) {
  Field p(static_cast<std::size_t>(problem.n), 0.0), w = p;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::int64_t role = random.integer(0, 2);
    const double value = integers ? static_cast<double>(random.integer(1, 4)) : 0.05 + random.uniform();
    if (role == 0) p[i] = value;
    if (role == 1) w[i] = value;
  }
  problem.u = times(problem, p);
  for (std::size_t i = 0; i < p.size(); ++i) problem.u[i] -= w[i];
  problem.solution = p;
}

// Solves H_CC x = u_C by Cholesky's method; false where a pivot is not positive.
bool solve_on(const RandomProblem& problem, const std::vector<std::size_t>& set, Field& x) {
  const std::size_t m = set.size(), n = static_cast<std::size_t>(problem.n);
  Field l(m * m);
  x.assign(m, 0.0);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = problem.matrix[set[i] * n + set[j]];
      for (std::size_t k = 0; k < j; ++k) sum -= l[i * m + k] * l[j * m + k];
      if (i == j && !(sum > 0)) return false;
      l[i * m + j] = i == j ? std::sqrt(sum) : sum / l[j * m + j];
    }
    x[i] = problem.u[set[i]];
    for (std::size_t k = 0; k < i; ++k) x[i] -= l[i * m + k] * x[k];
    x[i] /= l[i * m + i];
  }
  for (std::size_t i = m; i-- > 0;) {
    for (std::size_t k = i + 1; k < m; ++k) x[i] -= l[k * m + i] * x[k];
    x[i] /= l[i * m + i];
  }
  return true;
}

}  // namespace

RandomProblem make_problem(std::uint64_t number) {
  Random random(number);
  RandomProblem problem;
  problem.n = random.integer(1, 40);
  problem.matrix.assign(static_cast<std::size_t>(problem.n * problem.n), 0.0);
  bool made_from_solution = random.uniform() < 0.5;
  switch (random.integer(0, 5)) {
    case 0:
      problem.kind = "factors";
      from_factors(problem, problem.n, 1e-3, [&] { return random.symmetric(); });
      break;
    case 1:
      problem.kind = "M-matrix";
      make_m_matrix(problem, random);
      break;
    case 2:
      problem.kind = "influence";
      make_influence(problem, random);
      break;
    case 3:
      problem.kind = "nearly singular";
      from_factors(problem, (problem.n + 1) / 2, 1e-8, [&] { return random.symmetric(); });
      made_from_solution = true;
      break;
    case 4:
      problem.kind = "integers";
      from_factors(problem, problem.n, 1, [&] { return static_cast<double>(random.integer(-2, 2)); });
      made_from_solution = true;
      break;
    default: {
      problem.kind = "scales";
      from_factors(problem, problem.n, 1e-2, [&] { return random.symmetric(); });
      for (std::int64_t k = 0; k < problem.n; ++k) {
        const double scale = std::pow(10.0, random.symmetric());
        for (std::int64_t j = 0; j < problem.n; ++j) {
          at(problem, k, j) *= scale;
          at(problem, j, k) *= scale;
        }
      }
      for (std::int64_t i = 0; i < problem.n; ++i)
        for (std::int64_t j = 0; j < i; ++j) at(problem, j, i) = at(problem, i, j);
    }
  }
  if (made_from_solution) {
    from_solution(problem, random, problem.kind == "integers");
  } else {
    for (std::int64_t i = 0; i < problem.n; ++i) problem.u.push_back(random.symmetric());
  }
  return problem;
}

std::optional<Field> solution_by_enumeration(const RandomProblem& problem) {
  const auto n = static_cast<std::size_t>(problem.n);
  if (n > 10) return std::nullopt;
  Field best;
  double least = INFINITY;
  for (std::uint32_t members = 0; members < (1u << n); ++members) {
    std::vector<std::size_t> set;
    for (std::size_t i = 0; i < n; ++i)
      if (members >> i & 1u) set.push_back(i);
    Field x;
    if (!solve_on(problem, set, x) || std::any_of(x.begin(), x.end(), [](double value) { return value < 0; })) continue;
    // The contact set has the least energy, -1/2 u'p, among the sets on which all pressures are positive.
    double energy = 0;
    for (std::size_t k = 0; k < set.size(); ++k) energy -= 0.5 * problem.u[set[k]] * x[k];
    if (energy >= least) continue;
    least = energy;
    best.assign(n, 0.0);
    for (std::size_t k = 0; k < set.size(); ++k) best[set[k]] = x[k];
  }
  return best;
}

Violation violation(const RandomProblem& problem, const Field& p) {
  const auto n = static_cast<std::size_t>(problem.n);
  double largest_p = 0, largest_u = 0;
  for (std::size_t i = 0; i < n; ++i) {
    largest_p = std::max(largest_p, p[i]);
    largest_u = std::max(largest_u, problem.u[i]);
  }
  Violation worst{0, 0, 0};
  for (std::size_t i = 0; i < n; ++i) {
    long double gap = -problem.u[i];
    for (std::size_t j = 0; j < n; ++j) gap += static_cast<long double>(problem.matrix[i * n + j]) * p[j];
    const double w = static_cast<double>(gap), scale_p = largest_p > 0 ? largest_p : 1, scale_u = largest_u > 0 ? largest_u : 1;
    worst.tension = std::max(worst.tension, -p[i] / scale_p);
    worst.overlap = std::max(worst.overlap, -w / scale_u);
    worst.complementarity = std::max(worst.complementarity, std::min(p[i] / scale_p, std::abs(w) / scale_u));
  }
  return worst;
}

}  // namespace pivoting
