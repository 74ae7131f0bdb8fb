// The machine of a device: all vectors of haar-cg stay there, over a box of cells. Each pass is a launch; those that end in a sum
// wait for it.
#pragma once

#include <limits>

#include "engine.h"
#include "kernels/passes.h"
#include "trees.h"

namespace rc_cuda {

// The unknowns of a problem, as the machine has them: cells of a box.
struct Problem {
  Window box;
  double cap;
  double zero_mode;  // eigenvalue of H for the constant vector
};

template <class R> class DeviceMachine {
 public:
  using Real = R;
  using Vector = R*;
  using Wide = double*;

  // u, p [cells] and state [cells], is_unknown or 0, are in the vectors' memory, as are the trees: see Vectors.
  struct Memory {
    double *u, *p, *spare;  // spare: z and y lie in it
    R *w, *t, *q;
    std::uint8_t* state;
    unsigned char* trees;
  };
  static std::size_t bytes(Index cells, const Trees& trees);
  static Memory place(unsigned char* memory, Index cells, const Trees& trees);

  DeviceMachine(Engine& engine, const Spectrum& spectrum, const Problem& problem, const Memory& memory, Trees& trees)
      : engine_(engine),
        device_(engine.device()),
        spectrum_(spectrum),
        problem_(problem),
        m_(memory),
        trees_(trees),
        n_(problem.box.nx * problem.box.ny) {}

  Vector w() { return m_.w; }
  Vector t() { return m_.t; }
  Vector q() { return m_.q; }
  Vector z() { return reinterpret_cast<R*>(m_.spare); }
  Vector y() { return z() + n_; }
  Wide p() { return m_.p; }
  Wide wide_spare() { return m_.spare; }
  Index products() const { return products_; }

  template <class V> void product(V* from, V* to) {
    ++products_;
    engine_.multiply(spectrum_, problem_.box, static_cast<const V*>(from), problem_.box, to, problem_.zero_mode);
  }
  template <class V> void raise(V* x, double by) { device_.each(n_, Raise<V>{x, static_cast<V>(by)}); }
  template <class V> double total(V* x) { return device_.template reduce<Sum>(n_, Total<V>{x, m_.state}).value; }
  double inner(Vector a, Vector b) { return device_.template reduce<Sum>(n_, Inner<R>{a, b, m_.state}).value; }

  void set_up_trees(double surplus) { trees_.set_up(device_, m_.state, surplus); }
  double apply_trees(Vector g, Vector q, double* level) {
    const Preconditioned found = trees_.template apply<R>(device_, g, m_.state, z(), q, level != nullptr);
    if (level) *level = found.level;
    return found.overlap;
  }

  rc::HaarStart begin() {
    device_.clear(m_.w, 3 * static_cast<std::size_t>(n_) * sizeof(R));
    device_.clear(m_.spare, static_cast<std::size_t>(n_) * sizeof(double));
    const Started start = device_.template reduce<Started>(n_, Begin{m_.u, m_.p, m_.state, problem_.cap, nearly * problem_.cap});
    return {start.highest, start.warm};
  }
  void multiply(double factor, bool free) { device_.each(n_, Multiply{m_.p, factor, problem_.cap, free}); }
  void scale(double factor, bool after_cut) { device_.each(n_, Scale<R>{m_.p, factor, problem_.cap, z(), after_cut}); }
  double turn(double beta) {
    return device_.template reduce<Sum>(n_, Turn<R>{z(), m_.w, m_.t, m_.state, static_cast<R>(beta)}).value;
  }
  bool advance(double length, bool cut) {
    const Advance<R> ahead{m_.t, m_.q, m_.p, m_.w, length};
    if (cut) return device_.template reduce<Any>(n_, Cut<R>{ahead, z(), problem_.cap}).value;
    device_.each(n_, ahead);
    return false;
  }
  rc::HaarMeasure add_and_measure(Vector change, double shift) {
    return measured({m_.w, change, nullptr, m_.u, m_.p, m_.state, shift, problem_.cap, false});
  }
  rc::HaarMeasure replace_and_measure(Wide product, double shift) {
    return measured({m_.w, nullptr, product, m_.u, m_.p, m_.state, shift, problem_.cap, true});
  }
  bool choose_set(double threshold) {
    return device_.template reduce<Any>(n_, Choose<R>{m_.p, m_.w, m_.state, static_cast<R>(threshold), problem_.cap}).value;
  }
  double nearest(bool unpressed) {
    const double least = device_.template reduce<Least>(n_, Nearest<R>{m_.p, m_.w, m_.state, problem_.cap, unpressed}).value;
    return least < Least{}.value ? least : std::numeric_limits<double>::infinity();
  }

 private:
  static constexpr double nearly = 1 - 1e-9;  // of the cap

  rc::HaarMeasure measured(const Update<R>& update) {
    const Measured sum = device_.template reduce<Measured>(n_, update);
    return {sum.largest, sum.load, sum.merit, sum.moment, sum.free_load, sum.free_moment};
  }

  Engine& engine_;
  Device& device_;
  const Spectrum& spectrum_;
  const Problem problem_;
  const Memory m_;
  Trees& trees_;
  const Index n_;
  Index products_ = 0;
};

// Vectors of doubles, of Reals, the trees, the cells' states.
template <class R> std::size_t DeviceMachine<R>::bytes(Index cells, const Trees& trees) {
  const auto n = static_cast<std::size_t>(cells);
  const std::size_t spare = std::max(sizeof(double), 2 * sizeof(R));
  return n * (2 * sizeof(double) + spare + 3 * sizeof(R) + 1) + trees.bytes() + 256;
}

template <class R> auto DeviceMachine<R>::place(unsigned char* memory, Index cells, const Trees& trees) -> Memory {
  const auto n = static_cast<std::size_t>(cells);
  Memory m;
  m.u = reinterpret_cast<double*>(memory);
  m.p = m.u + n;
  m.spare = m.p + n;
  m.w = reinterpret_cast<R*>(m.spare + std::max<std::size_t>(1, 2 * sizeof(R) / sizeof(double)) * n);
  m.t = m.w + n;
  m.q = m.t + n;
  const std::size_t used = static_cast<std::size_t>(reinterpret_cast<unsigned char*>(m.q + n) - memory);
  m.trees = memory + (used + 255) / 256 * 256;
  m.state = m.trees + trees.bytes();
  return m;
}

}  // namespace rc_cuda
