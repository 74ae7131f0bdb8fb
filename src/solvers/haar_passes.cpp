#include "solvers/haar_passes.h"

#include <algorithm>
#include <cmath>
#include <roughcontact/plugin.hpp>

namespace rc {

namespace {

constexpr std::int64_t chunk = 8192;
constexpr std::int64_t least_shared = 4 * chunk;
constexpr std::int64_t lanes = 8;

// body(begin, end) -> Part for each chunk; parts are added in their order.
template <class Part, class Body> Part reduce(std::int64_t n, const rc_team& team, const Body& body) {
  const std::int64_t items = (n + chunk - 1) / chunk;
  std::vector<Part> parts(static_cast<std::size_t>(items));
  roughcontact::for_each(team, items, n >= least_shared, [&](std::int64_t item, std::int64_t) {
    parts[static_cast<std::size_t>(item)] = body(item * chunk, std::min((item + 1) * chunk, n));
  });
  Part total{};
  for (const Part& part : parts) total += part;
  return total;
}

// Sum over [begin, end) in eight partial sums.
template <class Term> double sum_between(std::int64_t begin, std::int64_t end, const Term& term) {
  double lane[lanes] = {};
  std::int64_t i = begin;
  for (; i + lanes <= end; i += lanes)
    for (std::int64_t k = 0; k < lanes; ++k) lane[k] += term(i + k);
  for (std::int64_t k = 0; i < end; ++i, ++k) lane[k] += term(i);
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

struct Measure : HaarMeasure {
  Measure& operator+=(const Measure& other) {
    largest = std::max(largest, other.largest);
    load += other.load;
    merit += other.merit;
    moment += other.moment;
    return *this;
  }
};

struct Flag {
  bool set = false;
  Flag& operator+=(Flag other) {
    set = set || other.set;
    return *this;
  }
};

// new_w(i) becomes w[i].
template <class Real, class Value> HaarMeasure measure(HaarState<Real>& s, const rc_team& team, const Value& new_w) {
  return reduce<Measure>(s.n, team, [&](std::int64_t begin, std::int64_t end) {
    double largest[lanes] = {}, load[lanes] = {}, merit[lanes] = {}, moment[lanes] = {};
    const auto visit = [&](std::int64_t i, std::int64_t k) {
      const Real w = new_w(i);
      s.w[static_cast<std::size_t>(i)] = w;
      const double value = static_cast<double>(w), p = s.p[i], residual = p > 0 ? std::abs(value) : -value;
      largest[k] = largest[k] < residual ? residual : largest[k];
      load[k] += p;
      merit[k] += p * (value - s.u[i]);
      moment[k] += p * value;
    };
    std::int64_t i = begin;
    for (; i + lanes <= end; i += lanes)
      for (std::int64_t k = 0; k < lanes; ++k) visit(i + k, k);
    for (std::int64_t k = 0; i < end; ++i, ++k) visit(i, k);
    Measure part;
    for (std::int64_t k = 0; k < lanes; ++k) {
      part.largest = std::max(part.largest, largest[k]);
      part.load += load[k];
      part.merit += 0.5 * merit[k];
      part.moment += moment[k];
    }
    return part;
  });
}

}  // namespace

template <class Real> double turn(HaarState<Real>& s, const Real* z, Real beta, const rc_team& team) {
  Real* const t = s.t.data();
  const Real* const w = s.w.data();
  const std::uint8_t* const active = s.active.data();
  return reduce<double>(s.n, team, [=](std::int64_t begin, std::int64_t end) {
    return sum_between(begin, end, [=](std::int64_t i) {
      const Real next = z[i] + beta * t[i];
      t[i] = active[i] ? next : Real{0};
      return static_cast<double>(w[i]) * static_cast<double>(t[i]);
    });
  });
}

template <class Real> double curvature(const HaarState<Real>& s, const rc_team& team) {
  const Real *const t = s.t.data(), *const q = s.q.data();
  return reduce<double>(s.n, team, [=](std::int64_t begin, std::int64_t end) {
    return sum_between(begin, end, [=](std::int64_t i) { return static_cast<double>(t[i]) * static_cast<double>(q[i]); });
  });
}

template <class Real> bool advance(HaarState<Real>& s, double length, Real* cut, const rc_team& team) {
  double* const p = s.p;
  Real* const w = s.w.data();
  const Real *const t = s.t.data(), *const q = s.q.data();
  const auto step = static_cast<Real>(length);
  return reduce<Flag>(s.n, team,
                      [=](std::int64_t begin, std::int64_t end) {
                        Flag any;
                        if (!cut) {
                          for (std::int64_t i = begin; i < end; ++i) {
                            p[i] -= length * static_cast<double>(t[i]);
                            w[i] -= step * q[i];
                          }
                          return any;
                        }
                        Real most = 0;
                        for (std::int64_t i = begin; i < end; ++i) {
                          const double next = p[i] - length * static_cast<double>(t[i]);
                          w[i] -= step * q[i];
                          p[i] = next > 0 ? next : 0;
                          cut[i] = static_cast<Real>(next < 0 ? -next : 0);
                          most = most < cut[i] ? cut[i] : most;
                        }
                        any.set = most > 0;
                        return any;
                      })
      .set;
}

template <class Real> HaarMeasure add_and_measure(HaarState<Real>& s, const Real* change, double shift, const rc_team& team) {
  const Real* const w = s.w.data();
  if (change) return measure(s, team, [=](std::int64_t i) { return w[i] + change[i]; });
  const auto less = static_cast<Real>(shift);
  return measure(s, team, [=](std::int64_t i) { return w[i] - less; });
}

template <class Real>
HaarMeasure replace_and_measure(HaarState<Real>& s, const double* product, double shift, const rc_team& team) {
  const double* const u = s.u;
  return measure(s, team, [=](std::int64_t i) { return static_cast<Real>(product[i] - u[i] - shift); });
}

template <class Real> bool choose_set(HaarState<Real>& s, double threshold, const rc_team& team) {
  std::uint8_t* const active = s.active.data();
  const double* const p = s.p;
  const Real* const w = s.w.data();
  const auto limit = static_cast<Real>(-threshold);
  return reduce<Flag>(s.n, team,
                      [=](std::int64_t begin, std::int64_t end) {
                        unsigned changed = 0;
                        for (std::int64_t i = begin; i < end; ++i) {
                          const std::uint8_t in = (p[i] > 0) | (w[i] < limit);
                          changed |= static_cast<unsigned>(in ^ active[i]);
                          active[i] = in;
                        }
                        return Flag{changed != 0};
                      })
      .set;
}

#define RC_INSTANTIATE(Real)                                                                         \
  template double turn(HaarState<Real>&, const Real*, Real, const rc_team&);                         \
  template double curvature(const HaarState<Real>&, const rc_team&);                                 \
  template bool advance(HaarState<Real>&, double, Real*, const rc_team&);                            \
  template HaarMeasure add_and_measure(HaarState<Real>&, const Real*, double, const rc_team&);       \
  template HaarMeasure replace_and_measure(HaarState<Real>&, const double*, double, const rc_team&); \
  template bool choose_set(HaarState<Real>&, double, const rc_team&);
RC_INSTANTIATE(float)
RC_INSTANTIATE(double)

}  // namespace rc
