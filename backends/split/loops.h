// The inner loops, for the best vector instructions of this processor.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rc_split {

// A tile is 16 x 16 cells; a cell's number in it is 16 row + column.
inline constexpr std::int64_t side = 16, cells_of_tile = side * side;

// Points with a value, in one tile.
template <class T> struct Sources {
  const T* value;
  const std::uint8_t* cell;
  std::int64_t count;
};

// How a tile's cells spread to coarse nodes: cell i of an axis to `count` nodes with the weights [i*stride .. ), zeros from
// `count` on. All arrays here start at cache lines.
template <class T> struct Weights {
  const T *x, *y;
  const T* x_transposed;  // [count][16]
  std::int64_t count, stride;
};

template <class T> struct Loops {
  // tile[r][c] += value corner[(r - row) ld + c - column], summed over the sources at (row, column)
  void (*direct)(const T* corner, std::ptrdiff_t ld, Sources<T> sources, T* tile);
  // patch = A_y' X A_x, X the tile with the sources; patch[count][stride]
  void (*spread)(const Weights<T>& weights, Sources<T> sources, T* patch);
  // tile = A_y G A_x', G[count][..] with rows of ld; reads `stride` columns of it
  void (*interpolate)(const Weights<T>& weights, const T* nodes, std::ptrdiff_t ld, T* tile);
};

template <class T> Loops<T> best_loops();

}  // namespace rc_split
