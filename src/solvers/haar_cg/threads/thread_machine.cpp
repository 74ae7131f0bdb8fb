#include "solvers/haar_cg/threads/thread_machine.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

#include "core/chunks.h"
#include "core/large_memory.h"
#include "core/limits.h"
#include "core/sums.h"

namespace rc {

namespace {

constexpr std::int64_t piece = 1024;
constexpr double nearly = 1 - 1e-9;  // of the cap: pressures to start from that are higher are at the cap, but for rounding

constexpr std::size_t line = 64;  // bytes that rows of another rank begin at a multiple of

template <class Value> double sum_in_chunk(const Value* x, std::int64_t begin, std::int64_t count) {
  return sum_of(static_cast<std::size_t>(count),
                [&](std::size_t i) { return static_cast<double>(x[begin + static_cast<std::int64_t>(i)]); });
}

HaarMeasure sum_of_two(const HaarMeasure& a, const HaarMeasure& b) {
  return {std::max(a.largest, b.largest), a.load + b.load, a.merit + b.merit, a.moment + b.moment, a.free_load + b.free_load,
          a.free_moment + b.free_moment};
}

}  // namespace

template <class Real, class Pressure>
ThreadMachine<Real, Pressure>::ThreadMachine(const Problem& problem, Pressure* p, HaarTreePair trees, const Ranks* ranks, Real* q)
    : problem_(problem),
      team_(problem.team()),
      trees_(std::move(trees)),
      n_(problem.size()),
      chunks_(Chunks::of(ranks, problem.grid()->nx)),
      chunk_runs_((chunks_.values + run_points - 1) / run_points),
      margin_(ranks ? (static_cast<std::size_t>(problem.grid()->nx) * sizeof(Real) + line - 1) / line * line : 0),
      cap_(static_cast<Pressure>(problem.cap())),  // the largest pressure that there is
      p_(p),
      reached_(static_cast<std::size_t>(chunks_.count(n_))),
      runs_(static_cast<std::size_t>(chunks_.count(n_) * chunk_runs_), RunState::busy) {
  const auto count = static_cast<std::size_t>(n_);
  const std::size_t shared =
      std::max({count * sizeof(Pressure), 2 * count * sizeof(Real), count * sizeof(Real) + trees_.bytes()});
  const std::size_t spares = (shared + sizeof(double) - 1) / sizeof(double) * sizeof(double);  // so that all is aligned
  const std::size_t bytes = spares + count * ((q ? 2 : 3) * sizeof(Real) + 1) + 3 * margin_;
  memory_.reset(new std::byte[bytes]);
  prefer_large(memory_.get(), bytes);
  w_ = reinterpret_cast<Real*>(memory_.get() + spares + 2 * margin_);
  t_ = w_ + count;
  q_ = q ? q : t_ + count;
  active_ = reinterpret_cast<std::uint8_t*>(t_ + (q ? 1 : 2) * count) + margin_;
  each([&](std::int64_t i, std::int64_t length) {
    std::fill_n(t_ + i, length, Real{0});
    std::fill_n(active_ + i, length, std::uint8_t{1});
  });
  trees_.place(reinterpret_cast<std::byte*>(y()));
}

// visit(first, count, u) for pieces of the unknowns that are short enough to compute u on the stack, if the problem has none:
// in the runs that are wanted.
template <class Real, class Pressure>
template <class Wanted, class Visit>
void ThreadMachine<Real, Pressure>::with_u(std::int64_t begin, std::int64_t n, const Wanted& wanted, const Visit& visit) const {
  const double* const u = problem_.u();
  const rc_grid& grid = *problem_.grid();
  const GapValues gap = problem_.gap();
  const double approach = grid.approach, per_length = 1 / problem_.length_unit();
  double room[piece];
  for (std::int64_t i = begin; i < begin + n; i += piece) {
    const std::int64_t count = std::min(piece, begin + n - i);
    for (std::int64_t from = 0; !u && from < count; from += run_points) {
      if (!wanted(i + from)) continue;
      const std::int64_t to = std::min(from + run_points, count);
      gap.visit([&](const auto* h) {
        if (grid.index)
          for (std::int64_t k = from; k < to; ++k) room[k] = (approach - h[grid.index[i + k]]) * per_length;
        else if constexpr (std::is_same_v<decltype(h), const float*>)
          loops_.compenetrate_single(to - from, h + i + from, approach, per_length, room + from);
        else
          loops_.compenetrate(to - from, h + i + from, approach, per_length, room + from);
      });
    }
    visit(i, count, u ? u + i : room);
  }
}

template <class Real, class Pressure> double ThreadMachine<Real, Pressure>::apply_trees(Vector g, Vector q, double* level) {
  slope_.reset();
  if (chunks_.ranks && g == w_ && q) slope_ = HaarSlope<Real>{t_};
  return trees_.apply<Real>(g, active_, z(), q, level, team_, slope_ ? &*slope_ : nullptr);
}

template <class Real, class Pressure> HaarStart ThreadMachine<Real, Pressure>::begin() {
  pressures_.reset();
  constexpr HaarStart none{-std::numeric_limits<double>::infinity(), false};
  const auto both = [](const HaarStart& a, const HaarStart& b) {
    return HaarStart{std::max(a.highest, b.highest), a.warm || b.warm};
  };
  const auto all = [](std::int64_t) { return true; };
  const auto body = [&](std::int64_t from, std::int64_t n) {
    HaarStart start = none;
    with_u(from, n, all, [&](std::int64_t first, std::int64_t count, const double* u) {
      Pressure* const p = p_ + first;
      double highest = start.highest, most = 0;
      for (std::int64_t i = 0; i < count; ++i) {
        highest = std::max(highest, u[i]);
        const auto given = static_cast<double>(p[i]), kept = given >= nearly * cap_ ? cap_ : std::max(given, 0.0);
        p[i] = static_cast<Pressure>(kept);
        most = std::max(most, kept);
      }
      if (most >= cap_) reached_at(first) = 1;
      start = both(start, {highest, most > 0});
    });
    return start;
  };
  return sum<HaarStart>(body, none, both);
}

template <class Real, class Pressure>
const HaarLoops<Real, Pressure>& ThreadMachine<Real, Pressure>::loops_at(std::int64_t begin) const {
  return reached_[static_cast<std::size_t>(begin / chunks_.values)] ? capped_loops_ : loops_;
}

template <class Real, class Pressure>
HaarMeasure ThreadMachine<Real, Pressure>::measure(typename Loops::Measure Loops::*loop, const Real* change,
                                                   const Pressure* product, double shift) {
  const bool everywhere = loop != &Loops::add && loop != &Loops::lower;
  const auto body = [&](std::int64_t begin, std::int64_t n) {
    const Loops& loops = loops_at(begin);
    const RunState* const runs = runs_at(begin);
    const auto read = [&, all = everywhere || &loops == &capped_loops_](std::int64_t i) {
      return all || runs[(i - begin) / run_points] == RunState::busy;
    };
    HaarMeasure total;
    with_u(begin, n, read, [&](std::int64_t i, std::int64_t count, const double* u) {
      total = sum_of_two(total, (loops.*loop)(count, w_ + i, change ? change + i : nullptr, product ? product + i : nullptr,
                                              shift, u, p_ + i, cap_, runs + (i - begin) / run_points));
    });
    return total;
  };
  return sum<HaarMeasure>(body, {}, sum_of_two);
}

template <class Real, class Pressure> HaarMeasure ThreadMachine<Real, Pressure>::add_and_measure(Vector change, double shift) {
  return measure(change ? &Loops::add : &Loops::lower, change, nullptr, shift);
}

template <class Real, class Pressure> HaarMeasure ThreadMachine<Real, Pressure>::grow_and_measure(double share) {
  return measure(&Loops::grow, nullptr, nullptr, share);
}

template <class Real, class Pressure> HaarMeasure ThreadMachine<Real, Pressure>::replace_and_measure(Wide product, double shift) {
  return measure(product ? &Loops::replace : &Loops::begin, nullptr, product, shift);
}

template <class Real, class Pressure> void ThreadMachine<Real, Pressure>::multiply(double factor, bool free) {
  pressures_.reset();
  each([&](std::int64_t from, std::int64_t n) {
    if (!free || cap_ == infinite) {
      for (std::int64_t i = from; i < from + n; ++i) p_[i] = static_cast<Pressure>(static_cast<double>(p_[i]) * factor);
      return;
    }
    double most = 0;
    for (std::int64_t i = from; i < from + n; ++i) {
      const auto before = static_cast<double>(p_[i]), next = before < cap_ ? std::min(before * factor, cap_) : cap_;
      p_[i] = static_cast<Pressure>(next);
      most = std::max(most, next);
    }
    if (most >= cap_) reached_at(from) = 1;
  });
}

template <class Real, class Pressure> void ThreadMachine<Real, Pressure>::scale(double factor, bool after_cut) {
  pressures_.reset();
  const Loops& loops = cap_ < infinite ? capped_loops_ : loops_;
  each([&](std::int64_t i, std::int64_t n) {
    if (loops.scale(n, factor, p_ + i, cap_, z() + i, after_cut, runs_at(i))) reached_at(i) = 1;
  });
}

template <class Real, class Pressure> double ThreadMachine<Real, Pressure>::turn(double beta) {
  const auto body = [&](std::int64_t i, std::int64_t n) {
    return loops_.turn(n, z() + i, static_cast<Real>(beta), t_ + i, w_ + i, active_ + i, runs_at(i));
  };
  if (!slope_) return sum<double>(body);
  each(body);
  return slope_->along_z + beta * slope_->along_t;
}

template <class Real, class Pressure> bool ThreadMachine<Real, Pressure>::advance(double length, bool cut, bool keep) {
  pressures_.reset();
  if (!cut) {
    each([&](std::int64_t i, std::int64_t n) { loops_.advance(n, length, t_ + i, q_ + i, p_ + i, w_ + i, runs_at(i)); });
    return false;
  }
  const Loops& loops = cap_ < infinite ? capped_loops_ : loops_;
  const auto cut_chunk = [&](std::int64_t i, std::int64_t n) {
    HaarCut found = loops.advance_and_cut(n, length, t_ + i, q_ + i, p_ + i, cap_, w_ + i, z() + i, runs_at(i));
    if (found.capped) reached_at(i) = 1;
    if (keep && found.any) found.load = loops.keep_loads(n, p_ + i, cap_, z() + i, runs_at(i));
    return found;
  };
  const HaarCut all = sum<HaarCut>(cut_chunk, {}, [](const HaarCut& a, const HaarCut& b) {
    return HaarCut{a.load + b.load, a.any || b.any, a.capped || b.capped};
  });
  pressures_ = all.load;
  return all.any;
}

template <class Real, class Pressure> bool ThreadMachine<Real, Pressure>::choose_set(double threshold) {
  const auto body = [&](std::int64_t i, std::int64_t n) {
    return loops_at(i).choose(n, p_ + i, cap_, w_ + i, static_cast<Real>(threshold), active_ + i, runs_at(i));
  };
  if (!chunks_.ranks) return any(body);
  each(body);
  return true;  // to ask all ranks takes longer than to set up the trees once more
}

template <class Real, class Pressure> double ThreadMachine<Real, Pressure>::nearest(bool unpressed) {
  const auto body = [&](std::int64_t from, std::int64_t n) {
    double least = infinite;
    for (std::int64_t i = from; i < from + n; ++i)
      if (unpressed ? p_[i] <= 0 : static_cast<double>(p_[i]) >= cap_)
        least = std::min(least, std::abs(static_cast<double>(w_[i])));
    return least;
  };
  return sum<double>(body, infinite, [](double a, double b) { return std::min(a, b); });
}

template <class Real, class Pressure> double ThreadMachine<Real, Pressure>::inner(Vector a, Vector b) {
  return sum<double>([&](std::int64_t i, std::int64_t n) { return inner_(n, a + i, b + i, active_ + i); });
}

template <class Real, class Pressure> template <class Value> double ThreadMachine<Real, Pressure>::total(Value* x) {
  if (static_cast<void*>(x) == p_ && pressures_) return *pressures_;
  return sum<double>([&](std::int64_t begin, std::int64_t count) { return sum_in_chunk(x, begin, count); });
}

template <class Real, class Pressure> template <class Value> void ThreadMachine<Real, Pressure>::raise(Value* x, double by) {
  each([&](std::int64_t begin, std::int64_t count) {
    for (std::int64_t i = begin; i < begin + count; ++i) x[i] += static_cast<Value>(by);
  });
}

template class ThreadMachine<float, float>;
template double ThreadMachine<float, float>::total(float*);
template void ThreadMachine<float, float>::raise(float*, double);
template class ThreadMachine<float>;
template class ThreadMachine<double>;
template double ThreadMachine<float>::total(float*);
template double ThreadMachine<float>::total(double*);
template double ThreadMachine<double>::total(double*);
template void ThreadMachine<float>::raise(float*, double);
template void ThreadMachine<float>::raise(double*, double);
template void ThreadMachine<double>::raise(double*, double);

}  // namespace rc
