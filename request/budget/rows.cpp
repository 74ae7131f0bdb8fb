// The contribution of each source to each quantity, by solves of a changed problem.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "request/budget/budget.h"

namespace rc::request {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const double rectangular = 1 / std::numbers::sqrt3;  // the standard deviation of a uniform distribution over its half-width

double deviation(const std::vector<Outcome>& samples, std::size_t q, double& mean) {
  mean = 0;
  for (const Outcome& each : samples) mean += each[q] / static_cast<double>(samples.size());
  double sum = 0;
  for (const Outcome& each : samples) sum += (each[q] - mean) * (each[q] - mean);
  return std::sqrt(sum / static_cast<double>(samples.size() - 1));
}

class Rows {
 public:
  Rows(const rc_request_spec& spec, const rc_budget_spec& budget, const rc_request& base, const Sources& sources)
      : spec_(spec),
        budget_(budget),
        base_(base),
        sources_(sources),
        progress_{budget, 0, sources.solves()},
        of_gap_(map_of(spec, "gap") != nullptr),
        problem_(pressing(base, of_gap_)),
        press_(problem_.system, options(base, true).get(), progress_) {}

  std::vector<Row> all(Outcome& value) {
    value = value_ = press_.solve(problem_, "the contact itself");
    const rc_result proven = press_.result();
    further_half_ = press_.further_half();
    std::vector<Row> rows;
    for (const Source& each : sources_.all)
      if (each.kind == Kind::noise) first_order(each);
    samples_of_base_ = std::make_unique<Press>(problem_.system, options(base_, false).get(), progress_);
    for (const Source& each : sources_.all) rows.push_back(each.kind == Kind::solver ? solver(proven) : row(each));
    return rows;
  }

 private:
  Options options(const rc_request& request, bool proven) const { return options_of(budget_, spec_.context, request, proven); }

  Row row(const Source& source) {
    switch (source.kind) {
      case Kind::noise:
        return noise(source);
      case Kind::shift:
        return shift(source);
      case Kind::window:
        return window(source);
      case Kind::maps:
        return maps(source);
      case Kind::grid:
        return grid();
      case Kind::bandwidth:
      case Kind::remove:
      case Kind::missing:
        return alternative(source);
      default:
        return slope(source);
    }
  }

  // The problem with a change, solved by a contact of its own.
  Outcome changed(const Source& source, const Variation& variation) {
    return alone(*made(spec_, variation), named(source).c_str());
  }

  Outcome alone(const rc_request& request, const char* what) {
    const Pressing problem = pressing(request, of_gap_);
    Press press{problem.system, options(request, false).get(), progress_};
    return press.solve(problem, what);
  }

  static std::string named(const Source& source) { return join("source ", source.name); }

  Row slope(const Source& source) {
    Outcome ends[2];
    for (const int k : {0, 1}) {
      const double factor = k == 0 ? 1 - source.size : 1 + source.size;
      Variation variation;
      if (source.kind == Kind::pitch) variation.pitch = factor;
      if (source.kind == Kind::height) variation.height = factor;
      if (source.kind == Kind::word) variation.factor = {source.name, factor};
      ends[k] = changed(source, variation);
    }
    Row found;
    for (std::size_t q = 0; q < of::count; ++q) found[q].standard = std::abs(ends[1][q] - ends[0][q]) / 2;
    return found;
  }

  Row alternative(const Source& source) {
    Variation variation;
    if (source.kind == Kind::bandwidth) variation.cutoff = source.size;
    if (source.kind == Kind::remove) variation.replaced = {"remove", source.value.c_str()};
    if (source.kind == Kind::missing) variation.replaced = {"missing", source.value.c_str()};
    const Outcome other = changed(source, variation);
    Row found;
    for (std::size_t q = 0; q < of::count; ++q) found[q].standard = std::abs(other[q] - value_[q]) * rectangular;
    return found;
  }

  Row sampled(const std::vector<Outcome>& samples, bool shifts) const {
    Row found;
    for (std::size_t q = 0; q < of::count; ++q) {
      double mean = 0;
      found[q].standard = found[q].sampled = deviation(samples, q, mean);
      found[q].freedom = static_cast<double>(samples.size() - 1);
      if (shifts) found[q].shift = mean - value_[q];
    }
    return found;
  }

  // By derivatives of the last solve.
  void first_order(const Source& source) {
    first_.fill(nan);
    const bool by_approach = problem_.control == RC_CONTROL_APPROACH;
    for (const bool of_mean_gap : {false, true}) {
      std::vector<double> slopes = press_.derivative(problem_, of_mean_gap);
      if (slopes.empty()) continue;
      correlate(problem_.grid(), source.correlation, slopes);
      double sum = 0;
      for (const double each : slopes) sum += each * each;
      first_[of_mean_gap ? of::mean_gap : by_approach ? of::load : of::approach] = source.size * std::sqrt(sum);
    }
    if (by_approach) first_[of::mean_pressure] = first_[of::load] * value_[of::mean_pressure] / value_[of::load];
  }

  Row noise(const Source& source) {
    Normal normal{sources_.seed};
    const Extent extent = problem_.grid();
    std::vector<Outcome> samples;
    std::vector<double> field(extent.points());
    for (std::int64_t k = 0; k < sources_.samples; ++k) {
      for (double& each : field) each = normal();
      correlate(extent, source.correlation, field);
      Pressing noisy = problem_;
      for (std::size_t i = 0; i < field.size(); ++i) noisy.z[i] += source.size * field[i];
      samples.push_back(samples_of_base_->solve(noisy, named(source).c_str()));
    }
    Row found = sampled(samples, true);
    // Samples know a standard deviation to 1/sqrt(2 (n - 1)). The derivative is nearer if it is within twice that.
    const double known = 2 / std::sqrt(2 * static_cast<double>(samples.size() - 1));
    for (std::size_t q = 0; q < of::count; ++q) {
      Contribution& each = found[q];
      each.first_order = first_[q];
      if (!(std::abs(each.sampled - first_[q]) <= known * first_[q])) continue;
      each.standard = first_[q];
      each.freedom = std::numeric_limits<double>::infinity();
    }
    return found;
  }

  Row shift(const Source& source) {
    Normal places{sources_.seed + 1};
    const Extent extent = problem_.grid();
    const auto cells = [&](double h, std::int64_t n) {
      const std::int64_t most = std::llround(source.size / h);
      return most >= n / 2 ? places.integer(n) : places.integer(most);
    };
    std::vector<Outcome> samples;
    for (std::int64_t k = 0; k < sources_.samples; ++k) {
      Variation variation;
      variation.cells_x = cells(extent.hx, extent.nx);
      variation.cells_y = cells(extent.hy, extent.ny);
      samples.push_back(changed(source, variation));
    }
    return sampled(samples, false);
  }

  Row window(const Source& source) {
    const auto parts = static_cast<std::int64_t>(source.size);
    const double share = 1 / (source.size * source.size);
    std::vector<Outcome> samples;
    std::unique_ptr<Press> press;
    for (std::int64_t k = 0; k < parts * parts; ++k) {
      Extent extent{};
      Pressing part = problem_;
      part.z = part_of(problem_.grid(), problem_.z, parts, k % parts, k / parts, extent);
      part.datum = problem_.datum.value_or(problem_.highest());
      part.system.nx = extent.nx;
      part.system.ny = extent.ny;
      if (part.control == RC_CONTROL_LOAD || part.control == RC_CONTROL_AREA) part.target *= share;
      if (!press) press = std::make_unique<Press>(part.system, options(base_, false).get(), progress_);
      Outcome found = press->solve(part, named(source).c_str());
      for (const std::size_t q : {of::load, of::stiffness, of::conductance}) found[q] /= share;
      samples.push_back(found);
    }
    Row found = sampled(samples, false);
    for (Contribution& each : found) each.standard = each.sampled = each.standard / source.size;
    return found;
  }

  // The map itself and others as large. Not divided: the value is that of one map, which stands for the surface.
  Row maps(const Source& source) {
    std::vector<std::unique_ptr<rc_request>> others;  // all are read before the first is solved
    for (std::int64_t k = 0; k < solves_of(source, 0); ++k) {
      const char* const file = source.files.empty() ? nullptr : source.files[static_cast<std::size_t>(k)].c_str();
      others.push_back(other_map({.replaced = {"surface", file}, .surface = file ? nullptr : map_of(spec_, "maps", k)},
                                 join(named(source), ", map ", k + 1)));
    }
    std::vector<Outcome> samples{value_};
    for (const auto& each : others) samples.push_back(alone(*each, named(source).c_str()));
    return sampled(samples, false);
  }

  std::unique_ptr<rc_request> other_map(const Variation& variation, const std::string& where) const {
    std::unique_ptr<rc_request> other;
    try {
      other = made(spec_, variation);
    } catch (const rc::Error& error) {
      fail(error.code(), where, ": ", error.what());
    } catch (const formats::Error& error) {
      fail(RC_ERR_ARGUMENT, where, ": ", error.what());
    }
    if (!other->view.heights || other->view.maps != 1) fail(RC_ERR_ARGUMENT, where, " is not one map with heights");
    constexpr double most = 0.01;
    const rc_system &its = other->view.system, &own = problem_.system;
    const auto nominal = [](const rc_system& s) { return static_cast<double>(s.nx * s.ny) * s.hx * s.hy; };
    const double change = nominal(its) / nominal(own) - 1;
    if (other->view.si != base_.view.si)
      fail(RC_ERR_ARGUMENT, where, " and the surface must both have units, or none; give unit");
    if (!(std::abs(change) <= most))
      fail(RC_ERR_SHAPE, where, ": its nominal area differs by ", in_digits(100 * std::abs(change), 2), " %, the limit is ",
           100 * most, " %; crop the larger one");
    if (its.boundary != own.boundary)
      fail(RC_ERR_ARGUMENT, where,
           ": its edges would be free and those of the surface periodic, or the other way round; give boundary");
    if (pressing(*other, false).z == problem_.z)
      fail(RC_ERR_ARGUMENT, where, " has the heights of the surface itself; give other maps only");
    return other;
  }

  // Three grids, each of twice the pitch: the error of the finest is extrapolated with the order that the changes show, .5 to 2.
  Row grid() {
    std::vector<Outcome> coarser;
    Pressing problem = problem_;
    for (int k = 0; k < 2; ++k) {
      Extent extent{};
      problem.z = halved(problem.grid(), problem.z, extent);
      problem.system.nx = extent.nx;
      problem.system.ny = extent.ny;
      problem.system.hx = extent.hx;
      problem.system.hy = extent.hy;
      Press press{problem.system, options(base_, false).get(), progress_};
      coarser.push_back(press.solve(problem, "source grid"));
    }
    Row found;
    for (std::size_t q = 0; q < of::count; ++q) {
      const double last = std::abs(coarser[0][q] - value_[q]), before = std::abs(coarser[1][q] - coarser[0][q]);
      const double order = last > 0 ? std::clamp(std::log2(before / last), 0.5, 2.0) : 2;
      found[q].standard = std::isnan(last) || std::isnan(before) ? nan : last / (std::exp2(order) - 1);
    }
    return found;
  }

  // The solver's contribution: half of each interval that is proven for this grid.
  Row solver(const rc_result& r) const {
    const auto half = [](double lower, double upper) { return (upper - lower) / 2 * rectangular; };
    const double cells = r.contacts > 0 ? r.contact_area / r.area_fraction : 1, force = half(r.load_lower, r.load_upper);
    const bool by_approach = problem_.control == RC_CONTROL_APPROACH;
    Row found;
    found[of::load].standard = by_approach ? force : 0;
    found[of::approach].standard = by_approach ? 0 : force / r.stiffness;
    found[of::mean_pressure].standard = found[of::load].standard / cells;
    found[of::area].standard = half(r.area_lower, r.area_upper) / cells;
    found[of::stiffness].standard = half(r.stiffness_lower, r.stiffness_upper);
    const double per_stiffness = std::isnan(value_[of::conductance]) ? nan : 2 / problem_.system.modulus;
    found[of::conductance].standard = per_stiffness * found[of::stiffness].standard;
    found[of::mean_gap].standard = r.gap_error * rectangular;
    found[of::further].standard = further_half_ * rectangular;
    return found;
  }

  const rc_request_spec& spec_;
  const rc_budget_spec& budget_;
  const rc_request& base_;
  const Sources& sources_;
  Progress progress_;
  bool of_gap_;
  Pressing problem_;
  Press press_;
  std::unique_ptr<Press> samples_of_base_;
  Outcome value_{}, first_{};
  double further_half_ = 0;
};

}  // namespace

std::vector<Row> rows_of(const rc_request_spec& spec, const rc_budget_spec& budget, const rc_request& base,
                         const Sources& sources, Outcome& value) {
  return Rows{spec, budget, base, sources}.all(value);
}

}  // namespace rc::request
