// The machine of a device: all vectors of haar-cg stay there, over a box of cells. Passes are made by a Place: WholeDevice
// launches them, a block of threads (small/) makes those of a contact of its own.
#pragma once

#include <algorithm>
#include <limits>

#include "kernels/passes.h"
#include "tree_passes.h"

namespace rc_cuda {

// A Place has each(n, f), reduce<Part>(n, f) and together(work) as a Device has them, clear(x, n) and multiply(x, y): y = H x.
template <class R, class Place> class DeviceMachine {
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
  static constexpr std::size_t bytes(Index cells, std::size_t of_trees);
  static constexpr Memory place(unsigned char* memory, Index cells, std::size_t of_trees);

  constexpr DeviceMachine(Place& place, Index cells, double cap, const Memory& memory, const TreePasses& trees)
      : place_(place), cap_(cap), m_(memory), trees_(trees), n_(cells) {}

  constexpr Vector w() { return m_.w; }
  constexpr Vector t() { return m_.t; }
  constexpr Vector q() { return m_.q; }
  constexpr Vector z() { return reinterpret_cast<R*>(m_.spare); }
  constexpr Vector y() { return z() + n_; }
  constexpr Wide p() { return m_.p; }
  constexpr Wide wide_spare() { return m_.spare; }
  constexpr Index products() const { return products_; }

  template <class V> constexpr void product(V* from, V* to) {
    ++products_;
    place_.multiply(static_cast<const V*>(from), to);
  }
  template <class V> constexpr void raise(V* x, double by) { place_.each(n_, Raise<V>{x, static_cast<V>(by)}); }
  template <class V> constexpr double total(V* x) { return place_.template reduce<Sum>(n_, Total<V>{x, m_.state}).value; }
  constexpr double inner(Vector a, Vector b) { return place_.template reduce<Sum>(n_, Inner<R>{a, b, m_.state}).value; }

  constexpr void set_up_trees(double surplus) { trees_.set_up(place_, m_.state, surplus); }
  constexpr double apply_trees(Vector g, Vector q, double* level) {
    const Preconditioned found = trees_.template apply<R>(place_, g, m_.state, z(), q, level != nullptr);
    if (level) *level = found.level;
    return found.overlap;
  }

  constexpr rc::HaarStart begin() {
    place_.clear(m_.w, 3 * n_);
    place_.clear(m_.spare, n_);
    const Started start = place_.template reduce<Started>(n_, Begin{m_.u, m_.p, m_.state, cap_, nearly * cap_});
    return {start.highest, start.warm};
  }
  constexpr void multiply(double factor, bool free) { place_.each(n_, Multiply{m_.p, factor, cap_, free}); }
  constexpr void scale(double factor, bool after_cut) { place_.each(n_, Scale<R>{m_.p, factor, cap_, z(), after_cut}); }
  constexpr double turn(double beta) {
    return place_.template reduce<Sum>(n_, Turn<R>{z(), m_.w, m_.t, m_.state, static_cast<R>(beta)}).value;
  }
  constexpr bool advance(double length, bool cut, bool keep) {
    const Advance<R> ahead{m_.t, m_.q, m_.p, m_.w, length};
    if (!cut) {
      place_.each(n_, ahead);
      return false;
    }
    const bool any = place_.template reduce<Any>(n_, Cut<R>{ahead, z(), cap_}).value;
    if (any && keep) keep_loads();
    return any;
  }
  constexpr rc::HaarMeasure add_and_measure(Vector change, double shift) {
    return measured({m_.w, change, nullptr, m_.u, m_.p, m_.state, shift, cap_, NewW::changed});
  }
  constexpr rc::HaarMeasure grow_and_measure(double share) {
    return measured({m_.w, nullptr, nullptr, m_.u, m_.p, m_.state, share, cap_, NewW::grown});
  }
  constexpr rc::HaarMeasure replace_and_measure(Wide product, double shift) {
    return measured({m_.w, nullptr, product, m_.u, m_.p, m_.state, shift, cap_, NewW::replaced});
  }
  constexpr bool choose_set(double threshold) {
    return place_.template reduce<Any>(n_, Choose<R>{m_.p, m_.w, m_.state, static_cast<R>(threshold), cap_}).value;
  }
  constexpr double nearest(bool unpressed) {
    const double least = place_.template reduce<Least>(n_, Nearest<R>{m_.p, m_.w, m_.state, cap_, unpressed}).value;
    return least < Least{}.value ? least : std::numeric_limits<double>::infinity();
  }

 private:
  static constexpr double nearly = 1 - 1e-9;  // of the cap

  constexpr void keep_loads() {
    const Index nx = trees_.levels[0][0].mx, ny = trees_.levels[0][0].my, strips = (ny + rc::haar_strip - 1) / rc::haar_strip;
    place_.each(nx * strips, KeepLoad<R>{m_.p, cap_, z(), nx, ny});
  }

  RC_CALLED constexpr rc::HaarMeasure measured(const Update<R>& update) {
    const Measured sum = place_.template reduce<Measured>(n_, update);
    return {sum.largest, sum.load, sum.merit, sum.moment, sum.free_load, sum.free_moment};
  }

  Place& place_;
  const double cap_;
  const Memory m_;
  const TreePasses trees_;
  const Index n_;
  Index products_ = 0;
};

// Vectors of doubles, of Reals, the trees, the cells' states.
template <class R, class Place> constexpr std::size_t DeviceMachine<R, Place>::bytes(Index cells, std::size_t of_trees) {
  const auto n = static_cast<std::size_t>(cells);
  const std::size_t spare = std::max(sizeof(double), 2 * sizeof(R));
  return n * (2 * sizeof(double) + spare + 3 * sizeof(R) + 1) + of_trees + 256;
}

template <class R, class Place>
constexpr auto DeviceMachine<R, Place>::place(unsigned char* memory, Index cells, std::size_t of_trees) -> Memory {
  const auto n = static_cast<std::size_t>(cells);
  Memory m{};
  m.u = reinterpret_cast<double*>(memory);
  m.p = m.u + n;
  m.spare = m.p + n;
  m.w = reinterpret_cast<R*>(m.spare + std::max<std::size_t>(1, 2 * sizeof(R) / sizeof(double)) * n);
  m.t = m.w + n;
  m.q = m.t + n;
  const std::size_t used = static_cast<std::size_t>(reinterpret_cast<unsigned char*>(m.q + n) - memory);
  m.trees = memory + rounded(used);
  m.state = m.trees + of_trees;
  return m;
}

}  // namespace rc_cuda
