// Leaks of a scene's last answer against the exact gap's network, by the star-mesh transform, which subtracts nothing.
#include <roughcontact/flow.h>

#include <array>
#include <cmath>

#include "property.h"

namespace scenes {

namespace {

class Network {
 public:
  // gap: 0 where closed. The last two nodes are inlet and outlet.
  Network(const Scene& scene, const Reals& gap, bool along_y)
      : gap_(gap), n_(gap.size()), nx_(static_cast<std::size_t>(scene.system.nx)), c_((n_ + 2) * (n_ + 2)) {
    const std::size_t ny = n_ / nx_;
    const bool whole = scene.periodic(), round_x = along_y && (whole || is(scene, RC_BOUNDARY_PERIODIC_X)),
               round_y = !along_y && (whole || is(scene, RC_BOUNDARY_PERIODIC_Y));
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
  static bool is(const Scene& scene, std::int32_t boundary) { return scene.halfspace() && scene.system.boundary == boundary; }
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
    answer.result.p = RC_OUT(answer.p.data());
    answer.result.gap = RC_OUT(answer.gap.data());
    status_ = rc_flow_of_result(&c.system(), c.options().get(), &answer.result, &spec, &found_);
    message_ = rc_flow_last_error();
    return std::isinf(found_.upper) && status_ >= 0 ? "no gap error" : "";
  }

  Verdict judge(const Case& c) const override {
    need(status_ >= 0, std::string(rc_status_name(status_)) + ": " + message_);
    need(found_.lower <= found_.flow && found_.flow <= found_.upper, "the flow is not in its interval");
    if (c.exact(at_).worth != Worth::exact) return Verdict::undecidable;
    const auto [low, high] = truth(c);
    need(found_.lower <= high && low <= found_.upper, "the flow " + number(low) + " .. " + number(high) + " is not in " +
                                                          number(found_.lower) + " .. " + number(found_.upper));
    return Verdict::held;
  }

  bool spoil(const Case& c, Random& random) override {
    if (status_ < 0 || c.exact(at_).worth != Worth::exact) return false;
    const auto [low, high] = truth(c);
    if (!(high < low * (1 + 1e-7L))) return false;
    if (random.chance(0.5))
      found_.lower = static_cast<double>(high * (1 + 1e-6L));
    else
      found_.upper = static_cast<double>(low * (1 - 1e-6L));
    return true;
  }

 private:
  // The exact conductance, and how sure the oracle's gap is.
  std::pair<Real, Real> truth(const Case& c) const {
    const Exact& exact = c.exact(at_);
    const Real error = exact.error * c.h().largest_row() + 1e-17L * std::abs(static_cast<Real>(c.answers()[at_].result.approach));
    Reals low(exact.w.size()), high(low);
    for (std::size_t i = 0; i < low.size(); ++i) {
      if (!c.surface(at_).included(i) || exact.p[i] > 0) continue;
      low[i] = std::max<Real>(0, exact.w[i] - error);
      high[i] = std::max<Real>(0, exact.w[i] + error);
    }
    const Scene& scene = c.scene();
    return {Network(scene, low, along_y_).conductance() * (1 - 1e-15L),
            Network(scene, high, along_y_).conductance() * (1 + 1e-15L)};
  }

  std::size_t at_ = 0;
  bool along_y_ = false;
  rc_flow_result found_ = RC_FLOW_RESULT_INIT;
  rc_status status_ = RC_ERR_INTERNAL;
  std::string message_;
};

constexpr std::array kinds_of_flows{Kind{"leaks", 2, 0, 0.3, 0.1, made<Leaks>}};

}  // namespace

std::span<const Kind> properties_of_flows() { return kinds_of_flows; }

}  // namespace scenes
