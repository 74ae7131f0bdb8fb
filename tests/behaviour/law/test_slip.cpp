// Slip from a law: against closed forms and its own rules. Its bounds are a property of scenes, what is refused is in the table
// of errors.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "patches.h"

namespace {

using namespace laws;
using pairs::check;
using pairs::check_equal;
using pairs::text;
using State = rc_law_slip_state;

double ratio_of(double nu) { return (2 - nu) / (2 - 2 * nu); }

State rest(double mu, double nu) {
  State state = RC_LAW_SLIP_STATE_INIT;
  state.mu = mu, state.nu = nu;
  return state;
}

State stepped(const rc_law* law, const State& before, double x, double along, double across = 0) {
  const double slip[2] = {along, across};
  State after = RC_LAW_SLIP_STATE_INIT;
  check(rc_law_slip(law, &before, x, slip, &after) >= 0, rc_last_error());
  return after;
}

// Pressed on first, then slipped.
State slipped(const rc_law* law, double mu, double nu, double x, double slip) {
  return stepped(law, stepped(law, rest(mu, nu), x, 0), x, slip);
}

double pressure(const rc_law* law, double x) { return evaluate(law, std::max(0.0, x)).p; }

double random(std::mt19937& generator) { return static_cast<double>(generator()) / 4294967296.0; }

void shear_and_stiffness_follow_from_the_law() {
  const rc_law* const law = usual_law();
  const double most = describe(law).x_upper;
  std::mt19937 generator(5);
  for (int i = 0; i < 1000; ++i) {
    const double mu = 2 * random(generator), nu = random(generator) / 2, x = most * random(generator);
    const double unit = mu * ratio_of(nu), slip = 1.2 * unit * x * random(generator), left = x - slip / unit;
    const State state = slipped(law, mu, nu, x, slip);
    const double shear = mu * (pressure(law, x) - pressure(law, left));
    check(std::abs(state.shear[0] - shear) <= 1e-12 * mu * state.p && state.shear[1] == 0, "shear at " + text(slip));
    check(state.p == pressure(law, x) && state.slope == evaluate(law, x).slope, "pressure");
    const double stiffness = left > 0 ? evaluate(law, left).slope / ratio_of(nu) : 0;
    check(std::abs(state.shear_by_slip[0] - stiffness) <= 1e-6 * state.slope, "stiffness at " + text(slip));
    const State back = slipped(law, mu, nu, x, -slip);
    check(back.shear[0] == -state.shear[0] && back.dissipated == state.dissipated, "the other direction");
  }
  check_equal(slipped(law, 0, 0.3, most, 1).shear[0] == 0, true, "no friction, no shear");
}

// A sphere on a fine grid: Cattaneo (1938), Mindlin (1949), Mindlin and Deresiewicz (1953).
void a_sphere_slips_as_mindlin_says() {
  const std::int64_t n = pairs::quick() ? 64 : 192;
  Patch sphere = usual_patch(16);
  pairs::Problem& problem = sphere.problem;
  problem.system.boundary = RC_BOUNDARY_FREE;
  problem.system.nx = problem.system.ny = n;
  problem.gap.clear();
  const double side = static_cast<double>(n), radius = 4 * side;
  for (std::int64_t i = 0; i < n * n; ++i)
    problem.gap.push_back(
        (std::pow(static_cast<double>(i % n) + 0.5 - side / 2, 2) + std::pow(static_cast<double>(i / n) + 0.5 - side / 2, 2)) /
        (2 * radius));
  sphere.spec.bulk = RC_LAW_BULK_NONE;
  const double reach = 0.45 * side, hertz = 4.0 / 3 * std::pow(reach, 3) / radius / (side * side);
  sphere.spec.p_upper = hertz;
  sphere.spec.p_lower = hertz / 100;
  sphere.spec.tolerance = 1e-4;
  const LawHandle law = made(sphere);
  const double mu = 0.4, x = 0.9 * describe(law.get()).x_upper, coarse = pairs::quick() ? 20 : 1;
  for (const auto& [nu, known] : {std::pair{0.0, 1.0}, {0.3, 1.2143}, {0.5, 1.5}}) {
    const State pressed = slipped(law.get(), mu, nu, x, 0);
    check(std::abs(pressed.slope / pressed.shear_by_slip[0] - known) < 1e-4, "stiffness ratio at nu " + text(nu));
    const double all = mu * ratio_of(nu) * x, limit = mu * pressed.p;
    for (const double share : {0.1, 0.3, 0.6, 0.9}) {
      const State state = stepped(law.get(), pressed, x, share * all);
      const double shear = 1 - std::pow(1 - share, 1.5);
      check(std::abs(state.shear[0] / (limit * shear) - 1) < 2e-4 * coarse, "shear at " + text(share));
      const double stick = std::sqrt(evaluate(law.get(), (1 - share) * x).area_fraction / evaluate(law.get(), x).area_fraction);
      check(std::abs(stick / std::cbrt(1 - state.shear[0] / limit) - 1) < 3e-3 * coarse, "stick radius at " + text(share));
      State loop = stepped(law.get(), stepped(law.get(), state, x, -2 * share * all), x, 2 * share * all);
      // Johnson, Contact Mechanics, eq. 7.57, in terms of the largest slip
      const double q = shear, u = 1 - q;
      const double cycle = limit * all * 24.0 / 5 * (1 - std::pow(u, 5.0 / 3) - 5 * q / 6 * (1 + std::pow(u, 2.0 / 3)));
      const double area = loop.dissipated - state.dissipated;
      check(std::abs(area / cycle - 1) < (share < 0.2 ? 2e-3 : 1e-3) * coarse,
            "loop of " + text(share) + ": " + text(area / cycle));
      check(std::abs(loop.shear[0] - state.shear[0]) <= 1e-12 * limit, "the loop closes");
    }
  }
}

// The area of a loop is its dissipation, and Masing's rule gives its branches, however a host steps through it.
void loops_obey_masing_and_small_ones_are_forgotten() {
  const rc_law* const law = usual_law();
  const double x = 0.8 * describe(law).x_upper, mu = 0.3, nu = 0.3, all = mu * ratio_of(nu) * x, reach = 0.7 * all;
  const auto first = [&](double slip) { return slipped(law, mu, nu, x, slip).shear[0]; };
  const State turned = slipped(law, mu, nu, x, reach);
  State state = turned;
  double area = 0;
  constexpr int steps = 400;
  for (int i = 1; i <= 2 * steps; ++i) {
    const State before = state;
    const double step = (i <= steps ? -2 : 2) * reach / steps, gone = 2 * reach * (i <= steps ? i : i - steps) / steps;
    state = stepped(law, state, x, step);
    area += step * (before.shear[0] + state.shear[0]) / 2;
    const double masing = i <= steps ? turned.shear[0] - 2 * first(gone / 2) : -turned.shear[0] + 2 * first(gone / 2);
    check(std::abs(state.shear[0] - masing) < 1e-10 * mu * state.p, "branch at " + text(gone));
    if (i % 40 == 0) {  // a small loop within
      const State inner = stepped(law, stepped(law, state, x, -step * 7), x, step * 7);
      check(std::abs(inner.shear[0] - state.shear[0]) < 1e-12 * mu * state.p, "a small loop changes the large one");
      state.shear[0] = inner.shear[0];
    }
  }
  const State leaps = stepped(law, stepped(law, turned, x, -2 * reach), x, 2 * reach);
  const double cycle = state.dissipated - turned.dissipated;
  check(std::abs((leaps.dissipated - turned.dissipated) / cycle - 1) < 1e-9, "dissipation depends on the steps");
  check(std::abs(area / cycle - 1) < 1e-4, "area over dissipation " + text(area / cycle));
  check(leaps.joined == 0 && std::abs(leaps.shear[0] - turned.shear[0]) < 1e-12 * mu * turned.p, "the end of the loop");
}

// Mindlin and Deresiewicz: loading with dq < mu dp does not slip, and its shear stays proportional to the pressure.
void what_is_pressed_on_without_slip_keeps_its_shear() {
  const rc_law* const law = usual_law();
  const double x = 0.6 * describe(law).x_upper, mu = 0.5, nu = 0.2, unit = mu * ratio_of(nu);
  for (const double share : {0.3, 0.99}) {
    State small = rest(mu, nu);
    for (int i = 1; i <= 50; ++i) small = stepped(law, small, x * i / 50, share * unit * x / 50, 0);
    const State large = stepped(law, rest(mu, nu), x, share * unit * x);
    check(std::abs(large.shear[0] - share * mu * large.p) < 1e-12 * large.p, "shear over pressure");
    check(std::abs(small.shear[0] - large.shear[0]) < 1e-10 * large.p && small.joined < 1e-12 * large.p, "small steps");
    check(large.dissipated == 0, "it dissipates");
    check(std::abs(large.shear_by_slip[0] - large.p / x / ratio_of(nu)) < 1e-9 * large.slope, "stiffness of the step");
    const State more = stepped(law, large, 1.2 * x, 0);
    check(std::abs(more.shear[0] - large.shear[0]) < 1e-12 * more.p, "pressed on without slip");
  }
  // Lifted at constant slip, less shear is held, never more than mu p, and nothing after contact is lost.
  State state = slipped(law, mu, nu, x, 0.5 * unit * x);
  for (int i = 9; i >= 0; --i) {
    state = stepped(law, state, 0.1 * i * x, 0);
    check(state.shear[0] >= 0 && state.shear[0] <= mu * state.p * (1 + 1e-12), "lifted");
  }
  state = stepped(law, state, -x, 5 * unit * x);
  check(state.shear[0] == 0 && state.p == 0, "open");
  // Half of a step from -x to x is in contact.
  const State touched = stepped(law, state, x, 0.2 * unit * x), half = stepped(law, rest(mu, nu), x, 0.1 * unit * x);
  check(std::abs(touched.shear[0] - half.shear[0]) < 1e-12 * half.p, "slip before first touch does not count");
}

// In two directions, with the overclosure changing: against differences. Shear is at most mu p, dissipation never falls.
void the_tangent_is_the_derivative_of_the_step() {
  const rc_law* const law = usual_law();
  const double unit = describe(law).x_upper / 3, mu = 0.4, nu = 0.25;
  std::mt19937 generator(8);
  const auto normal = [&] { return random(generator) + random(generator) + random(generator) - 1.5; };
  int compared = 0;
  for (int history = 0; history < 100; ++history) {
    State state = rest(mu, nu);
    double x = unit;
    for (int i = 0; i < 20; ++i) {
      const State before = state;
      const double next = random(generator) < 0.6 ? std::max(-unit / 10, x + unit * normal()) : x;
      const double slip[2] = {0.3 * unit * normal(), random(generator) < 0.5 ? 0.0 : 0.3 * unit * normal()};
      state = stepped(law, before, next, slip[0], slip[1]);
      check(std::hypot(state.shear[0], state.shear[1]) <= mu * state.p * (1 + 1e-12), "more than friction");
      check(state.dissipated >= before.dissipated, "dissipation falls");
      const double h = 1e-7 * unit;
      if (next > unit / 20 && std::abs(next - x) > 10 * h && std::hypot(slip[0], slip[1]) > 100 * h) {
        for (int by = 0; by < 3; ++by) {
          const auto moved = [&](double sign) {
            return stepped(law, before, next + (by == 2 ? sign * h : 0), slip[0] + (by == 0 ? sign * h : 0),
                           slip[1] + (by == 1 ? sign * h : 0));
          };
          const State more = moved(1), less = moved(-1);
          for (int c = 0; c < 2; ++c) {
            const double difference = (more.shear[c] - less.shear[c]) / (2 * h);
            const double said = by == 2 ? state.shear_by_x[c] : state.shear_by_slip[2 * c + by];
            compared += std::abs(said - difference) < 1e-3 * state.slope;
            check(std::abs(said - difference) < 0.05 * state.slope, "tangent " + text(said) + ", " + text(difference));
          }
        }
      }
      x = next;
    }
  }
  check(compared > 5000, "only " + std::to_string(compared) + " derivatives are as the tangent says");
}

// Ever smaller reversals, more than there are layers.
void joined_layers_change_the_shear_by_what_is_said() {
  const rc_law* const law = usual_law();
  const double x = 0.8 * describe(law).x_upper, mu = 0.3, nu = 0.3, all = mu * ratio_of(nu) * x;
  double exact = slipped(law, mu, nu, x, 0.9 * all).shear[0], sign = -1;
  State state = slipped(law, mu, nu, x, 0.9 * all);
  for (int i = 0; i < 30; ++i, sign = -sign) {
    const double gone = all * 1.7 * std::pow(0.93, i);
    state = stepped(law, state, x, sign * gone);
    exact += sign * 2 * slipped(law, mu, nu, x, gone / 2).shear[0];
    check(std::abs(state.shear[0] - exact) <= state.joined + 1e-10 * mu * state.p, "off by more than said");
  }
  check(state.joined > 0 && state.joined < 0.03 * mu * state.p, "joined " + text(state.joined / (mu * state.p)));
  pairs::report("off by " + text(std::abs(state.shear[0] - exact) / (mu * state.p)) + " of mu p, at most " +
                text(state.joined / (mu * state.p)));
  double lower[2], upper[2];
  check_equal(rc_law_slip_bounds(law, &state, lower, upper), RC_UNCERTIFIED, "bounds of joined layers");
}

void a_state_is_copied_and_stepped_in_place() {
  const rc_law* const law = usual_law();
  const double x = describe(law).x_upper / 2;
  State state = slipped(law, 0.3, 0.3, x, 0.01 * x);
  const State kept = state, after = stepped(law, state, 0.9 * x, -0.02 * x, 0.03 * x);
  check(std::memcmp(&state, &kept, sizeof state) == 0, "the state before a step changed");
  const double slip[2] = {-0.02 * x, 0.03 * x};
  check_equal(rc_law_slip(law, &state, 0.9 * x, slip, &state), RC_OK, "in place");
  check(std::memcmp(state.shear, after.shear, sizeof state.shear) == 0 && state.dissipated == after.dissipated,
        "other bits in place");
  const State same = stepped(law, after, 0.9 * x, 0);
  check(std::abs(same.shear[0] - after.shear[0]) < 1e-14 * after.p, "a step without change");
  check_equal(rc_law_slip(law, &state, 3 * describe(law).x_upper, slip, &state), RC_OUTSIDE, "beyond the last node");
}

}  // namespace

int main(int argc, char** argv) {
  return pairs::run_group("law slip",
                          {{"shear and stiffness follow from the law", shear_and_stiffness_follow_from_the_law},
                           {"a sphere slips as Mindlin says", a_sphere_slips_as_mindlin_says},
                           {"loops obey Masing, and small ones are forgotten", loops_obey_masing_and_small_ones_are_forgotten},
                           {"what is pressed on without slip keeps its shear", what_is_pressed_on_without_slip_keeps_its_shear},
                           {"the tangent is the derivative of the step", the_tangent_is_the_derivative_of_the_step},
                           {"joined layers change the shear by what is said", joined_layers_change_the_shear_by_what_is_said},
                           {"a state is copied, and stepped in place", a_state_is_copied_and_stepped_in_place}},
                          argc, argv);
}
