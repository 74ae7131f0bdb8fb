// Leaks of a scene's last answer against the exact gap's network, by the star-mesh transform, which subtracts nothing; flows and
// flow factors of its gap.
#include <roughcontact/flow.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "property.h"

namespace scenes {

namespace {

class Network {
 public:
  // gap: 0 where closed. round: across the flow the cells repeat. The last two nodes are inlet and outlet.
  Network(const Scene& scene, const Reals& gap, bool along_y, bool round)
      : gap_(gap), n_(gap.size()), nx_(static_cast<std::size_t>(scene.system.nx)), c_((n_ + 2) * (n_ + 2)) {
    const std::size_t ny = n_ / nx_;
    const bool round_x = along_y && round, round_y = !along_y && round;
    const Real along_x = static_cast<Real>(scene.system.hy) / static_cast<Real>(scene.system.hx);
    for (std::size_t y = 0; y < ny; ++y)
      for (std::size_t x = 0; x < nx_; ++x) {
        const std::size_t i = y * nx_ + x;
        if (x + 1 < nx_ || round_x) join(i, y * nx_ + (x + 1) % nx_, along_x);
        if (y + 1 < ny || round_y) join(i, (y + 1) % ny * nx_ + x, 1 / along_x);
        const Real half = 2 * cube(i) * (along_y ? 1 / along_x : along_x);
        if ((along_y ? y : x) == 0) add(i, n_, half);
        if ((along_y ? y + 1 : x + 1) == (along_y ? ny : nx_)) add(i, n_ + 1, half);
      }
  }

  Real conductance() {
    const std::size_t nodes = n_ + 2;
    for (std::size_t k = 0; k < n_; ++k) {
      Real sum = 0;
      for (std::size_t j = k + 1; j < nodes; ++j) sum += c_[k * nodes + j];
      for (std::size_t i = k + 1; sum > 0 && i < nodes; ++i)
        for (std::size_t j = i + 1; c_[k * nodes + i] > 0 && j < nodes; ++j)
          add(i, j, c_[k * nodes + i] * c_[k * nodes + j] / sum);
    }
    return c_[n_ * nodes + n_ + 1];
  }

 private:
  Real cube(std::size_t i) const { return gap_[i] * gap_[i] * gap_[i]; }
  void add(std::size_t i, std::size_t j, Real conductance) {
    if (i == j) return;
    c_[i * (n_ + 2) + j] += conductance;
    c_[j * (n_ + 2) + i] += conductance;
  }
  void join(std::size_t i, std::size_t j, Real factor) {
    const Real a = cube(i), b = cube(j);
    if (a > 0 && b > 0) add(i, j, factor * 2 * a * (b / (a + b)));
  }

  const Reals& gap_;
  std::size_t n_, nx_;
  Reals c_;
};

// The gap of an answer, 0 where it is closed.
Field open_gap(const Case& c, std::size_t at) {
  const StepAnswer& answer = c.answers()[at];
  Field gap(answer.gap);
  for (std::size_t i = 0; i < gap.size(); ++i)
    if (answer.p[i] > 0 || !c.surface(at).included(i) || !(gap[i] > 0)) gap[i] = 0;
  return gap;
}

rc_flow_spec spec_of(const Scene& scene, const Field& gap) {
  rc_flow_spec spec = RC_FLOW_SPEC_INIT;
  spec.viscosity = 1.0 / 12;
  spec.pressure_drop = 1;
  spec.nx = scene.system.nx;
  spec.ny = scene.system.ny;
  spec.hx = scene.system.hx;
  spec.hy = scene.system.hy;
  spec.gap = RC_IN(gap.data());
  return spec;
}

class Leaks final : public Property {
 public:
  std::string ask(const Case& c) override {
    if (c.system().op == RC_OPERATOR_CALLBACK) return "an own product";
    if (c.scene().points() > 120) return "many points";
    at_ = c.answers().size() - 1;
    StepAnswer answer = c.answers()[at_];
    if (answer.status < 0) return "failed";
    along_y_ = Random(c.scene().seed, 900).chance(0.5);
    rc_flow_spec spec = RC_FLOW_SPEC_INIT;
    spec.along = along_y_ ? RC_FLOW_Y : RC_FLOW_X;
    spec.viscosity = 1.0 / 12;
    spec.pressure_drop = 1;
    const Surface& surface = c.surface(at_);
    spec.mask = RC_IN(surface.mask.empty() ? nullptr : surface.mask.data());
    Random random(c.scene().seed, 903);
    exact_ = c.exact(at_);
    approach_ = static_cast<Real>(answer.result.approach);
    if (!c.scene().hard() && random.chance(0.4)) answer = perturbed(c, answer, random);
    const bool of_load = answer.status == RC_OK && c.scene().by_load() && !c.scene().hard();
    if (of_load && random.chance(0.5)) spec.load = load_of(c.scene(), c.scene().steps[at_].target);
    if (spec.load > 0) find_exact_at(c, answer, static_cast<Real>(spec.load));
    least_error_ = answer.result.gap_error;
    answer.result.p = RC_OUT(answer.p.data());
    answer.result.gap = RC_OUT(answer.gap.data());
    status_ = rc_flow_of_result(&c.system(), c.options().get(), &answer.result, &spec, &found_);
    message_ = rc_flow_last_error();
    return std::isinf(found_.upper) && status_ >= 0 ? "no gap error" : "";
  }

  Verdict judge(const Case& c) const override {
    need(status_ >= 0, std::string(rc_status_name(status_)) + ": " + message_);
    need(found_.lower <= found_.flow && found_.flow <= found_.upper, "the flow is not in its interval");
    need(!(found_.gap_error < least_error_), "the gap's error is less than that of the contact");
    if (exact_.worth != Worth::exact) return Verdict::undecidable;
    const auto [low, high] = truth(c);
    need(found_.lower <= high && low <= found_.upper, "the flow " + number(low) + " .. " + number(high) + " is not in " +
                                                          number(found_.lower) + " .. " + number(found_.upper));
    return Verdict::held;
  }

  bool spoil(const Case& c, Random& random) override {
    if (status_ < 0 || exact_.worth != Worth::exact) return false;
    const auto [low, high] = truth(c);
    if (!(high < low * (1 + 1e-7L))) return false;
    if (random.chance(0.5))
      found_.lower = static_cast<double>(high * (1 + 1e-6L));
    else
      found_.upper = static_cast<double>(low * (1 - 1e-6L));
    return true;
  }

 private:
  // Wrong pressures at the answer's approach, certified as they are.
  StepAnswer perturbed(const Case& c, StepAnswer answer, Random& random) const {
    const double noise = random.decades(-6, -1);
    const double most = noise * answer.result.max_pressure;
    for (std::size_t i = 0; i < answer.p.size(); ++i)
      if (c.surface(at_).included(i))
        answer.p[i] = answer.p[i] * (1 + noise * random.uniform(-0.5, 0.5)) + (random.chance(0.1) ? most : 0);
    rc_step step = c.step(c.scene().steps[at_]);
    step.control = RC_CONTROL_APPROACH;
    step.target = answer.result.approach;
    answer.result = RC_RESULT_INIT;
    answer.result.p = RC_OUT(answer.p.data());
    answer.result.gap = RC_OUT(answer.gap.data());
    answer.status = rc_contact_certify(c.open().get(), &step, &answer.result);
    return answer.status < 0 ? c.answers()[at_] : answer;
  }

  // By Newton's method, whose steps end where the contact set stays.
  void find_exact_at(const Case& c, StepAnswer answer, Real load) {
    for (int k = 0; k < 40 && exact_.usable() && exact_.stiffness > 0; ++k) {
      const Real off = (load / c.scene().cell_area() - exact_.sum) / exact_.stiffness;
      off_ = std::abs(off);
      if (off_ <= 1e-16L * std::abs(approach_)) return;
      answer.result.approach += static_cast<double>(off);
      approach_ = static_cast<Real>(answer.result.approach);
      exact_ = c.exact_of(answer, c.surface(at_), false);
    }
    exact_.worth = Worth::unknown;
  }

  // The exact conductance, and how sure the oracle's gap is.
  std::pair<Real, Real> truth(const Case& c) const {
    const Exact& exact = exact_;
    const Real error = exact.error * c.h().largest_row() + 1e-17L * std::abs(approach_) + 4 * off_;
    Reals low(exact.w.size()), high(low);
    for (std::size_t i = 0; i < low.size(); ++i) {
      if (!c.surface(at_).included(i) || exact.p[i] > 0) continue;
      low[i] = std::max<Real>(0, exact.w[i] - error);
      high[i] = std::max<Real>(0, exact.w[i] + error);
    }
    const Scene& scene = c.scene();
    const bool round = scene.repeats_across(along_y_);
    return {Network(scene, low, along_y_, round).conductance() * (1 - 1e-15L),
            Network(scene, high, along_y_, round).conductance() * (1 + 1e-15L)};
  }

  std::size_t at_ = 0;
  Exact exact_;
  Real approach_ = 0, off_ = 0;
  double least_error_ = 0;
  bool along_y_ = false;
  rc_flow_result found_ = RC_FLOW_RESULT_INIT;
  rc_status status_ = RC_ERR_INTERNAL;
  std::string message_;
};

// Flow through gaps that are known up to an error: the interval holds the flow of gaps drawn within it.
class Flow final : public Property {
 public:
  std::string ask(const Case& c) override {
    if (c.scene().points() > 120) return "many points";
    const std::size_t at = c.answers().size() - 1;
    if (c.answers()[at].status < 0) return "failed";
    Random random(c.scene().seed, 901);
    along_y_ = random.chance(0.5);
    round_ = random.chance(0.5);
    const bool exact = random.chance(0.3);
    const Field gap = open_gap(c, at);
    const double largest = *std::ranges::max_element(gap), size = exact ? 0 : largest * random.decades(-9, -1);
    Field error(gap.size(), size);
    for (std::size_t i = 0; i < gap.size(); ++i)
      if (gap[i] == 0 && random.chance(0.7)) error[i] = 0;  // closed for certain
    rc_flow_spec spec = spec_of(c.scene(), gap);
    spec.along = along_y_ ? RC_FLOW_Y : RC_FLOW_X;
    spec.sides = round_ ? RC_FLOW_PERIODIC : RC_FLOW_CLOSED;
    spec.gap_error = RC_IN(error.data());
    spec.width = random.decades(-9, -1);
    if (random.chance(0.3)) spec.memory = 1;  // conjugate gradients
    status_ = rc_flow_solve(&spec, &found_);
    message_ = rc_flow_last_error();
    width_ = spec.width;
    for (std::size_t i = 0; i < gap.size(); ++i)
      true_.push_back(std::max<Real>(0, static_cast<Real>(gap[i]) + static_cast<Real>(error[i]) * random.uniform(-1, 1)));
    return largest > 0 ? "" : "closed";
  }

  Verdict judge(const Case& c) const override {
    need(status_ >= 0, std::string(rc_status_name(status_)) + ": " + message_);
    need(status_ != RC_OK || found_.upper - found_.lower <= width_ * found_.upper * (1 + 1e-12), "wider than RC_OK says");
    const Real flow = Network(c.scene(), true_, along_y_, round_).conductance();
    need(found_.lower <= flow * (1 + 1e-15L) && flow * (1 - 1e-15L) <= found_.upper,
         "the flow " + number(flow) + " is not in " + number(found_.lower) + " .. " + number(found_.upper));
    return Verdict::held;
  }

  bool spoil(const Case& c, Random& random) override {
    const Real flow = Network(c.scene(), true_, along_y_, round_).conductance();
    if (!(flow > 0)) return false;
    if (random.chance(0.5))
      found_.lower = static_cast<double>(flow * (1 + 1e-9L));
    else
      found_.upper = static_cast<double>(flow * (1 - 1e-9L));
    return true;
  }

 private:
  bool along_y_ = false, round_ = false;
  double width_ = 0;
  Reals true_;
  rc_flow_result found_ = RC_FLOW_RESULT_INIT;
  rc_status status_ = RC_ERR_INTERNAL;
  std::string message_;
};

// The tensor of a cell that repeats along both axes, by Gauss' elimination. Gaps below a thousandth of the largest are closed,
// which leaves the elimination ten digits.
class Factors final : public Property {
 public:
  std::string ask(const Case& c) override {
    if (c.scene().points() > 120) return "many points";
    const std::size_t at = c.answers().size() - 1;
    if (c.answers()[at].status < 0) return "failed";
    gap_ = open_gap(c, at);
    const double largest = *std::ranges::max_element(gap_);
    for (double& g : gap_)
      if (g < 1e-3 * largest) g = 0;
    const rc_flow_spec spec = spec_of(c.scene(), gap_);
    status_ = rc_flow_factors_find(&spec, &found_);
    message_ = rc_flow_last_error();
    return largest > 0 ? "" : "closed";
  }

  Verdict judge(const Case& c) const override {
    need(status_ >= 0, std::string(rc_status_name(status_)) + ": " + message_);
    const auto [xx, xy, yy] = tensor(c.scene());
    const Real slack = slack_of(xx + yy);
    within(xx, found_.xx_lower, found_.xx_upper, slack, "xx");
    within(xy, found_.xy_lower, found_.xy_upper, slack, "xy");
    within(yy, found_.yy_lower, found_.yy_upper, slack, "yy");
    return Verdict::held;
  }

  bool spoil(const Case& c, Random& random) override {
    const auto [xx, xy, yy] = tensor(c.scene());
    const Real much = 1e-8L * (xx + yy);
    if (!(much > 4 * slack_of(xx + yy))) return false;
    switch (random.below(3)) {
      case 0:
        found_.xx_upper = static_cast<double>(xx - much);
        return true;
      case 1:
        found_.xy_lower = static_cast<double>(xy + much);
        return true;
      default:
        found_.yy_lower = static_cast<double>(yy + much);
        return true;
    }
  }

 private:
  // The elimination's error, also where no path crosses.
  Real slack_of(Real trace) const {
    return 1e-9L * trace + 1e-17L * std::pow(static_cast<Real>(*std::ranges::max_element(gap_)), 3);
  }
  struct Edge {
    std::size_t from, to;
    Real conductance, jump[2];
  };
  static void within(Real value, double lower, double upper, Real slack, const char* name) {
    need(lower <= value + slack && value - slack <= upper,
         std::string(name) + " " + number(value) + " is not in " + number(lower) + " .. " + number(upper));
  }

  std::array<Real, 3> tensor(const Scene& scene) const {
    const auto nx = static_cast<std::size_t>(scene.system.nx), n = gap_.size(), ny = n / nx;
    const Real along_x = static_cast<Real>(scene.system.hy) / static_cast<Real>(scene.system.hx);
    std::vector<Edge> edges;
    const auto join = [&](std::size_t i, std::size_t j, Real factor, Real x, Real y) {
      const Real a = std::pow(static_cast<Real>(gap_[i]), 3), b = std::pow(static_cast<Real>(gap_[j]), 3);
      if (a > 0 && b > 0) edges.push_back({i, j, factor * 2 * a * b / (a + b), {x, y}});
    };
    for (std::size_t y = 0; y < ny; ++y)
      for (std::size_t x = 0; x < nx; ++x) {
        join(y * nx + x, y * nx + (x + 1) % nx, along_x, x + 1 == nx, 0);
        join(y * nx + x, (y + 1) % ny * nx + x, 1 / along_x, 0, y + 1 == ny);
      }
    const Reals phi[] = {potential(edges, n, 0), potential(edges, n, 1)};
    const auto energy = [&](int a, int b) {
      Real sum = 0;
      for (const Edge& e : edges)
        sum += e.conductance * (phi[a][e.from] - phi[a][e.to] + e.jump[a]) * (phi[b][e.from] - phi[b][e.to] + e.jump[b]);
      return sum;
    };
    const Real shape = along_x * static_cast<Real>(ny) / static_cast<Real>(nx);  // width over length
    return {energy(0, 0) / shape, energy(0, 1), energy(1, 1) * shape};
  }

  // That of least energy for a unit drop along the axis; the last cell of each part is at 0.
  static Reals potential(const std::vector<Edge>& edges, std::size_t n, int axis) {
    std::vector<Reals> m(n, Reals(n + 1, 0));
    for (const Edge& e : edges) {
      if (e.from == e.to) continue;
      m[e.from][e.from] += e.conductance, m[e.to][e.to] += e.conductance;
      m[e.from][e.to] -= e.conductance, m[e.to][e.from] -= e.conductance;
      m[e.from][n] -= e.conductance * e.jump[axis], m[e.to][n] += e.conductance * e.jump[axis];
    }
    Reals size(n), x(n, 0);
    for (std::size_t i = 0; i < n; ++i) size[i] = m[i][i];
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = k + 1; m[k][k] > 1e-13L * size[k] && i < n; ++i) {
        const Real share = m[i][k] / m[k][k];
        for (std::size_t j = k; share != 0 && j <= n; ++j) m[i][j] -= share * m[k][j];
      }
    for (std::size_t k = n; k-- > 0;) {
      if (!(m[k][k] > 1e-13L * size[k])) continue;
      Real rest = m[k][n];
      for (std::size_t j = k + 1; j < n; ++j) rest -= m[k][j] * x[j];
      x[k] = rest / m[k][k];
    }
    return x;
  }

  Field gap_;
  rc_flow_factors found_ = RC_FLOW_FACTORS_INIT;
  rc_status status_ = RC_ERR_INTERNAL;
  std::string message_;
};

constexpr std::array kinds_of_flows{Kind{"leaks", 2, 0, 0.3, 0.1, made<Leaks>}, Kind{"flow", 2, 1, 0.3, 0, made<Flow>},
                                    Kind{"factors", 2, 1, 0.3, 0, made<Factors>}};

}  // namespace

std::span<const Kind> properties_of_flows() { return kinds_of_flows; }

}  // namespace scenes
