// Contact laws of a scene's surface against the oracle, and products with its matrix.
#include <roughcontact/law.h>
#include <roughcontact/product.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>

#include "property.h"

namespace scenes {

namespace {

struct DestroyLaw {
  void operator()(rc_law* law) const { rc_law_destroy(law); }
};
using LawHandle = std::unique_ptr<rc_law, DestroyLaw>;

// The quantities of a law at one approach.
struct LawTruth {
  Real x = 0, p = 0, slope = 0, rate = 1, area = 0, area_possible = 0;
  Real error = 0;       // of p, relative
  bool smooth = false;  // the slope is known
};

// A node between two intervals.
struct Joint {
  double x = 0, left = 0, right = 0, secant = 0;  // slopes on both sides, and from the origin
  double uncertain = 0;                           // widths of the bounds of p at the node and its neighbours, added
};

class AsLaw final : public Property {
 public:
  std::string ask(const Case& c) override {
    const Scene& scene = c.scene();
    if (scene.points() > 40) return "many points";
    const Surface& surface = scene.surfaces.front();
    Random random(scene.seed, 800);
    lowest_ = HUGE_VAL;
    double highest = -HUGE_VAL, sum = 0, count = 0;
    for (std::size_t i = 0; i < scene.points(); ++i) {
      if (!surface.included(i)) continue;
      lowest_ = std::min(lowest_, surface.gap[i]);
      highest = std::max(highest, surface.gap[i]);
      sum += surface.gap[i];
      ++count;
    }
    const double mean = sum / count - lowest_;
    if (!(mean > 1e-9 * std::abs(lowest_))) return "flat";
    mean_gap_ = mean;
    const double first = random.uniform(0.02, 0.2) * mean, last = random.uniform(0.3, scene.periodic() ? 0.8 : 1.5) * mean;
    const double area = scene.cell_area() * static_cast<double>(scene.points());
    const auto pressure = [&](double compression) {
      return static_cast<double>(c.exact_of(at(compression), surface, false).sum) * scene.cell_area() / area;
    };
    rc_law_spec spec = RC_LAW_SPEC_INIT;
    spec.undeformed_gap = RC_IN(surface.gap.data());
    spec.mask = RC_IN(surface.mask.empty() ? nullptr : surface.mask.data());
    spec.p_lower = pressure(first);
    spec.p_upper = pressure(last);
    if (!(spec.p_upper > 1.01 * spec.p_lower) || !(spec.p_lower > 0)) return "no range of pressures";
    tolerance_ = spec.tolerance = random.decades(-3, -1.3);
    spec.bulk = random.chance(0.3) ? RC_LAW_BULK_NONE : RC_LAW_BULK_AUTO;
    spec.max_nodes = 600;
    rc_law* made = nullptr;
    // Other pairs take too long for as many solves.
    const pairs::Settings fast{{"solver", "auto"}, {"backend", "auto"}};
    const bool own = c.pair().name() == "haar-cg*fft";
    status_ = rc_law_create(&c.system(), c.options(own ? pairs::Settings{} : fast).get(), &spec, &made);
    message_ = rc_last_error();
    law_.reset(made);
    if (status_ == RC_ERR_INFEASIBLE) return "closed at p_upper";
    if (!made) return "";
    info_ = RC_LAW_INFO_INIT;
    pairs::check(rc_law_describe(made, &info_) == RC_OK, rc_last_error());
    mean_ = spec.bulk == RC_LAW_BULK_AUTO && scene.halfspace() && !scene.periodic();
    for (int k = 0; k < 6; ++k) {
      const double compression = std::exp(random.uniform(std::log(first), std::log(last)));
      const auto truth = truth_at(c, compression);
      if (!truth || !(truth->x > static_cast<Real>(info_.x_lower)) || !(truth->x < static_cast<Real>(info_.x_upper))) continue;
      truths_.push_back(*truth);
      said_.push_back(evaluated(made, static_cast<double>(truth->x)));
    }
    draw_curve(made, random);
    draw_joints(made);
    if (scene.halfspace() && !scene.hard())
      slip(made);
    else
      need_no_slip(made);
    reload(made);
    return truths_.empty() ? "no pressure in its range" : "";
  }

  Verdict judge(const Case& c) const override {
    need(law_ != nullptr, std::string(rc_status_name(status_)) + ": " + message_);
    need(info_.bulk == (mean_ ? RC_LAW_BULK_MEAN : RC_LAW_BULK_NONE), "the overclosure is of another kind than the header says");
    need(info_.width <= tolerance_ || status_ != RC_OK, "the law is wider than asked for");
    for (std::size_t k = 0; k < truths_.size(); ++k) judge(truths_[k], said_[k], c);
    judge_curve();
    need(!c.scene().hard() || highest_ <= c.scene().system.hardness, "a lower bound beyond the hardness");
    for (const Slip& each : slips_) {
      const LawTruth &high = truths_[each.high], &low = truths_[each.low];
      const Real shear = mu * (high.p - low.p), slack = 1e-8L * mu * high.p * (1 + high.error) + mu * low.error * low.p;
      need(each.lower <= shear + slack && shear - slack <= each.upper,
           "the shear " + number(shear) + " is not in " + number(each.lower) + " .. " + number(each.upper));
    }
    for (const Joint& joint : joints_) judge_joint(joint, c);
    for (std::size_t k = 0; k < loaded_.size(); ++k) {
      const auto same = [](double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); };
      const rc_law_point &a = said_[k], &b = loaded_[k];
      const double first[] = {a.p,           a.p_lower,           a.p_upper,          a.slope,
                              a.energy,      a.area_fraction,     a.area_lower,       a.area_upper,
                              a.conductance, a.conductance_lower, a.conductance_upper},
                   second[] = {b.p,           b.p_lower,           b.p_upper,          b.slope,
                               b.energy,      b.area_fraction,     b.area_lower,       b.area_upper,
                               b.conductance, b.conductance_lower, b.conductance_upper};
      for (std::size_t i = 0; i < std::size(first); ++i)
        need(same(first[i], second[i]), "the loaded law differs by " + pairs::text(second[i] - first[i]));
    }
    return Verdict::held;
  }

  // A bound on the wrong side, bounds wider than the law says, a law that is loaded with other bits, a jump of p or of the slope.
  bool spoil(const Case& c, Random& random) override {
    if (!law_) return false;
    const auto k = static_cast<std::size_t>(random.below(static_cast<std::int64_t>(truths_.size())));
    rc_law_point& said = said_[k];
    switch (random.below(7)) {
      case 6:
        if (slips_.empty()) return false;
        slips_.back().upper = static_cast<double>(mu * (truths_[slips_.back().high].p - truths_[slips_.back().low].p) * 0.999L);
        return slips_.back().upper > 0;
      case 5:
        return std::ranges::any_of(joints_, [&](Joint& joint) {  // the first that has no kink
          joint.right *= 1.01;
          if (joint.right > 0 && !has_kink(joint, c)) return true;
          joint.right /= 1.01;
          return false;
        });
      case 4:
        curve_[curve_.size() / 2].p *= 0.99;
        return curve_.size() > 2;
      case 0:
        said.p_upper = static_cast<double>(truths_[k].p * (1 - 1e-7L));
        return truths_[k].error < 1e-8L;
      case 1:
        said.p_lower *= 0.8;
        said.p_upper *= 1.25;
        return tight(said) && info_.width < 0.2;
      case 2:
        loaded_[k].slope = std::nextafter(loaded_[k].slope, 0.0);
        return loaded_[k].slope > 0;
      default:
        said.area_lower = static_cast<double>(truths_[k].area_possible) * 1.01;
        return tight(said) && said.area_lower > 0;
    }
  }

 private:
  StepAnswer at(double compression) const {
    StepAnswer answer;
    answer.result.approach = lowest_ + compression;
    return answer;
  }

  static rc_law_point evaluated(const rc_law* law, double x) {
    rc_law_point point = RC_LAW_POINT_INIT;
    pairs::check(rc_law_evaluate(law, x, &point) == RC_OK, rc_last_error());
    return point;
  }

  // With the overclosure in the words of law.h: the approach from first touch, or the change of the mean gap.
  std::optional<LawTruth> truth_at(const Case& c, double compression) const {
    const Scene& scene = c.scene();
    const Surface& surface = scene.surfaces.front();
    const StepAnswer there = at(compression);
    const Exact exact = c.exact_of(there, surface, false);
    if (!exact.usable() || !(exact.sum > 0)) return {};
    const Real cell = scene.cell_area(), area = cell * static_cast<Real>(scene.points()), cap = c.cap();
    LawTruth truth;
    truth.p = exact.sum * cell / area;
    truth.error = exact.error * static_cast<Real>(exact.p.size()) / exact.sum;
    truth.area = static_cast<Real>(exact.contacts) * cell / area;
    truth.area_possible = static_cast<Real>(exact.contacts_possible) * cell / area;
    // The approach is a sum of doubles: what it is of the law's surface, which counts from its lowest point.
    const Real approach = static_cast<Real>(there.result.approach) - static_cast<Real>(lowest_);
    const auto factor = Factor::of(c.h(), exact.loose);
    if (!factor) return {};
    Reals dp(scene.points(), 0);
    const Reals unit = factor->solve(Reals(exact.loose.size(), 1));
    for (std::size_t k = 0; k < unit.size(); ++k) dp[exact.loose[k]] = unit[k];
    const Reals dw = c.h().times(dp);
    Real gaps = 0, fall = 0, count = 0;
    for (std::size_t i = 0; i < scene.points(); ++i) {
      if (!surface.included(i)) continue;
      ++count;
      const bool capped = exact.p[i] >= cap;
      gaps += capped ? std::max<Real>(0, exact.w[i]) : exact.w[i];
      fall += capped ? 0 : 1 - dw[i];
    }
    truth.x = mean_ ? static_cast<Real>(mean_gap_) - gaps / count : approach;
    if (mean_) truth.rate = fall / count;
    truth.slope = exact.stiffness * cell / area / truth.rate;
    truth.smooth = exact.worth == Worth::exact;
    return truth;
  }

  // By the overclosure instead of the approach: both grow together, in a polygon.
  std::optional<LawTruth> truth_by(const Case& c, double x) const {
    double compression = x;
    std::optional<LawTruth> truth;
    for (int k = 0; k < 30; ++k) {
      truth = truth_at(c, compression);
      if (!truth || !mean_) return truth;
      const double off = x - static_cast<double>(truth->x);
      if (std::abs(off) <= 4e-16 * x) break;
      compression += off / static_cast<double>(truth->rate);
    }
    return truth;
  }

  // Bounds of p and conductance are no wider than the law says of itself, where it says so.
  bool tight(const rc_law_point& said) const {
    for (std::int64_t i = 0; i + 1 < info_.nodes; ++i) {
      rc_law_point node = RC_LAW_POINT_INIT, next = RC_LAW_POINT_INIT;
      pairs::check(rc_law_describe_node(law_.get(), i, &node) == RC_OK && rc_law_describe_node(law_.get(), i + 1, &next) == RC_OK,
                   rc_last_error());
      if (said.x >= node.x && said.x <= next.x) return node.bounds != RC_LAW_MONOTONE;
    }
    return false;
  }

  void judge(const LawTruth& truth, const rc_law_point& said, const Case& c) const {
    // x is a rounded double, and the datum of the surface may be large beside it.
    Real slack = 1e-9L + truth.error;
    slack += truth.slope / truth.p * 4e-16L * (truth.x + std::abs(static_cast<Real>(lowest_)) + static_cast<Real>(mean_gap_));
    const auto inside = [&](Real value, Real possible, double low, double high, Real loose, const char* what) {
      need(possible >= static_cast<Real>(low) * (1 - loose) && value <= static_cast<Real>(high) * (1 + loose),
           std::string(what) + " " + number(value) + " is not in " + number(low) + " .. " + number(high));
    };
    const auto narrow = [](double low, double value, double high, double width, const char* what) {
      need(high - low <= 2 * width * value * (1 + 1e-6) + 1e-12 * value, std::string(what) + " is known to " +
                                                                             pairs::text((high - low) / (2 * value)) +
                                                                             ", by the law to " + pairs::text(width));
    };
    inside(truth.p, truth.p, said.p_lower, said.p_upper, slack, "p");
    if (!tight(said)) return;
    narrow(said.p_lower, said.p, said.p_upper, info_.width, "p");
    inside(truth.area, truth.area_possible, said.area_lower, said.area_upper, 1e-12L, "the area");
    narrow(said.area_lower, said.area_fraction, said.area_upper, info_.width_area, "the area");
    if (info_.modulus == 0 || !truth.smooth) return;
    const Real conductance = 2 * truth.slope / static_cast<Real>(info_.modulus);
    inside(conductance, conductance, said.conductance_lower, said.conductance_upper, 1e-6L + slack, "the conductance");
    if (std::isfinite(info_.width_conductance))
      narrow(said.conductance_lower, said.conductance, said.conductance_upper, info_.width_conductance, "the conductance");
    need(c.scene().halfspace(), "a conductance without a half-space");
  }

  // Overclosures on both sides of each node, and between them, with the inverse of their pressures.
  void draw_curve(const rc_law* law, Random& random) {
    std::vector<double> xs;
    for (std::int64_t i = 0; i + 1 < info_.nodes; ++i) {
      rc_law_point node = RC_LAW_POINT_INIT, next = RC_LAW_POINT_INIT;
      pairs::check(rc_law_describe_node(law, i, &node) == RC_OK && rc_law_describe_node(law, i + 1, &next) == RC_OK,
                   rc_last_error());
      for (const double x : {std::nextafter(node.x, 0), node.x, std::nextafter(node.x, HUGE_VAL)}) xs.push_back(x);
      xs.push_back(random.uniform(node.x, next.x));
    }
    std::erase_if(xs, [&](double x) { return !(x > 1e-300 && x <= info_.x_upper); });
    std::ranges::sort(xs);
    for (const double x : xs) {
      const rc_law_point point = evaluated(law, x);
      CurvePoint at{x, point.p, point.slope, 0, 0, point.p_lower, point.p_upper};
      pairs::check(rc_law_overclosure(law, at.p, &at.back) >= 0, rc_last_error());
      at.p_back = evaluated(law, at.back).p;
      curve_.push_back(at);
    }
  }

  // The curve rises without jumps, inside its own bounds, and its inverse has the same pressure.
  void judge_curve() const {
    constexpr double eps = std::numeric_limits<double>::epsilon();
    CurvePoint before;
    for (const CurvePoint& at : curve_) {
      const auto fails = [&](const char* what) { throw pairs::Failure(std::string(what) + " at " + number(at.x)); };
      if (at.p < before.p * (1 - eps)) fails("the pressure falls");
      if (at.x == std::nextafter(before.x, HUGE_VAL) &&
          at.p - before.p > 16 * eps * at.p + 4 * std::max(at.slope, before.slope) * (at.x - before.x))
        fails("the pressure jumps");
      // Near 0 the rounding of p_lower is not relative to p.
      if ((at.x >= info_.x_lower || at.p > 1e-3 * info_.p_lower) &&
          std::max(at.p_lower - at.p, at.p - at.p_upper) > 1e-13 * (at.p + info_.p_lower))
        fails("the pressure leaves its own bounds");
      if (std::abs(at.p_back - at.p) > 16 * eps * at.p + 8 * eps * at.slope * at.back) fails("the inverse has another pressure");
      before = at;
    }
  }

  // The slopes on both sides of each node between two others and beyond the first, but for chords without the bounds CONVEX.
  void draw_joints(const rc_law* law) {
    const rc_law_point none = RC_LAW_POINT_INIT;
    std::vector<rc_law_point> nodes(static_cast<std::size_t>(info_.nodes), none);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      pairs::check(rc_law_describe_node(law, static_cast<std::int64_t>(i), &nodes[i]) == RC_OK, rc_last_error());
    const auto before = [](double x) { return std::nextafter(x, 0); };
    const auto slope = [law](double x) { return evaluated(law, x).slope; };
    const auto chord = [&](const rc_law_point& node, const rc_law_point& next) {
      const double length = next.x - node.x, rise = (next.p - node.p) / length;
      const auto rises = [&](double x) { return std::abs(slope(x) - rise) <= 1e-9 * rise; };
      return node.bounds != RC_LAW_CONVEX && rises(node.x) && rises(node.x + length / 3) && rises(before(next.x));
    };
    for (std::size_t i = 2; i + 1 < nodes.size(); ++i) {
      const rc_law_point &node = nodes[i], &last = nodes[i - 1], &next = nodes[i + 1];
      if (chord(last, node) || chord(node, next)) continue;
      const double widths = last.p_upper - last.p_lower + node.p_upper - node.p_lower + next.p_upper - next.p_lower;
      joints_.push_back({node.x, slope(before(node.x)), slope(node.x), node.p / node.x, widths});
    }
  }

  // Whether the exact curve has a kink at the node, as near as law.h says.
  bool has_kink(const Joint& joint, const Case& c) const {
    const double rounding = 4e-16 * (std::abs(lowest_) + mean_gap_ + joint.x);
    const double near = 1e-9 * joint.x + joint.uncertain / std::abs(joint.right - joint.left) + rounding;
    const auto less = truth_by(c, joint.x - near), more = truth_by(c, joint.x + near);
    return !less || !more || !less->smooth || !more->smooth || std::abs(more->slope - less->slope) > 1e-9L * less->slope;
  }

  void judge_joint(const Joint& joint, const Case& c) const {
    constexpr double rounding = 1e-6;  // of slopes
    if (std::abs(joint.right - joint.left) < rounding * std::max({joint.left, joint.right, joint.secant})) return;
    need(has_kink(joint, c),
         "the slope jumps at " + number(joint.x) + " from " + number(joint.left) + " to " + number(joint.right));
  }

  // Nothing is said of slip that yields, or whose stiffness is not known.
  static void need_no_slip(const rc_law* law) {
    rc_law_slip_state state = RC_LAW_SLIP_STATE_INIT;
    const double slip[2] = {};
    need(rc_law_slip(law, &state, 0, slip, &state) == RC_ERR_INCOMPATIBLE, "slip of a law that has none");
  }

  // Slip at the overclosure of each truth, until what is left of the shear is that of a smaller one.
  void slip(const rc_law* law) {
    for (std::size_t i = 0; i < truths_.size(); ++i)
      for (std::size_t j = 0; j < truths_.size(); ++j) {
        if (!(truths_[j].x < truths_[i].x)) continue;
        rc_law_slip_state state = RC_LAW_SLIP_STATE_INIT;
        state.mu = mu, state.nu = 0.3;
        const double none[2] = {},
                     slip[2] = {mu * (2 - 0.3) / (2 - 2 * 0.3) * static_cast<double>(truths_[i].x - truths_[j].x), 0};
        double lower[2], upper[2];
        for (const double* each : {none, slip})
          pairs::check(rc_law_slip(law, &state, static_cast<double>(truths_[i].x), each, &state) >= 0, rc_last_error());
        if (rc_law_slip_bounds(law, &state, lower, upper) != RC_OK) continue;
        const double rounding = 1e-8 * mu * state.p;
        need(lower[0] <= state.shear[0] + rounding && state.shear[0] <= upper[0] + rounding && lower[1] == 0 && upper[1] == 0,
             "the law's own shear " + number(state.shear[0]) + ", " + number(state.shear[1]) + " is not in " + number(lower[0]) +
                 " .. " + number(upper[0]));
        slips_.push_back({i, j, lower[0], upper[0]});
      }
  }

  void reload(const rc_law* law) {
    std::random_device random;
    const auto path =
        (std::filesystem::temp_directory_path() / ("scenes-" + std::to_string(random()) + std::to_string(random()) + ".law"))
            .string();
    pairs::check(rc_law_save(law, path.c_str()) == RC_OK, rc_last_error());
    rc_law* made = nullptr;
    const rc_status status = rc_law_load(path.c_str(), &made);
    std::filesystem::remove(path);
    const LawHandle loaded(made);
    pairs::check(status == status_ && made, std::string("rc_law_load: ") + rc_last_error());
    for (const rc_law_point& said : said_) loaded_.push_back(evaluated(made, said.x));
    rc_law_info again = RC_LAW_INFO_INIT;
    pairs::check(rc_law_describe(made, &again) == RC_OK && again.seconds == 0, "a file has no seconds");
    again.seconds = info_.seconds;
    pairs::check(std::memcmp(&again, &info_, sizeof again) == 0, "the loaded law describes itself otherwise");
    rc_law_point beyond = RC_LAW_POINT_INIT;
    pairs::check(rc_law_evaluate(law, 1e6 * info_.x_upper, &beyond) >= 0, rc_last_error());
    highest_ = beyond.p_lower;
  }

  LawHandle law_;
  rc_law_info info_{};
  rc_status status_ = RC_ERR_INTERNAL;
  std::string message_;
  double lowest_ = 0, mean_gap_ = 0, tolerance_ = 0;
  double highest_ = 0;  // the lower bound of p far beyond the last node
  bool mean_ = false;
  static constexpr double mu = 0.4;
  struct Slip {
    std::size_t high, low;
    double lower, upper;
  };
  std::vector<Slip> slips_;
  struct CurvePoint {
    double x = 0, p = 0, slope = 0, back = 0, p_back = 0, p_lower = 0, p_upper = 0;
  };
  std::vector<LawTruth> truths_;
  std::vector<Joint> joints_;
  std::vector<CurvePoint> curve_;
  std::vector<rc_law_point> said_, loaded_;
};

// Deflections under pressures of both signs.
class AsProduct final : public Property {
 public:
  std::string ask(const Case& c) override {
    const std::size_t n = c.scene().points();
    Random random(c.scene().seed, 900);
    const double size = random.decades(-3, 3);
    for (std::size_t i = 0; i < n; ++i) v_.push_back(random.chance(0.3) ? 0 : size * random.uniform(-1, 1));
    rc_product* made = nullptr;
    if (rc_product_create(&c.system(), c.options({{"tol", "1e-8"}}).get(), &made) != RC_OK) return "the backend has no product";
    u_.assign(n, 0);
    status_ = rc_product_apply(made, RC_IN(v_.data()), RC_OUT(u_.data()));
    rc_product_destroy(made);
    return "";
  }
  Verdict judge(const Case& c) const override {
    need(status_ == RC_OK, rc_status_name(status_));
    const Real relative = c.pair().backend == "split" ? split_product : double_product;
    const Real allowed = relative * c.h().largest_row() * static_cast<Real>(pairs::largest(v_));
    Random random(c.scene().seed, 901);
    const std::size_t n = v_.size();
    for (std::size_t tried = 0; tried < std::min<std::size_t>(n, 100); ++tried) {
      const std::size_t i = n <= 100 ? tried : static_cast<std::size_t>(random.below(static_cast<std::int64_t>(n)));
      Real sum = 0;
      for (std::size_t j = 0; j < n; ++j)
        if (v_[j] != 0) sum += c.h()(i, j) * static_cast<Real>(v_[j]);
      need(std::abs(static_cast<Real>(u_[i]) - sum) <= allowed, "the deflection is off by " +
                                                                    number(static_cast<Real>(u_[i]) - sum) + ", allowed " +
                                                                    number(allowed) + ", at point " + std::to_string(i));
    }
    return Verdict::held;
  }
  bool spoil(const Case& c, Random& random) override {
    if (v_.size() > 100) return false;
    const auto i = static_cast<std::size_t>(random.below(static_cast<std::int64_t>(u_.size())));
    u_[i] += static_cast<double>(3 * double_product * c.h().largest_row()) * pairs::largest(v_);
    return pairs::largest(v_) > 0;
  }

 private:
  Field v_, u_;
  rc_status status_ = RC_ERR_INTERNAL;
};

constexpr std::array kinds_of_laws{Kind{"law", 8, 5, 0.2, 0, made<AsLaw>}, Kind{"product", 4, 2, 0.8, 0, made<AsProduct>}};

}  // namespace

std::span<const Kind> properties_of_laws() { return kinds_of_laws; }

}  // namespace scenes
