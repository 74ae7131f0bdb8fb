// The oracle's own tests. Linked without the library: what is compared is the oracle with closed forms and enumeration.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <numeric>
#include <sstream>

#include "draw.h"
#include "matrices.h"
#include "oracle.h"

namespace scenes {

namespace {

using pairs::check, pairs::text;

constexpr Real unlimited = HUGE_VALL;

Scene grid(const std::string& kernel, std::int32_t boundary, std::int64_t nx, std::int64_t ny, double hx, double hy) {
  Scene scene;
  scene.kernel = kernel;
  scene.system.op = RC_OPERATOR_HALFSPACE;
  scene.system.boundary = boundary;
  scene.system.nx = nx;
  scene.system.ny = ny;
  scene.system.hx = hx;
  scene.system.hy = hy;
  scene.system.modulus = 1;
  return scene;
}

void near(Real value, Real wanted, Real allowed, const std::string& what) {
  check(std::abs(value - wanted) <= allowed,
        what + ": " + text(static_cast<double>(value)) + " off by " + text(static_cast<double>(value - wanted)));
}

// 40 digits of another program, tests/unit/kernel/kernel_reference.py.
void tables_have_the_digits_of_the_reference() {
  std::ifstream file(RC_KERNEL_REFERENCE);
  int compared = 0;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kernel, digits;
    double hx = 0, hy = 0;
    std::int64_t ix = 0, iy = 0;
    if (!(words >> kernel >> hx >> hy >> ix >> iy >> digits) || kernel.starts_with('#') || ix > 40 || iy > 40) continue;
    const Scene scene = grid(kernel, RC_BOUNDARY_FREE, ix + 1, iy + 1, hx, hy);
    const Real wanted = std::stold(digits), self = influence_table(grid(kernel, RC_BOUNDARY_FREE, 1, 1, hx, hy)).front();
    const bool oblong = std::max(hx, hy) > 10 * std::min(hx, hy);  // where galerkin, which is not drawn, loses digits
    near(influence_table(scene).back(), wanted, (oblong ? 1e-9L : 1e-13L) * wanted + 1e-15L * self, line);
    ++compared;
  }
  check(compared > 100, std::to_string(compared) + " coefficients were compared");
}

// The cells of one row that repeats make a strip under constant pressure: a line load spread over the cell.
void rows_of_strips_are_line_loads() {
  const std::pair<std::int64_t, std::int64_t> sides[] = {{1, 1}, {1, 9}, {9, 1}, {8, 8}, {3, 20}, {20, 3}, {17, 16}};
  for (const auto& [nx, ny] : sides)
    for (const double hy : {0.05, 1.0, 20.0})
      for (const char* kernel : {"love", "spectral"}) {
        const Scene scene = grid(kernel, RC_BOUNDARY_PERIODIC_X, nx, ny, 1, hy);
        const Reals table = influence_table(scene);
        const Real R = static_cast<Real>(nx) + static_cast<Real>(ny) * static_cast<Real>(hy), h = hy;
        for (std::int64_t iy = 0; iy < ny; ++iy) {
          const auto from = table.begin() + iy * nx;
          const Real sum = std::accumulate(from, from + nx, Real{0}), y = static_cast<Real>(iy) * h;
          const auto x_log = [](Real x) { return x == 0 ? 0 : x * std::log(std::abs(x)); };
          const Real wanted = 2 / std::numbers::pi_v<Real> * (h * (1 + std::log(R)) - x_log(y + h / 2) + x_log(y - h / 2));
          near(sum, wanted, 2e-13L * std::abs(wanted), scene.kernel + ", row " + std::to_string(iy));
        }
        Scene other = grid(kernel, RC_BOUNDARY_PERIODIC_Y, ny, nx, hy, 1);
        const Reals turned = influence_table(other);
        for (std::int64_t i = 0; i < nx * ny; ++i)
          near(turned[static_cast<std::size_t>(i % nx * ny + i / nx)], table[static_cast<std::size_t>(i)], 1e-18L * table.front(),
               "along y");
      }
}

// A pressure wave deflects by 2/(E* q) times itself.
void a_wave_deflects_by_its_own_multiple() {
  const Scene scene = grid("spectral", RC_BOUNDARY_PERIODIC, 12, 7, 0.5, 2);
  const Influence h(scene);
  for (const auto& [kx, ky] : {std::pair{1, 0}, {0, 3}, {6, 0}, {5, 2}}) {
    Reals wave;
    for (int i = 0; i < 84; ++i)
      wave.push_back(std::cos(2 * std::numbers::pi_v<Real> *
                              (static_cast<Real>(kx * (i % 12)) / 12 + static_cast<Real>(ky * (i / 12)) / 7)));
    const Real q = 2 * std::numbers::pi_v<Real> * std::hypot(static_cast<Real>(kx) / 6, static_cast<Real>(ky) / 14);
    const Reals deflected = h.times(wave);
    for (std::size_t i = 0; i < wave.size(); ++i) near(deflected[i], 2 / q * wave[i], 1e-17L, "wave");
  }
  const Reals flat = h.times(Reals(84, 1));
  near(*std::ranges::max_element(flat), 0, 1e-17L, "the mean deflects nothing");
}

// All choices of zero, loose and capped, of which one satisfies the conditions.
std::optional<Reals> by_enumeration(const Influence& h, const Reals& u, Real cap) {
  const std::size_t n = u.size(), states = cap < unlimited ? 3 : 2;
  std::size_t all = 1;
  for (std::size_t i = 0; i < n; ++i) all *= states;
  for (std::size_t number = 0; number < all; ++number) {
    std::vector<std::size_t> loose;
    Reals p(n, 0);
    std::vector<std::size_t> state;
    for (std::size_t i = 0, rest = number; i < n; ++i, rest /= states) {
      state.push_back(rest % states);
      if (state[i] == 1) loose.push_back(i);
      if (state[i] == 2) p[i] = cap;
    }
    const auto factor = Factor::of(h, loose);
    if (!factor) continue;
    const Reals of_capped = h.times(p);
    Reals right;
    for (const std::size_t i : loose) right.push_back(u[i] - of_capped[i]);
    const Reals x = factor->solve(right);
    for (std::size_t k = 0; k < x.size(); ++k) p[loose[k]] = x[k];
    const Reals w = h.times(p);
    bool good = true;
    for (std::size_t i = 0; i < n; ++i) {
      good = good && p[i] >= 0 && p[i] <= cap;
      good = good && (state[i] != 0 || w[i] >= u[i]) && (state[i] != 2 || w[i] <= u[i]);
    }
    if (good) return p;
  }
  return {};
}

void solutions_are_those_of_enumeration() {
  int capped = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed, 1);
    Scene scene;
    scene.system.op = RC_OPERATOR_DENSE;
    scene.system.nx = random.between(1, 7);
    scene.system.ny = 1;
    const std::size_t n = scene.points();
    scene.matrix = random_matrix(n, random);
    const Influence h(scene);
    Reals u;
    for (std::size_t i = 0; i < n; ++i) u.push_back(random.uniform(-1, 2));
    const Real cap = random.chance(0.5) ? unlimited : static_cast<Real>(random.uniform(0.1, 1) / scene.matrix.front());
    const auto wanted = by_enumeration(h, u, cap);
    check(wanted.has_value(), "enumeration finds a solution");
    const Exact exact = solve_exactly(h, u, std::vector<bool>(n, true), cap, 1e-18L);
    check(exact.worth != Worth::unknown, "seed " + std::to_string(seed) + " is not solved");
    for (std::size_t i = 0; i < n; ++i)
      near(exact.p[i], (*wanted)[i], 1e-12L * *std::ranges::max_element(*wanted) + exact.error, "seed " + std::to_string(seed));
    capped += exact.capped > 0;
  }
  check(capped > 20, "too few reach the cap");
}

// p and w are chosen, both zero at every third point; u follows. Each tie is found.
void ties_that_are_built_are_found() {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed, 2);
    const std::int32_t boundary = static_cast<std::int32_t>(random.between(1, 4));
    const Scene scene = grid(boundary == RC_BOUNDARY_PERIODIC ? "spectral" : "love", boundary, random.between(2, 9),
                             random.between(2, 9), 1, random.decades(-1, 1));
    const Influence h(scene);
    const Real cap = random.chance(0.5) ? unlimited : 0.5L;
    Reals p(scene.points(), 0), w(scene.points(), 0);
    std::int64_t ties = 0, contacts = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (i % 3 == 0)
        ++ties;
      else if (random.chance(0.5))
        p[i] = std::min(cap, static_cast<Real>(random.uniform(0.01, 1)));
      else
        w[i] = random.uniform(0.01, 1);
      if (p[i] == cap) w[i] = -static_cast<Real>(random.uniform(0.01, 1));
      contacts += p[i] > 0;
    }
    Reals u = h.times(p);
    for (std::size_t i = 0; i < p.size(); ++i) u[i] -= w[i];
    const Exact exact = solve_exactly(h, u, std::vector<bool>(p.size(), true), cap, 1e-17L);
    const std::string what = "seed " + std::to_string(seed);
    check(exact.usable(), what + " is not solved");
    const Real most = std::max<Real>(1e-3L, *std::ranges::max_element(p));
    for (std::size_t i = 0; i < p.size(); ++i) near(exact.p[i], p[i], 1e-12L * most + exact.error, what + ", p");
    check(exact.contacts <= contacts && exact.contacts_possible >= contacts + ties,
          what + ": " + std::to_string(exact.contacts) + " .. " + std::to_string(exact.contacts_possible) + " contacts of " +
              std::to_string(contacts) + " and " + std::to_string(ties) + " ties");
  }
}

// Boundaries, hardness, masks and controls all occur, and with each other.
void seeds_in_a_row_cover_the_kinds() {
  for (const std::uint64_t first : {0, 640}) {
    std::vector<int> pairs(64, 0);
    for (std::uint64_t seed = first; seed < first + 64; ++seed) {
      const Scene scene = draw(seed, true), again = draw(seed, true);
      check(scene.words == again.words && scene.steps.front().target == again.steps.front().target, "a seed has one scene");
      const int boundary = scene.halfspace() ? scene.system.boundary - 1 : 4;
      pairs[static_cast<std::size_t>(boundary * 8 + scene.hard() * 4 + !scene.surfaces.front().mask.empty() * 2 +
                                     scene.by_load())] += 1;
    }
    for (int boundary = 0; boundary < 5; ++boundary)
      for (int bit = 0; bit < 3; ++bit)
        for (int value = 0; value < 2; ++value) {
          int count = 0;
          for (int k = 0; k < 8; ++k)
            if ((k >> bit & 1) == value) count += pairs[static_cast<std::size_t>(boundary * 8 + k)];
          check(count > 0, "boundary " + std::to_string(boundary) + " misses bit " + std::to_string(bit));
        }
  }
}

}  // namespace

}  // namespace scenes

int main(int argc, char** argv) {
  using namespace scenes;
  return pairs::run_group(
      "scenes oracle",
      RC_TESTS(tables_have_the_digits_of_the_reference, rows_of_strips_are_line_loads, a_wave_deflects_by_its_own_multiple,
               solutions_are_those_of_enumeration, ties_that_are_built_are_found, seeds_in_a_row_cover_the_kinds),
      argc, argv);
}
