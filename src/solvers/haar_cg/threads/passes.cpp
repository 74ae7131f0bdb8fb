#include "solvers/haar_cg/threads/passes.h"

#include <algorithm>
#include <limits>
#include <roughcontact/plugin.hpp>
#include <vector>

#include "core/sums.h"

namespace rc {

namespace {

constexpr std::int64_t chunk = 8192, piece = 1024;
constexpr std::int64_t least_shared = 4 * chunk;

// Adds up body(begin, count) -> Part of all chunks, in their order.
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

struct Start {
  HaarStart value{-std::numeric_limits<double>::infinity(), false};
  Start& operator+=(const Start& other) {
    value.highest = std::max(value.highest, other.value.highest);
    value.warm = value.warm || other.value.warm;
    return *this;
  }
};

struct Nothing {
  Nothing& operator+=(Nothing) { return *this; }
};

// visit(first, count, u) for pieces of the unknowns that are short enough to compute u on the stack.
template <class Visit> void with_u(const Compenetration& u, std::int64_t begin, std::int64_t n, const Visit& visit) {
  double room[piece];
  for (std::int64_t i = begin; i < begin + n; i += piece) {
    const std::int64_t count = std::min(piece, begin + n - i);
    visit(i, count, u.values(i, count, room));
  }
}

template <class Real>
HaarMeasure measure(HaarState<Real>& s, typename HaarLoops<Real>::Measure loop, const Real* change, const double* product,
                    double shift, const rc_team& team) {
  return reduce<Measure>(s.n, team, [&](std::int64_t begin, std::int64_t n) {
    Measure sum;
    with_u(s.u, begin, n, [&](std::int64_t i, std::int64_t count, const double* u) {
      sum += Measure{
          loop(count, s.w + i, change ? change + i : nullptr, product ? product + i : nullptr, shift, u, s.p + i, s.active + i)};
    });
    return sum;
  });
}

}  // namespace

const double* Compenetration::values(std::int64_t begin, std::int64_t count, double* room) const {
  if (u) return u + begin;
  const double approach = grid->approach;
  if (grid->index) {
    for (std::int64_t i = 0; i < count; ++i) room[i] = (approach - grid->undeformed_gap[grid->index[begin + i]]) / length;
  } else {
    for (std::int64_t i = 0; i < count; ++i) room[i] = (approach - grid->undeformed_gap[begin + i]) / length;
  }
  return room;
}

template <class Real>
HaarState<Real>::HaarState(std::int64_t size, const Compenetration& compenetration, double* pressure, std::size_t trees,
                           const rc_team& team)
    : n(size), u(compenetration), p(pressure) {
  const auto count = static_cast<std::size_t>(size);
  const std::size_t shared = std::max({count * sizeof(double), 2 * count * sizeof(Real), count * sizeof(Real) + trees});
  const std::size_t spares = (shared + sizeof(double) - 1) / sizeof(double) * sizeof(double);  // so that all is aligned
  memory.reset(new std::byte[spares + count * (3 * sizeof(Real) + 1)]);
  spare = memory.get();
  w = reinterpret_cast<Real*>(spare + spares);
  t = w + count;
  q = t + count;
  active = reinterpret_cast<std::uint8_t*>(q + count);
  reduce<Nothing>(n, team, [&](std::int64_t i, std::int64_t length) {
    std::fill_n(t + i, length, Real{0});
    std::fill_n(active + i, length, std::uint8_t{1});
    return Nothing{};
  });
}

template <class Real> HaarStart begin(HaarState<Real>& s, const rc_team& team) {
  return reduce<Start>(s.n, team,
                       [&](std::int64_t from, std::int64_t n) {
                         Start start;
                         with_u(s.u, from, n, [&](std::int64_t first, std::int64_t count, const double* u) {
                           double* const p = s.p + first;
                           double highest = start.value.highest, most = 0;
                           for (std::int64_t i = 0; i < count; ++i) {
                             highest = std::max(highest, u[i]);
                             p[i] = std::max(p[i], 0.0);
                             most = std::max(most, p[i]);
                           }
                           start += Start{{highest, most > 0}};
                         });
                         return start;
                       })
      .value;
}

template <class Real> void multiply(HaarState<Real>& s, double factor, const rc_team& team) {
  reduce<Nothing>(s.n, team, [&](std::int64_t from, std::int64_t n) {
    for (std::int64_t i = from; i < from + n; ++i) s.p[i] *= factor;
    return Nothing{};
  });
}

template <class Real> double turn(HaarState<Real>& s, const Real* z, Real beta, const rc_team& team) {
  return reduce<double>(s.n, team, [&, loops = best_haar_loops<Real>()](std::int64_t i, std::int64_t n) {
    return loops.turn(n, z + i, beta, s.t + i, s.w + i, s.active + i);
  });
}

template <class Real> bool advance(HaarState<Real>& s, double length, Real* cut, const rc_team& team) {
  return reduce<Flag>(s.n, team,
                      [&, loops = best_haar_loops<Real>()](std::int64_t i, std::int64_t n) {
                        const Real *const t = s.t + i, *const q = s.q + i;
                        if (cut) return Flag{loops.advance_and_cut(n, length, t, q, s.p + i, s.w + i, cut + i, s.active + i)};
                        loops.advance(n, length, t, q, s.p + i, s.w + i, s.active + i);
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
  const HaarLoops<Real> loops = best_haar_loops<Real>();
  return measure<Real>(s, product ? loops.replace : loops.begin, nullptr, product, shift, team);
}

template <class Real> bool choose_set(HaarState<Real>& s, double threshold, const rc_team& team) {
  return reduce<Flag>(s.n, team,
                      [&, loops = best_haar_loops<Real>()](std::int64_t i, std::int64_t n) {
                        return Flag{loops.choose(n, s.p + i, s.w + i, static_cast<Real>(-threshold), s.active + i)};
                      })
      .set;
}

template <class Real> double inner(const HaarState<Real>& s, const Real* a, const Real* b, const rc_team& team) {
  return reduce<double>(s.n, team, [&, loop = best_haar_loops<Real>().inner](std::int64_t i, std::int64_t n) {
    return loop(n, a + i, b + i, s.active + i);
  });
}

template <class Value> double total(std::int64_t n, const Value* x, const rc_team& team) {
  return reduce<double>(n, team, [&](std::int64_t begin, std::int64_t count) {
    return sum_of(static_cast<std::size_t>(count),
                  [&](std::size_t i) { return static_cast<double>(x[begin + static_cast<std::int64_t>(i)]); });
  });
}

template <class Value> void raise(std::int64_t n, double by, Value* x, const rc_team& team) {
  reduce<Nothing>(n, team, [&](std::int64_t begin, std::int64_t count) {
    for (std::int64_t i = begin; i < begin + count; ++i) x[i] += static_cast<Value>(by);
    return Nothing{};
  });
}

bool any_positive(std::int64_t n, const double* x, const rc_team& team) {
  return reduce<Flag>(n, team,
                      [&](std::int64_t begin, std::int64_t count) {
                        double most = 0;
                        for (std::int64_t i = begin; i < begin + count; ++i) most = std::max(most, x[i]);
                        return Flag{most > 0};
                      })
      .set;
}

#define RC_INSTANTIATE(Real)                                                                         \
  template struct HaarState<Real>;                                                                   \
  template HaarStart begin(HaarState<Real>&, const rc_team&);                                        \
  template void multiply(HaarState<Real>&, double, const rc_team&);                                  \
  template double turn(HaarState<Real>&, const Real*, Real, const rc_team&);                         \
  template bool advance(HaarState<Real>&, double, Real*, const rc_team&);                            \
  template HaarMeasure add_and_measure(HaarState<Real>&, const Real*, double, const rc_team&);       \
  template HaarMeasure replace_and_measure(HaarState<Real>&, const double*, double, const rc_team&); \
  template bool choose_set(HaarState<Real>&, double, const rc_team&);                                \
  template double inner(const HaarState<Real>&, const Real*, const Real*, const rc_team&);           \
  template double total(std::int64_t, const Real*, const rc_team&);                                  \
  template void raise(std::int64_t, double, Real*, const rc_team&);
RC_INSTANTIATE(float)
RC_INSTANTIATE(double)

}  // namespace rc
