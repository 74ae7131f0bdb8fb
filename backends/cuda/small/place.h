// Where haar-cg runs for a small contact: one block of threads, with memory of its own.
#pragma once

#include "small/torus.h"
#include "tree_passes.h"

namespace rc_cuda {

class InBlock {
 public:
  struct Product {
    SmallTorus<float> single;
    SmallTorus<double> wide;
    Complex<float>* single_data;
    Complex<double>* wide_data;
  };

  constexpr InBlock(Block& block, const Product& product) : block_(block), product_(product) {}

  template <class F> constexpr void each(Index n, const F& f) { block_.each(n, f); }
  template <class Part, class F> constexpr Part reduce(Index n, const F& f) { return block_.template reduce<Part>(n, f); }
  template <class Work> constexpr void together(const Work& work) { block_.together(work); }
  template <class T> constexpr void clear(T* x, Index n) { block_.each(n, Fill<T>{x, 0}); }
  constexpr void multiply(const float* x, float* y) { rc_cuda::multiply(block_, product_.single, product_.single_data, x, y); }
  constexpr void multiply(const double* x, double* y) { rc_cuda::multiply(block_, product_.wide, product_.wide_data, x, y); }

 private:
  Block& block_;
  const Product& product_;
};

template <class T> RC_ANYWHERE T* farther(T* at, std::ptrdiff_t by) {
  return at ? reinterpret_cast<T*>(reinterpret_cast<std::uintptr_t>(at) + static_cast<std::uintptr_t>(by)) : nullptr;
}

// A level with its memory so many bytes farther on.
struct MoveLevel {
  const Level* from;
  Level* to;
  std::ptrdiff_t by;
  RC_ANYWHERE void operator()(Index i) const {
    Level level = from[i];
    level.child = farther(level.child, by);
    level.parent = farther(level.parent, by);
    level.shares = farther(level.shares, by);
    level.details = farther(level.details, by);
    to[i] = level;
  }
};

// The trees laid out in one memory, in another one, which is so many bytes farther on; the table of patterns stays.
RC_ANYWHERE inline TreePasses moved(Block& block, const TreePasses& trees, std::ptrdiff_t by) {
  TreePasses result = trees;
  for (int t = 0; t < 2; ++t) {
    Level* const to = farther(const_cast<Level*>(trees.levels[t]), by);
    block.each(trees.summit.levels[t], MoveLevel{trees.levels[t], to, by});
    result.levels[t] = result.summit.tree[t] = to;
  }
  result.summit.top = farther(trees.summit.top, by);
  result.summit.level_of_w = farther(trees.summit.level_of_w, by);
  return result;
}

}  // namespace rc_cuda
