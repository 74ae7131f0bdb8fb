// The machine of the threads of one process: vectorised loops over arrays. Each pass between two products is one fused loop.
// Threads share chunks of a fixed size, so that sums do not depend on the number of threads.
//
// With `ranks` several processes share a machine. Each has the unknowns of its rows, every point of them; chunks are pieces of
// rows, so that sums do not depend on the number of ranks.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/chunks.h"
#include "solvers/haar_cg/threads/pass_loops.h"
#include "solvers/solver.h"
#include "trees/tree_pair.h"

namespace rc {

// Pressure: the precision of the pressures and of the residual's products, double unless the tolerance asks for less.
template <class R, class Pressure = double> class ThreadMachine {
 public:
  using Real = R;
  using Vector = Real*;
  using Wide = Pressure*;

  // problem, the pressures p [unknowns] and the ranks must outlive it. With ranks, size, gap and products of the problem are
  // those of this rank's rows, and the trees are made for them. q: null, or room for a vector.
  ThreadMachine(const Problem& problem, Pressure* p, HaarTreePair trees, const Ranks* ranks = nullptr, Real* q = nullptr);
  ThreadMachine(const ThreadMachine&) = delete;
  ThreadMachine& operator=(const ThreadMachine&) = delete;

  Vector w() { return w_; }
  Vector t() { return t_; }
  Vector q() { return q_; }
  Vector z() { return reinterpret_cast<Real*>(memory_.get() + margin_); }
  Vector y() { return z() + n_; }
  Wide p() { return p_; }
  Wide wide_spare() { return reinterpret_cast<Wide>(memory_.get() + margin_); }

  template <class Value> void product(Value* from, Value* to) { problem_.apply(static_cast<const Value*>(from), to); }
  template <class Value> void raise(Value* x, double by);
  template <class Value> double total(Value* x);
  double inner(Vector a, Vector b);

  void set_up_trees(double surplus) { trees_.set_up(active_, static_cast<float>(surplus), team_); }
  double apply_trees(Vector g, Vector q, double* level);

  HaarStart begin();
  void multiply(double factor, bool free);
  void scale(double factor, bool after_cut);
  double turn(double beta);
  bool advance(double length, bool cut, bool keep);
  HaarMeasure add_and_measure(Vector change, double shift);
  HaarMeasure grow_and_measure(double share);
  HaarMeasure replace_and_measure(Wide product, double shift);
  bool choose_set(double threshold);
  double nearest(bool unpressed);

 private:
  using Loops = HaarLoops<Real, Pressure>;

  // The loops for the chunk that begins here, and its runs.
  const Loops& loops_at(std::int64_t begin) const;
  RunState* runs_at(std::int64_t begin) { return runs_.data() + begin / chunks_.values * chunk_runs_; }
  std::uint8_t& reached_at(std::int64_t i) { return reached_[static_cast<std::size_t>(i / chunks_.values)]; }
  template <class Act> void each(const Act& act) { each_chunk(n_, team_, act, chunks_); }
  template <class Part, class Body, class Combine = std::plus<>>
  Part sum(const Body& body, Part total = {}, const Combine& combine = {}) {
    return reduce<Part>(n_, team_, body, total, combine, chunks_);
  }
  template <class Body> bool any(const Body& body) { return sum<char>(body, 0, std::logical_or<>()) != 0; }
  HaarMeasure measure(typename Loops::Measure Loops::*loop, const Real* change, const Pressure* product, double shift);
  template <class Wanted, class Visit>
  void with_u(std::int64_t begin, std::int64_t count, const Wanted& wanted, const Visit& visit) const;

  const Problem& problem_;
  const rc_team& team_;
  HaarTreePair trees_;
  const Loops loops_ = best_haar_loops<Real, Pressure>(), capped_loops_ = best_haar_loops<Real, Pressure>(true);
  const HaarInner<Real> inner_ = best_haar_inner<Real>();
  const std::int64_t n_;
  const Chunks chunks_;
  const std::int64_t chunk_runs_;  // of a chunk
  const std::size_t margin_;       // bytes of the previous rank's last row before w, z and the free set
  const double cap_;
  Pressure* const p_;
  std::vector<std::uint8_t> reached_;  // for each chunk: some of its pressures are, or were, at the cap
  std::vector<RunState> runs_;         // of the free set, [chunk][run]
  // First the spare memory, for two vectors of Real, or one of double, or one of Real and after it the trees; then w, t, q (where
  // it has no room elsewhere) and the free set.
  std::unique_ptr<std::byte[]> memory_;
  std::optional<double> pressures_;  // the sum of p, once a cut has made it
  // With ranks these sums are exchanged together with others, because each exchange has its latency.
  std::optional<HaarSlope<Real>> slope_;  // of the next direction
  Real *w_, *t_, *q_;
  std::uint8_t* active_;
};

}  // namespace rc
