// Derivatives of a step against those of the oracle, whose points keep their states.
#include <roughcontact/derivatives.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "property.h"

namespace scenes {

namespace {

// How an answer changes with changes of its data.
struct Change {
  Reals p, gap;
  Real load = 0, approach = 0;
};

struct Data {
  Reals gap;
  Real target = 0, modulus = 0;  // changes; target: of the approach or the load
};

Real dot(const Field& a, const Reals& b) {
  Real sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<Real>(a[i]) * b[i];
  return sum;
}

// H_FF dp = dd - dh + H p dE/E on the points F that are loose, and sum dp by the load.
Change changed(const Case& c, const StepAnswer& answer, const Exact& exact, const Factor& factor, const Data& data) {
  const Scene& scene = c.scene();
  const std::size_t n = scene.points();
  Change change;
  const Reals softer = scene.halfspace() ? c.h().times(Reals(answer.p.begin(), answer.p.end())) : Reals(n, 0);
  const Real by = scene.halfspace() ? data.modulus / static_cast<Real>(scene.system.modulus) : 0, cell = scene.cell_area();
  Reals right;
  for (const std::size_t i : exact.loose) right.push_back(softer[i] * by - data.gap[i]);
  Reals dp = factor.solve(right);
  const Reals unit = factor.solve(Reals(right.size(), 1));
  const Real at_rest = std::accumulate(dp.begin(), dp.end(), Real{0}),
             of_unit = std::accumulate(unit.begin(), unit.end(), Real{0});
  change.approach = scene.by_load() ? (data.target / cell - at_rest) / of_unit : data.target;
  change.p.assign(n, 0);
  for (std::size_t k = 0; k < dp.size(); ++k) change.p[exact.loose[k]] = dp[k] + change.approach * unit[k];
  change.gap = c.h().times(change.p);
  for (std::size_t i = 0; i < n; ++i)  // none at excluded points
    change.gap[i] = c.surface(0).included(i) ? change.gap[i] + data.gap[i] - change.approach - softer[i] * by : 0;
  change.load = cell * std::accumulate(change.p.begin(), change.p.end(), Real{0});
  return change;
}

// dJ/dh: with s = dJ/dp + H dJ/dgap + the load's part, dJ/dgap - H_FF^-1 s at loose points, and by the load the part of the
// approach.
Reals gradient_of(const Case& c, const Exact& exact, const Factor& factor, const Field& by_p, const Field& by_gap, Real by_load,
                  Real by_approach) {
  const std::size_t n = c.scene().points();
  Reals result(n, 0);
  Real gaps = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (c.surface(0).included(i)) gaps += result[i] = by_gap[i];
  const Reals deflected = c.h().times(result);
  Reals s;
  for (const std::size_t i : exact.loose)
    s.push_back(static_cast<Real>(by_p[i]) + deflected[i] + by_load * c.scene().cell_area());
  const Reals y = factor.solve(s), unit = factor.solve(Reals(s.size(), 1));
  const Real rest = std::accumulate(y.begin(), y.end(), Real{0}) - gaps + by_approach,
             share = c.scene().by_load() ? rest / std::accumulate(unit.begin(), unit.end(), Real{0}) : 0;
  for (std::size_t k = 0; k < y.size(); ++k) result[exact.loose[k]] += share * unit[k] - y[k];
  return result;
}

class Slopes final : public Property {
 public:
  std::string ask(const Case& c) override {
    const Scene& scene = c.scene();
    if (scene.large()) return "many points";
    if (scene.control == RC_CONTROL_AREA) return "control by area";
    if (c.answers().front().status != RC_OK) return "not certified";
    loose_ = Random(scene.seed, 702).chance(0.3);
    const Handle contact = c.open({{"tol", loose_ ? "1e-5" : "1e-10"}});
    answer_ = c.solve(contact.get(), scene.steps.front());
    if (answer_.status != RC_OK) return "not certified to this tolerance";
    exact_ = c.exact_of(answer_, c.surface(0), true);
    if (exact_.worth != Worth::exact) return "points at two states";
    if (exact_.loose.empty()) return "no point is loose";
    if (scene.periodic() && exact_.loose.size() == scene.points()) return "full periodic contact";
    for (std::size_t i = 0; i < scene.points(); ++i) {
      const bool loose = std::ranges::binary_search(exact_.loose, i);
      if (loose != (answer_.p[i] > 0 && answer_.p[i] < static_cast<double>(c.cap()))) return "another contact set";
    }
    factor_ = Factor::of(c.h(), exact_.loose);
    if (!factor_) return "not positive definite";
    draw(c);
    return call(c, contact.get());
  }

  Verdict judge(const Case& c) const override {
    const Change exact = changed(c, answer_, exact_, *factor_, data_);
    // Two right sides are solved to 300 tol of their length; the step's own tolerance moves p, and so what a modulus changes.
    Real right = std::abs(exact.approach), size = 0, error = 0;
    for (const std::size_t i : exact_.loose) right = std::max(right, std::abs(data_.gap[i]));
    const Real of_modulus = c.scene().halfspace() ? std::abs(data_.modulus / static_cast<Real>(c.scene().system.modulus)) : 0;
    for (const std::size_t i : exact_.loose)
      right = std::max(
          right, of_modulus * std::abs(static_cast<Real>(answer_.result.approach) - static_cast<Real>(c.surface(0).gap[i])));
    const Real points = static_cast<Real>(exact_.loose.size());
    // Periodic: the mean pressure, which deflects nothing, is found beside the others, and is part of what residuals are relative
    // to.
    if (c.scene().periodic()) right += c.h()(0, 0) / 2 * std::abs(exact.load) / static_cast<Real>(c.scene().cell_area());
    const Real relative = (loose_ ? 1e-2L : 1e-7L) * std::sqrt(points), allowed = exact_.inverse * right * relative;
    for (std::size_t i = 0; i < exact.p.size(); ++i) {
      size = std::max(size, std::abs(exact.p[i]));
      const Real off = static_cast<Real>(dp_[i]) - exact.p[i];
      error += off * off;
      need(std::abs(off) <= allowed, "dp is off by " + number(off) + " of " + number(exact.p[i]) + ", allowed " +
                                         number(allowed) + ", at point " + std::to_string(i));
      if (!c.surface(0).included(i)) continue;
      const Real slack = allowed * c.h().largest_row() + relative * right;
      need(std::abs(static_cast<Real>(dgap_[i]) - exact.gap[i]) <= slack,
           "dgap is off by " + number(static_cast<Real>(dgap_[i]) - exact.gap[i]) + ", allowed " + number(slack) + ", at point " +
               std::to_string(i));
    }
    if (!std::isnan(tangent_.error))
      need(std::sqrt(error) <= static_cast<Real>(tangent_.error) * (1 + 1e-6L) + allowed / relative * 1e-9L * std::sqrt(points),
           "the error of dp is " + number(std::sqrt(error)) + ", promised " + number(tangent_.error));
    if (!std::isnan(gradient_.error)) {
      const Reals gradient = gradient_of(c, exact_, *factor_, dJ_dp_, dJ_dgap_, by_load_, by_approach_);
      Real off = 0, all = 0;
      for (std::size_t i = 0; i < gradient.size(); ++i) {
        off += std::pow(static_cast<Real>(dJ_dh_[i]) - gradient[i], 2);
        all += gradient[i] * gradient[i];
      }
      need(std::sqrt(off) <= static_cast<Real>(gradient_.error) * (1 + 1e-6L) + 1e-9L * std::sqrt(all),
           "the error of dJ/dh is " + number(std::sqrt(off)) + ", promised " + number(gradient_.error));
    }
    const Real cell = c.scene().cell_area();
    const auto near = [&](Real value, Real wanted, Real slack, const char* what) {
      need(std::abs(value - wanted) <= slack, std::string(what) + " " + number(value) + " instead of " + number(wanted));
    };
    near(tangent_.dload, exact.load, cell * points * allowed, "dload");
    near(tangent_.dapproach, exact.approach, relative * right * 10 + allowed / exact_.inverse * 10, "dapproach");
    // The transposed: what J changes by is the same either way.
    const Real forward = dot(dJ_dp_, exact.p) + dot(dJ_dgap_, exact.gap) + by_load_ * exact.load + by_approach_ * exact.approach;
    Real backward = static_cast<Real>(gradient_.dJ_dtarget) * data_.target, sizes = 0;
    for (std::size_t i = 0; i < dJ_dh_.size(); ++i)
      if (c.surface(0).included(i)) backward += static_cast<Real>(dJ_dh_[i]) * data_.gap[i];
    if (c.scene().halfspace()) backward += static_cast<Real>(gradient_.dJ_dmodulus) * data_.modulus;
    for (std::size_t i = 0; i < exact.p.size(); ++i) {
      sizes += std::abs(static_cast<Real>(dJ_dp_[i])) * allowed;
      sizes += std::abs(static_cast<Real>(dJ_dgap_[i])) * (allowed * c.h().largest_row() + relative * right);
    }
    sizes += std::abs(by_load_) * cell * points * allowed + std::abs(by_approach_) * relative * right * 20;
    near(backward, forward, 10 * sizes, "the change by the gradient is");
    return Verdict::held;
  }

  // A derivative that is off by a thousandth, or of the other sign.
  bool spoil(const Case&, Random& random) override {
    if (loose_) return false;
    const auto most = [](Field& v) -> double& { return *std::ranges::max_element(v, {}, [](double x) { return std::abs(x); }); };
    double& value = random.chance(0.5) ? most(dp_) : most(dJ_dh_);
    value *= random.chance(0.5) ? 1.01 : -1;
    return value != 0 && exact_.inverse > 0;
  }

 private:
  void draw(const Case& c) {
    const Scene& scene = c.scene();
    Random random(scene.seed, 700);
    const std::size_t n = scene.points();
    const Real compression =
        std::max<Real>(1e-300L, static_cast<Real>(answer_.result.approach) -
                                    static_cast<Real>(*std::ranges::min_element(
                                        c.surface(0).gap, {}, [](double v) { return std::isnan(v) ? HUGE_VAL : v; })));
    for (std::size_t i = 0; i < n; ++i) {
      data_.gap.push_back(c.surface(0).included(i)
                              ? static_cast<Real>(static_cast<double>(compression * static_cast<Real>(random.uniform(-1, 1))))
                              : 0);
      dJ_dp_.push_back(random.uniform(-1, 1));
      dJ_dgap_.push_back(random.uniform(-1, 1) / static_cast<double>(c.h()(0, 0)));
    }
    data_.target = static_cast<double>(scene.by_load() ? random.uniform(-1, 1) * answer_.result.load
                                                       : random.uniform(-1, 1) * static_cast<double>(compression));
    data_.modulus = scene.halfspace() ? random.uniform(-1, 1) * scene.system.modulus : 0;
    if (loose_ || random.chance(0.2)) data_.modulus = 0;
  }

  std::string call(const Case& c, rc_contact* contact) {
    const std::size_t n = c.scene().points();
    Random random(c.scene().seed, 701);
    Field dh(data_.gap.begin(), data_.gap.end());
    dp_.assign(n, 0);
    dgap_.assign(n, 0);
    dJ_dh_.assign(n, 0);
    tangent_ = RC_TANGENT_INIT;
    tangent_.dundeformed_gap = RC_IN(dh.data());
    tangent_.dtarget = static_cast<double>(data_.target);
    tangent_.dmodulus = static_cast<double>(data_.modulus);
    tangent_.dp = RC_OUT(dp_.data());
    tangent_.dgap = RC_OUT(dgap_.data());
    const rc_status forward = rc_contact_tangent(contact, &tangent_);
    if (forward > 0) return "stopped";
    pairs::check(forward == RC_OK, std::string("rc_contact_tangent: ") + rc_last_error());
    gradient_ = RC_GRADIENT_INIT;
    if (random.chance(0.2)) {  // without cotangents: those of the load, or of the approach that it has
      dJ_dp_.assign(n, 0);
      dJ_dgap_.assign(n, 0);
      by_load_ = c.scene().by_load() ? 0 : 1;
      by_approach_ = 1 - by_load_;
    } else {
      gradient_.dJ_dp = RC_IN(dJ_dp_.data());
      gradient_.dJ_dgap = RC_IN(dJ_dgap_.data());
      by_load_ = gradient_.dJ_dload = random.uniform(-1, 1) / c.scene().cell_area();
      by_approach_ = gradient_.dJ_dapproach = random.uniform(-1, 1) / static_cast<double>(c.h()(0, 0));
    }
    gradient_.dJ_dundeformed_gap = RC_OUT(dJ_dh_.data());
    const rc_status reverse = rc_contact_gradient(contact, &gradient_);
    if (reverse > 0) return "stopped";
    pairs::check(reverse == RC_OK, std::string("rc_contact_gradient: ") + rc_last_error());
    return "";
  }

  StepAnswer answer_;
  Exact exact_;
  std::optional<Factor> factor_;
  Data data_;
  Field dJ_dp_, dJ_dgap_, dJ_dh_, dp_, dgap_;
  Real by_load_ = 0, by_approach_ = 0;  // of J
  bool loose_ = false;                  // solved to few digits, for the errors that are promised
  rc_tangent tangent_{};
  rc_gradient gradient_{};
};

constexpr std::array kinds_of_slopes{Kind{"slopes", 2, 1, 0.4, 0, made<Slopes>}};

}  // namespace

std::span<const Kind> properties_of_slopes() { return kinds_of_slopes; }

}  // namespace scenes
