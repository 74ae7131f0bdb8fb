#include "contact/proof/bounds.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "contact/surface/points_below.h"
#include "core/limits.h"
#include "kernel/semi_periodic.h"

namespace rc {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double product_error = 4;   // round-off of a product, in units of epsilon log2(n) times its size
constexpr int most_bound_rounds = 3;  // each leaves out the points that the round before proved open

double square(double x) { return x * x; }

// The bound |sum of x| <= by_distance |x|_H + by_work x'w.
struct SumBound {
  double by_distance = infinity, by_work = 0;
};

// How far the given pressures are from the exact ones: x = p - p*.
struct Distance {
  double energy = infinity;  // f(p) - f(p*) is at most this
  double norm = infinity;    // |x|_H = sqrt(x'Hx)
  double sum = infinity;     // |sum of x|

  void tighten(const Distance& other) {
    energy = std::min(energy, other.energy);
    norm = std::min(norm, other.norm);
    sum = std::min(sum, other.sum);
  }
};

// In units of length_ and of the dimensionless operator: p = the given p between 0 and the hardness, u = d - h, w = H p - u.
// docs/development/derivation.md has the derivation.
class Proof {
 public:
  Proof(const System& system, const Spectrum& spectrum, const StepSurface& surface, double compression, const Deflected& answer,
        const Survey& found)
      : system_(system),
        spectrum_(spectrum),
        surface_(surface),
        compression_(compression),
        rounding_(surface.range().included > 0 ? rounding_of(surface.lowest(), compression) + surface.range().rounding : 0),
        answer_(answer),
        found_(found),
        given_(answer.p()),
        product_(answer.product) {
    candidates_ = extent_below(system_.positive ? limit() : infinity, surface_);
    // Answers that list the points below the compression may lack those that only rounded gaps put above it.
    const double rounding = surface_.range().rounding, beyond = answer.beyond;
    const auto listed = [&] { return extent_below(surface_.range().limit_of(compression_), surface_).n; };
    if (!all_listed()) beyond_ = beyond == infinity && rounding > 0 && listed() < candidates_.n ? 0 : beyond;
    measure();
    residual();
  }

  Bounds bounds(ProvenSets* sets) {
    Bounds result;
    if (!std::isfinite(delta_square_ + doubt_)) return result;
    Extent support = undecided_pressures();  // no proof yet
    SumBound sum_bound = system_.periodic() ? better(sum_bound_below_mean(), sum_bound_of(support)) : sum_bound_of(support);
    for (int round = 0; round < most_bound_rounds; ++round) {
      distance_.tighten(distance(sum_bound, support, beta_, 0));
      distance_.tighten(distance_without_stray(sum_bound, support));
      const double before = points_of(support);
      support = undecided_pressures();
      sum_bound = sum_bound_of(support);
      distance_.sum = std::min(distance_.sum, sum_bound.by_distance * distance_.norm);
      if (points_of(support) > 0.9 * before) break;
    }
    if (const double reach = open_beyond(); reach < infinity) result.gap_error = reach;
    count(result, sets);
    convert(support, result);
    return result;
  }

 private:
  double n() const { return static_cast<double>(system_.points()); }
  bool all_listed() const { return static_cast<std::int64_t>(given_.size()) == surface_.points().count(); }
  static double rounding_of(double lowest, double compression) { return std::abs(lowest + compression - lowest - compression); }
  static double points_of(const Extent& support) { return static_cast<double>(support.n); }

  // Quantities at point i of the list.
  double height(std::size_t i) const { return surface_.height(answer_.point(i)); }
  bool included(std::size_t i) const { return surface_.included(answer_.point(i)); }
  double given(std::size_t i) const { return given_[i] * system_.length_per_pressure / length_; }
  double cap() const { return system_.hardness * system_.length_per_pressure / length_; }
  double p(std::size_t i) const { return std::min(std::max(0.0, given(i)), cap()); }
  double u(std::size_t i) const { return (compression_ - height(i)) / length_; }
  double w(std::size_t i) const { return distance_to_surface(i) / length_; }
  double distance_to_surface(std::size_t i) const { return product_[i] - (compression_ - height(i)); }  // [length]
  // If H has no negative entries, p*_i > 0 needs u_i = (H p*)_i > 0. Points with u_i = 0 carry nothing either, but do at any
  // larger approach: they are not counted as open.
  bool may_carry(std::size_t i) const { return included(i) && (!system_.positive || deepest() >= height(i)); }
  // [length] Heights above this carry nothing. The gap, the approach, and this sum, are rounded.
  double deepest() const { return compression_ + 4 * surface_.range().rounding; }
  double limit() const { return surface_.range().limit_of(deepest()); }

  // Sizes, and doubt_, a bound of the error of every w_i: round-off of the product, of the approach as it is returned and of the
  // indented gap, and the product of the pressures below 0 and above the hardness that were cut off (no entry of H is larger than
  // its largest diagonal entry).
  void measure() {
    const double largest_product = found_.largest_product;
    double largest_w = found_.largest_gap;
    if (!all_listed()) largest_w = std::max(largest_w, largest_product + std::abs(surface_.range().width() - compression_));
    const bool none = surface_.range().included == 0;
    const double depth = none ? 0 : std::max(0.0, compression_ + rounding_);
    if (depth + largest_product > 0) length_ = depth + largest_product;
    depth_ = depth / length_;
    largest_w_ = largest_w / length_;

    const Sizes sizes = sum_of_touching<Sizes>([&](Sizes& part, std::size_t i) {
      if (given_[i] == 0) return;
      part.negative += std::max({0.0, -given(i), given(i) - cap()});
      part.p_square += square(p(i));
      part.sum += p(i);
    });
    negative_ = sizes.negative;
    const double p_square = sizes.p_square;
    sum_ = static_cast<double>(sizes.sum);
    const double largest_u = none ? 0 : std::max(depth, surface_.range().width() - compression_) / length_;
    double size = largest_product / length_ + largest_u + std::sqrt(p_square) + negative_;
    if (system_.periodic()) size += system_.bounds.lambda_most * sum_ / n();  // load control shifts the datum of H by this much
    doubt_ = product_error * epsilon * std::log2(n() + 1) * size + rounding_ / length_ + spectrum_.diagonal * negative_;
  }

  // x'w <= beta + delta'x: a point with w > 0 adds at most w p, so one with w >= 0 and p = 0 adds nothing; likewise one with
  // w < 0 at most -w (cap - p).
  void residual() {
    const Residuals found = sum_of_touching<Residuals>([&](Residuals& part, std::size_t i) {
      if (!included(i) || !(given_[i] > 0 || distance_to_surface(i) < 0)) return;
      const double wi = w(i), pi = p(i), room = cap() - pi;
      if (!may_carry(i) || (wi > 0 && 2 * spectrum_.lowest * pi < wi)) {  // then w p < w^2 / (2 lowest)
        part.beta += (std::max(0.0, wi) + doubt_) * pi;
        part.stray += pi;
      } else if (wi < 0 && 2 * spectrum_.lowest * room < -wi) {
        part.beta += (doubt_ - wi) * room;
        part.stray += room;
      } else {
        part.delta_sum += wi;
        part.delta_square += square(wi);
      }
      part.work += std::abs(product_[i] / length_ * pi) + std::abs(u(i)) * pi;
    });
    beta_ = found.beta;
    stray_ = found.stray;
    delta_sum_ = found.delta_sum;
    delta_square_ = found.delta_square;
    work_ = found.work;
  }

  // Sums over the points that touch, in their order; piece by piece if processes share the rows.
  template <class Part, class Add> Part sum_of_touching(const Add& add) const {
    return surface_.points().sum_over<Part>(std::span<const std::size_t>(found_.touching), add);
  }
  struct Sizes {
    double negative = 0, p_square = 0;
    long double sum = 0;
    Sizes operator+(const Sizes& b) const { return {negative + b.negative, p_square + b.p_square, sum + b.sum}; }
  };
  struct Residuals {
    double beta = 0, stray = 0, delta_sum = 0, delta_square = 0, work = 0;
    Residuals operator+(const Residuals& b) const {
      return {beta + b.beta, stray + b.stray, delta_sum + b.delta_sum, delta_square + b.delta_square, work + b.work};
    }
  };

  // Gaps are this near to the exact ones, since |(Hx)_i| <= |x|_H sqrt(H_ii): points with a larger gap are open.
  double open_beyond() const { return (distance_.norm * std::sqrt(spectrum_.diagonal) + doubt_) * length_; }

  // Points that were given a pressure, or may carry one and are not proven open, without those that were given the hardness and
  // are proven to have it. Outside this set x is 0.
  Extent undecided_pressures() {
    const double reach = open_beyond();
    if (!(reach < beyond_))  // any candidate
      return candidates_ + surface_.points().combined_over<Extent>(found_.touching, [&](Extent& support, std::size_t i) {
        if (given_[i] > 0 && !may_carry(i)) add(support, i);
      });
    return surface_.points().combined_over<Extent>(near(reach), [&](Extent& support, std::size_t i) {
      if (undecided(i, reach)) add(support, i);
    });
  }
  // At least the points that were given a pressure, and those that may carry one and are no farther than `reach`. That never
  // grows, so the first list also serves later calls.
  const std::vector<std::size_t>& near(double reach) {
    if (near_) return *near_;
    const auto size = static_cast<std::int64_t>(given_.size());
    Marks marks(size);
    each_chunk(size, surface_.points().team(), [&](std::int64_t begin, std::int64_t count) {
      mark_near(surface_, answer_.on(), product_, compression_, reach, begin, count, marks);
      const std::vector<std::size_t>& touching = found_.touching;
      auto at = std::lower_bound(touching.begin(), touching.end(), static_cast<std::size_t>(begin));
      for (; at != touching.end() && *at < static_cast<std::size_t>(begin + count); ++at)
        if (given_[*at] > 0) marks.add(*at);
    });
    near_ = marks.list();
    return *near_;
  }
  bool undecided(std::size_t i, double reach) const {
    if (given_[i] >= system_.hardness && distance_to_surface(i) < -reach) return false;
    return given_[i] > 0 || (may_carry(i) && distance_to_surface(i) <= reach);
  }
  void add(Extent& support, std::size_t i) const {
    const auto point = static_cast<std::int64_t>(answer_.point(i));
    support.add(point % system_.unit.nx, surface_.points().rows().first() + point / system_.unit.nx);
  }
  // Diagonal of the bounding box of the support's cells.
  double diagonal(const Extent& support) const {
    return std::hypot(static_cast<double>(support.width()) * system_.unit.hx,
                      static_cast<double>(support.height()) * system_.unit.hy);
  }

  double rigid(const Extent& support) const {
    if (!system_.semi_periodic() || support.n == 0) return diagonal(support);
    const bool along_x = system_.unit.boundary == RC_BOUNDARY_PERIODIC_X;
    const std::int64_t across = along_x ? support.height() : support.width();
    const kernel::Strip strip = kernel::strip_of(system_.unit);
    return kernel::punch_stiffness(strip, static_cast<double>(across) * strip.h_across);
  }

  // (sum of x)^2 <= 1'H^-1 1 x'Hx on the support.
  double flat_punch(const Extent& support) const {
    double least = points_of(support) / spectrum_.lowest;
    if (spectrum_.flat_punch > 0) least = std::min(least, spectrum_.flat_punch);
    // With the kernel galerkin a flat punch on cells is no stiffer than a disc around them, whose stiffness is its diameter; on a
    // grid that repeats along one axis, than a strip around them.
    if (spectrum_.galerkin_share > 0) least = std::min(least, rigid(support) / spectrum_.galerkin_share);
    return least;
  }

  SumBound sum_bound_of(const Extent& support) const {
    if (!system_.periodic()) return {std::sqrt(flat_punch(support)), 0};
    // x is 0 off the support, so x less its mean has the size of the mean there.
    const double free = n() - points_of(support);
    return {free > 0 ? std::sqrt(points_of(support) * n() / (free * spectrum_.lowest)) : infinity, 0};
  }

  struct Energies {
    double ep = 0, php = 0;
    Energies operator+(const Energies& b) const { return {ep + b.ep, php + b.php}; }
  };
  // Periodic, no mask, d off the mean plane (above it the pressures need a cap): with e = u + eps of mean 0 and H q = e,  eps
  // sum(x) = x'H(q - p) + x'w.
  SumBound sum_bound_below_mean() const {
    if (!surface_.range().whole) return {};
    const double mean = surface_.moments().mean, square_sum = surface_.moments().square;
    const double mean_gap = mean - compression_, off = system_.capped() ? std::abs(mean_gap) : mean_gap;
    const double eps = (off - rounding_ - epsilon * (100 + n() / 512) * surface_.range().width()) / length_;
    if (!(eps > 0)) return {};
    // Gaps that are rounded by at most E move e by at most sqrt(n) E, and each e_i by 2 E.
    const double rounding = surface_.range().rounding;
    const double e_square = (square_sum + rounding * (2 * std::sqrt(n() * square_sum) + n() * rounding)) / square(length_);
    const auto [ep, php] = sum_of_touching<Energies>([&](Energies& part, std::size_t i) {
      if (!(given_[i] > 0)) return;
      part.ep += (mean - height(i)) / length_ * p(i);
      part.php += product_[i] / length_ * p(i);
    });
    const double doubt = (doubt_ + 4 * rounding / length_) * sum_ + epsilon * n() * (e_square / spectrum_.lowest + work_);
    return {std::sqrt(std::max(0.0, e_square / spectrum_.lowest - 2 * ep + php) + doubt) / eps, 1 / eps};
  }
  static SumBound better(const SumBound& a, const SumBound& b) { return a.by_distance < b.by_distance ? a : b; }

  // |x|_H^2 <= x'w <= beta + R |x|_H + a x'w; R and a follow from delta's mean c and from the rest of delta.
  Distance distance(const SumBound& sum_bound, const Extent& support, double beta, double stray) const {
    const double root = std::sqrt(spectrum_.lowest), points = system_.periodic() ? n() : points_of(support);
    const double noise = doubt_ * std::sqrt(points);
    const double c = points > 0 ? std::abs(delta_sum_) / points + doubt_ : 0, a = c * sum_bound.by_work;
    const double rest = std::sqrt(std::max(0.0, delta_square_ - square(delta_sum_) / std::max(points, 1.0))) + noise;
    double R = (rest + 1e-8 * std::sqrt(delta_square_)) / root + c * sum_bound.by_distance;
    if (const double plain = (std::sqrt(delta_square_) + noise) / root; !system_.periodic()) R = std::min(R, plain);
    if (!(a < 1 && R < infinity)) return {};
    R = (R + stray) / (1 - a);
    beta /= 1 - a;
    Distance result;
    result.energy = beta + square(R) / 2;
    result.norm = (R + std::sqrt(square(R) + 4 * beta)) / 2;
    result.sum = sum_bound.by_distance * result.norm + sum_bound.by_work * (beta + R * result.norm);
    return result;
  }

  // Another bound: takes the pressures y of the points in beta out of p. That changes H p by H y, whose dual norm is |y|_H <=
  // sum(y) sqrt(max H_ii); R alone bounds the rest. It is of first order in y, where sqrt(beta) is of order 1/2.
  Distance distance_without_stray(SumBound sum_bound, const Extent& support) const {
    const double norm = stray_ * std::sqrt(spectrum_.diagonal);
    sum_bound.by_distance += norm * sum_bound.by_work;
    Distance result = distance(sum_bound, support, 0, norm);
    result.energy = infinity;
    result.norm += norm;
    result.sum += stray_;
    return result;
  }

  struct Counts {
    std::int64_t contacts = 0, capped = 0, undecided = 0;
    Counts operator+(const Counts& b) const { return {contacts + b.contacts, capped + b.capped, undecided + b.undecided}; }
  };
  void count(Bounds& result, ProvenSets* sets) {
    const double mean = system_.periodic() ? distance_.sum / n() : 0;
    const double margin = distance_.norm / std::sqrt(spectrum_.lowest) + mean;
    const double reach = open_beyond();
    const auto not_open = [&](std::size_t i) { return may_carry(i) && !(distance_to_surface(i) > reach); };
    const auto at_cap = [&](std::size_t i) { return distance_to_surface(i) < -reach; };
    auto [contacts, capped, undecided] = surface_.points().combined_over<Counts>(near(reach), [&](Counts& part, std::size_t i) {
      if (!not_open(i)) return;
      part.capped += at_cap(i);
      ++(p(i) > margin || at_cap(i) ? part.contacts : part.undecided);
    });
    for (const std::size_t i : sets ? std::span<const std::size_t>(near(reach)) : std::span<const std::size_t>()) {
      if (!not_open(i) || at_cap(i)) continue;
      sets->possible.push_back(static_cast<std::int64_t>(answer_.point(i)));
      if (p(i) > margin && cap() - p(i) > margin) sets->contacts.push_back(sets->possible.back());
    }
    if (!all_listed() && !(reach < beyond_)) {
      undecided += candidates_.n;
      for (std::size_t i = 0; i < given_.size(); ++i) undecided -= may_carry(i);
      if (sets && system_.positive) list(points_below(limit(), surface_), sets->possible);
      if (sets) sets->listed = system_.positive;
    }
    result.proven_contacts = contacts;
    result.proven_open = system_.points() - contacts - undecided;
    result.undecided = undecided;
    result.proven_capped = capped;
    result.area_lower = static_cast<double>(contacts) * system_.cell_area();
    result.area_upper = static_cast<double>(contacts + result.undecided) * system_.cell_area();
  }

  static void list(const TrialSet& trial, std::vector<std::int64_t>& points) {
    points.clear();
    for (std::int64_t i = 0; i < trial.n; ++i) points.push_back(trial.point(i));
  }

  void convert(const Extent& support, Bounds& result) const {
    // Multiplies one factor after the other: the product of the factors may underflow where the load does not.
    const double pressure = length_ / system_.length_per_pressure, area = system_.cell_area();
    const double sum_error = distance_.sum + 4 * epsilon * sum_;
    double least = sum_ - sum_error, most = sum_ + sum_error;
    if (system_.capped()) {  // a sum of n equal pressures rounds by about sqrt(n) epsilon
      const double rounding = (4 + std::sqrt(n())) * epsilon;
      const std::int64_t may = result.proven_contacts + result.undecided;
      least = std::max(least, cap() * static_cast<double>(result.proven_capped) * (1 - rounding));
      most = std::min(most, cap() * static_cast<double>(may) * (1 + rounding));
    }
    if (!system_.periodic() && result.proven_capped == 0)
      most = std::min(most, flat_punch(support) * depth_ * (1 + 4 * epsilon));  // p*'Hp* = u'p*
    result.load_lower = std::max(0.0, least) * pressure * area;
    result.load_upper = most < infinity ? most * pressure * area : infinity;
    if (distance_.energy == infinity) return;
    // Adds what the negative pressures change, and the round-off of the energy itself.
    const double energy = distance_.energy + negative_ * (largest_w_ + doubt_ + spectrum_.diagonal * negative_) + doubt_ * sum_ +
                          (4 + std::sqrt(n())) * epsilon * work_;
    result.duality_gap = energy * length_ * pressure * area;
  }

  const System& system_;
  const Spectrum& spectrum_;
  const StepSurface& surface_;
  const double compression_;
  const double rounding_;  // [length] round-off of the approach, which is the lowest gap plus the compression, and of the gap
  const Deflected& answer_;
  const Survey& found_;
  const std::span<const double> given_, product_;
  Extent candidates_;                                               // points that may carry pressure
  double beyond_ = infinity;                                        // [length] the points not listed have larger gaps
  double length_ = 1, depth_ = 0;                                   // [length]; largest penetration
  double sum_ = 0, negative_ = 0, largest_w_ = 0, doubt_ = 0;       // sum of p; of the negative p; largest |w|; error of w_i
  double beta_ = 0, stray_ = 0, delta_sum_ = 0, delta_square_ = 0;  // see residual(); stray: the pressures in beta
  double work_ = 0;                                                 // p'|Hp| + p'|u|
  Distance distance_;
  std::optional<std::vector<std::size_t>> near_;
};

}  // namespace

Bounds prove_bounds(const System& system, const Spectrum& spectrum, const StepSurface& surface, double compression,
                    const Deflected& answer, const Survey& found, ProvenSets* sets) {
  if (!(spectrum.lowest > 0)) return {};
  return Proof(system, spectrum, surface, compression, answer, found).bounds(sets);
}

}  // namespace rc
