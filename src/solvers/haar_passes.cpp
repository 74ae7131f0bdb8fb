#include "solvers/haar_passes.h"

#include <algorithm>
#include <roughcontact/plugin.hpp>

namespace rc {

namespace {

constexpr std::int64_t chunk = 8192;
constexpr std::int64_t least_shared = 4 * chunk;

// body(begin, count) -> Part for each chunk; parts are added in their order.
template <class Part, class Body> Part reduce(std::int64_t n, const rc_team& team, const Body& body) {
  const std::int64_t items = (n + chunk - 1) / chunk;
  std::vector<Part> parts(static_cast<std::size_t>(items));
  roughcontact::for_each(team, items, n >= least_shared, [&](std::int64_t item, std::int64_t) {
    parts[static_cast<std::size_t>(item)] = body(item * chunk, std::min(chunk, n - item * chunk));
  });
  Part total{};
  for (const Part& part : parts) total += part;
  return total;
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

template <class Real>
HaarMeasure measure(HaarState<Real>& s, typename HaarLoops<Real>::Measure loop, const Real* change, const double* product,
                    double shift, const rc_team& team) {
  return reduce<Measure>(s.n, team, [&](std::int64_t begin, std::int64_t n) {
    return Measure{loop(n, s.w.data() + begin, change ? change + begin : nullptr, product ? product + begin : nullptr, shift,
                        s.u + begin, s.p + begin)};
  });
}

}  // namespace

template <class Real> double turn(HaarState<Real>& s, const Real* z, Real beta, const rc_team& team) {
  return reduce<double>(s.n, team, [&, loops = best_haar_loops<Real>()](std::int64_t i, std::int64_t n) {
    return loops.turn(n, z + i, beta, s.t.data() + i, s.w.data() + i, s.active.data() + i);
  });
}

template <class Real> double curvature(const HaarState<Real>& s, const rc_team& team) {
  return reduce<double>(s.n, team, [&, loops = best_haar_loops<Real>()](std::int64_t i, std::int64_t n) {
    return loops.inner(n, s.t.data() + i, s.q.data() + i);
  });
}

template <class Real> bool advance(HaarState<Real>& s, double length, Real* cut, const rc_team& team) {
  return reduce<Flag>(s.n, team,
                      [&, loops = best_haar_loops<Real>()](std::int64_t i, std::int64_t n) {
                        const Real *const t = s.t.data() + i, *const q = s.q.data() + i;
                        if (cut) return Flag{loops.advance_and_cut(n, length, t, q, s.p + i, s.w.data() + i, cut + i)};
                        loops.advance(n, length, t, q, s.p + i, s.w.data() + i);
                        return Flag{};
                      })
      .set;
}

template <class Real> HaarMeasure add_and_measure(HaarState<Real>& s, const Real* change, double shift, const rc_team& team) {
  const HaarLoops<Real> loops = best_haar_loops<Real>();
  return measure<Real>(s, change ? loops.add : loops.lower, change, nullptr, shift, team);
}

template <class Real>
HaarMeasure replace_and_measure(HaarState<Real>& s, const double* product, double shift, const rc_team& team) {
  return measure<Real>(s, best_haar_loops<Real>().replace, nullptr, product, shift, team);
}

template <class Real> bool choose_set(HaarState<Real>& s, double threshold, const rc_team& team) {
  return reduce<Flag>(s.n, team,
                      [&, loops = best_haar_loops<Real>()](std::int64_t i, std::int64_t n) {
                        return Flag{loops.choose(n, s.p + i, s.w.data() + i, static_cast<Real>(-threshold), s.active.data() + i)};
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
