// The machine of the threads of one process: vectorised loops over arrays. Threads share chunks of a fixed size, so that sums do
// not depend on the number of threads.
#pragma once

#include <utility>

#include "solvers/haar_cg/threads/passes.h"
#include "solvers/haar_cg/tree_pair.h"
#include "solvers/solver.h"

namespace rc {

template <class R> class ThreadMachine {
 public:
  using Real = R;
  using Vector = Real*;
  using Wide = double*;

  // problem and the pressures p must outlive it.
  ThreadMachine(const Problem& problem, std::span<double> p, HaarTreePair trees)
      : problem_(problem),
        team_(problem.team()),
        trees_(std::move(trees)),
        s_(problem.size(), {problem.u(), problem.grid(), problem.length_unit()}, p.data(), trees_.bytes(), team_) {
    trees_.place(s_.tree_spare());
  }
  ThreadMachine(const ThreadMachine&) = delete;
  ThreadMachine& operator=(const ThreadMachine&) = delete;

  Vector w() { return s_.w; }
  Vector t() { return s_.t; }
  Vector q() { return s_.q; }
  Vector z() { return s_.first_spare(); }
  Vector y() { return s_.second_spare(); }
  Wide p() { return s_.p; }
  Wide wide_spare() { return s_.double_spare(); }

  template <class Value> void product(Value* from, Value* to) { problem_.apply(static_cast<const Value*>(from), to); }
  template <class Value> void raise(Value* x, double by) { rc::raise(s_.n, by, x, team_); }
  template <class Value> double total(Value* x) { return rc::total(s_.n, x, team_); }
  double inner(Vector a, Vector b) { return rc::inner(s_, a, b, team_); }

  void set_up_trees(double surplus) { trees_.set_up(s_.active, static_cast<float>(surplus), team_); }
  double apply_trees(Vector g, Vector q) { return trees_.apply<Real>(g, s_.active, z(), q, team_); }

  HaarStart begin() { return rc::begin(s_, team_); }
  void multiply(double factor) { rc::multiply(s_, factor, team_); }
  double turn(double beta) { return rc::turn(s_, z(), static_cast<Real>(beta), team_); }
  bool advance(double length, bool cut) { return rc::advance(s_, length, cut ? z() : nullptr, team_); }
  HaarMeasure add_and_measure(Vector change, double shift) { return rc::add_and_measure(s_, change, shift, team_); }
  HaarMeasure replace_and_measure(Wide product, double shift) { return rc::replace_and_measure(s_, product, shift, team_); }
  bool choose_set(double threshold) { return rc::choose_set(s_, threshold, team_); }

 private:
  const Problem& problem_;
  const rc_team& team_;
  HaarTreePair trees_;
  HaarState<Real> s_;
};

}  // namespace rc
