// The passes of haar-cg as functions of a cell's index; solvers/haar_cg/iteration/machine.h says what each computes. All vectors
// are over a box of cells. A cell that is no unknown carries no pressure and is left out of sums.
#pragma once

#include "kernels/sums.h"

namespace rc_cuda {

// Marks of a cell.
constexpr std::uint8_t in_free_set = 1, is_unknown = 2;

RC_ANYWHERE inline double bounded(double p, double cap) { return rc::smaller_of(rc::larger_of(0.0, p), cap); }

struct Begin {
  const double* u;
  double* p;
  std::uint8_t* state;
  double cap, nearly;  // pressures from nearly on are at the cap, but for rounding
  RC_ANYWHERE Started operator()(Index i) const {
    if (!(state[i] & is_unknown)) {
      p[i] = 0;
      return {};
    }
    state[i] = in_free_set | is_unknown;
    p[i] = p[i] >= nearly ? cap : bounded(p[i], cap);
    return {u[i], p[i] > 0};
  }
};

struct Multiply {
  double *p, by, cap;
  bool free;  // only pressures below the cap, and up to it
  RC_ANYWHERE void operator()(Index i) const {
    const double next = p[i] * by;
    p[i] = !free ? next : p[i] < cap ? (next < cap ? next : cap) : cap;
  }
};

// Pressures in another unit, from 0 to the cap.
struct Convert {
  double *p, by, cap;
  RC_ANYWHERE void operator()(Index i) const { p[i] = bounded(p[i] * by, cap); }
};

// Pressures [force/length^2] over a box of a grid, 0 beyond it; null: none.
struct StoredPressures {
  const double* p;
  Index x, y, nx, ny;
  RC_ANYWHERE double at(Index column, Index row) const {
    const bool there = p && column >= x && column < x + nx && row >= y && row < y + ny;
    return there ? p[(row - y) * nx + column - x] : 0.0;
  }
};

// The start of a step from the last one and, where `ahead` is not 0, the one before it.
struct Restart {
  StoredPressures last, before;
  double ahead, unit, cap;
  double* p;
  Index x, y, nx;  // of its box
  RC_ANYWHERE void operator()(Index i) const {
    const Place place = place_of(i, nx);
    double value = last.at(x + place.column, y + place.row);
    if (ahead != 0) value += ahead * (value - before.at(x + place.column, y + place.row));
    p[i] = bounded(value / unit, cap);
  }
};

// To pressures; hardness: where p is the cap.
struct Store {
  const double* p;
  double unit, cap, hardness;
  double* to;  // may be p
  RC_ANYWHERE void operator()(Index i) const { to[i] = p[i] < cap ? p[i] * unit : hardness; }
};

template <class R> struct Scale {
  double *p, by, cap;
  R* z;
  bool after_cut;
  RC_ANYWHERE void operator()(Index i) const {
    const double scaled = by * p[i], next = p[i] < cap ? (scaled < cap ? scaled : cap) : cap;
    z[i] = (after_cut ? z[i] : R{0}) + static_cast<R>(next - p[i]);
    p[i] = next;
  }
};

template <class T> struct Raise {
  T* x;
  T by;
  RC_ANYWHERE void operator()(Index i) const { x[i] += by; }
};

template <class T> struct Total {
  const T* x;
  const std::uint8_t* state;
  RC_ANYWHERE Sum operator()(Index i) const { return {state[i] & is_unknown ? static_cast<double>(x[i]) : 0.0}; }
};

template <class R> struct Inner {
  const R *a, *b;
  const std::uint8_t* state;  // a is 0 off the free set, where b may be anything
  RC_ANYWHERE Sum operator()(Index i) const {
    return {state[i] & in_free_set ? static_cast<double>(a[i]) * static_cast<double>(b[i]) : 0.0};
  }
};

template <class R> struct Turn {
  const R *z, *w;
  R* t;
  const std::uint8_t* state;
  R beta;
  RC_ANYWHERE Sum operator()(Index i) const {
    if (!(state[i] & in_free_set)) {
      t[i] = 0;
      return {};
    }
    t[i] = beta == 0 ? z[i] : z[i] + beta * t[i];
    return {static_cast<double>(w[i]) * static_cast<double>(t[i])};
  }
};

template <class R> struct Advance {
  const R *t, *q;
  double* p;
  R* w;
  double length;
  RC_ANYWHERE void operator()(Index i) const {
    p[i] -= length * static_cast<double>(t[i]);
    w[i] -= static_cast<R>(length) * q[i];
  }
};

template <class R> struct Cut {
  Advance<R> advance;
  R* z;
  double cap;
  RC_ANYWHERE Any operator()(Index i) const {
    advance(i);
    const double next = advance.p[i], kept = bounded(next, cap);
    advance.p[i] = kept;
    z[i] = static_cast<R>(kept - next);
    return {z[i] != 0};
  }
};

// Keeps the load of a strip of a column, so that neighbouring threads read neighbouring cells.
template <class R> struct KeepLoad {
  double *p, cap;
  R* z;
  Index nx, ny;
  RC_ANYWHERE void operator()(Index strip) const {
    const Place first = place_of(strip, nx);
    const Index begin = first.row * rc::haar_strip, end = begin + rc::haar_strip < ny ? begin + rc::haar_strip : ny;
    double load = 0, added = 0, highest = 0;
    for (Index row = begin; row < end; ++row) {
      const Index i = row * nx + first.column;
      load += p[i];
      added += static_cast<double>(z[i]);
      highest = highest < p[i] ? p[i] : highest;
    }
    if (!(added > 0) || highest >= cap) return;
    const double share = 1 - added / load, factor = share > rc::least_kept_share ? share : rc::least_kept_share;
    for (Index row = begin; row < end; ++row) {
      const Index i = row * nx + first.column;
      const double next = factor * p[i];
      z[i] += static_cast<R>(next - p[i]);
      p[i] = next;
    }
  }
};

// w + change - shift, w + shift (w + u), product - u - shift.
enum class NewW { changed, grown, replaced };
template <class R> struct Update {
  R* w;
  const R* change;
  const double* product;
  const double *u, *p;
  const std::uint8_t* state;
  double shift, cap;
  NewW next;
  RC_ANYWHERE Measured operator()(Index i) const {
    if (!(state[i] & is_unknown)) return {};
    if (next == NewW::replaced)
      w[i] = static_cast<R>((product ? product[i] : 0.0) - u[i] - shift);
    else if (next == NewW::grown)
      w[i] = static_cast<R>(static_cast<double>(w[i]) + shift * (static_cast<double>(w[i]) + u[i]));
    else
      w[i] += (change ? change[i] : R{0}) - static_cast<R>(shift);
    const double value = static_cast<double>(w[i]), pressure = p[i];
    const bool capped = pressure >= cap;
    Measured m;
    m.largest = capped || (pressure > 0 && value > 0) ? value : -value;
    m.load = pressure;
    m.merit = 0.5 * pressure * (value - u[i]);
    m.moment = pressure * value;
    m.free_load = capped ? 0 : pressure;
    m.free_moment = capped ? 0 : m.moment;
    return m;
  }
};

template <class R> struct Choose {
  const double* p;
  const R* w;
  std::uint8_t* state;
  R limit;
  double cap;
  RC_ANYWHERE Any operator()(Index i) const {
    const std::uint8_t before = state[i];
    if (!(before & is_unknown)) return {};
    const bool in = p[i] >= cap ? w[i] > limit : p[i] > 0 || w[i] < -limit;
    const std::uint8_t after = in ? in_free_set | is_unknown : is_unknown;
    if (after != before) state[i] = after;
    return {after != before};
  }
};

template <class R> struct Nearest {
  const double* p;
  const R* w;
  const std::uint8_t* state;
  double cap;
  bool unpressed;
  RC_ANYWHERE Least operator()(Index i) const {
    if (!(state[i] & is_unknown) || !(unpressed ? p[i] <= 0 : p[i] >= cap)) return {};
    const double value = static_cast<double>(w[i]);
    return {value < 0 ? -value : value};
  }
};

// u of a box from the gap of a grid.
template <class T> struct Penetration {
  const T* gap;  // at the box's first cell
  double* u;
  double approach, length;
  Index nx, grid_nx;
  RC_ANYWHERE void operator()(Index i) const {
    const Place at = place_of(i, nx);
    u[i] = (approach - static_cast<double>(gap[at.row * grid_nx + at.column])) / length;
  }
};

}  // namespace rc_cuda
