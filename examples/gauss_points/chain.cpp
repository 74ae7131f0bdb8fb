#include "chain.h"

#include <algorithm>
#include <cmath>

namespace {

// Solves (diagonal, with -spring beside it) x = b; every mass but the ends has two neighbours (Thomas).
std::vector<double> solve_tridiagonal(std::vector<double> diagonal, double spring, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = -spring / diagonal[i - 1];
    diagonal[i] += factor * spring;
    b[i] -= factor * b[i - 1];
  }
  for (std::size_t i = n; i-- > 0;) b[i] = (b[i] + (i + 1 < n ? spring * b[i + 1] : 0)) / diagonal[i];
  return b;
}

// Forces of the springs on the masses.
std::vector<double> spring_forces(const Chain& chain, const std::vector<double>& position) {
  std::vector<double> force(position.size(), 0.0);
  for (std::size_t i = 0; i + 1 < position.size(); ++i) {
    const double pull = chain.spring * (position[i + 1] - position[i]);
    force[i] += pull;
    force[i + 1] -= pull;
  }
  return force;
}

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

}  // namespace

std::vector<ChainStep> run(Chain chain, std::vector<ContactLaw>& laws, double dt, int steps, int threads) {
  const std::size_t n = laws.size();
  const double inertia = 4 * chain.mass / (dt * dt);
  const auto acceleration = [&](const std::vector<double>& position, const std::vector<ContactLaw::Answer>& contact) {
    std::vector<double> a = spring_forces(chain, position);
    for (std::size_t i = 0; i < n; ++i) a[i] = (a[i] + chain.push - contact[i].force) / chain.mass;
    return a;
  };

  std::vector<ContactLaw::Answer> contact = evaluate_all(laws, chain.position, threads);
  std::vector<double> a = acceleration(chain.position, contact);
  std::vector<ChainStep> history;
  for (int step = 1; step <= steps; ++step) {
    ChainStep now;
    now.time = step * dt;
    std::vector<double> u = chain.position;
    for (;;) {
      contact = evaluate_all(laws, u, threads);
      std::vector<double> unbalanced = spring_forces(chain, u), diagonal(n);
      for (std::size_t i = 0; i < n; ++i) {
        const double predicted = chain.position[i] + dt * chain.velocity[i] + 0.25 * dt * dt * a[i];
        unbalanced[i] += chain.push - contact[i].force - inertia * (u[i] - predicted);
        const double neighbours = (i > 0) + (i + 1 < n);
        diagonal[i] = inertia + neighbours * chain.spring + contact[i].tangent;
      }
      now.residual = largest(unbalanced);
      if (now.residual <= 1e-9 * (std::abs(chain.push) + inertia * largest(u))) break;
      if (++now.newton_iterations > 30) throw ContactLawError("run: Newton's method does not converge; give a smaller dt");
      const std::vector<double> change = solve_tridiagonal(diagonal, chain.spring, unbalanced);
      for (std::size_t i = 0; i < n; ++i) u[i] += change[i];
    }

    const std::vector<double> before = a;
    a = acceleration(u, contact);
    for (std::size_t i = 0; i < n; ++i) chain.velocity[i] += 0.5 * dt * (before[i] + a[i]);
    chain.position = u;
    for (ContactLaw& law : laws) law.commit();
    for (const ContactLaw::Answer& answer : contact) {
      now.contact_force += answer.force;
      now.tabulated += answer.tabulated;
    }
    now.position = u;
    history.push_back(now);
  }
  return history;
}
