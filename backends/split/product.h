// Products in one precision, from the tiles of a domain to tiles of a frame. The short range is summed directly, the smooth rest
// by a coarse grid.
#pragma once

#include <memory>

#include "choice.h"
#include "convolution.h"
#include "short_range.h"
#include "tiles.h"

namespace rc_split {

// Tables of one kernel in one precision; made when first asked for.
template <class T> class Tables {
 public:
  explicit Tables(Kernel& kernel) : kernel_(kernel), smoothed_(scheme<T>.shape) {}

  using Table = std::shared_ptr<const ShortRange<T>>;  // one that has been replaced may still be in use

  Table split(int spacing);
  Table direct(std::int64_t tiles_x, std::int64_t tiles_y);
  // Puts the convolution for so many nodes into `held`, and releases the one held before. Products that need the same one can
  // share it, because each product begins with load().
  using Held = std::shared_ptr<Convolution<T>>;
  void convolution(int spacing, std::int64_t nodes_x, std::int64_t nodes_y, Held& held);
  Kernel& kernel() { return kernel_; }

 private:
  struct Recent {
    std::weak_ptr<Convolution<T>> convolution;
    std::int64_t nodes_x = 0, nodes_y = 0;
  };

  Kernel& kernel_;
  Smoothed smoothed_;
  Table direct_, split_[3];
  Recent recent_[3];
};

template <class T> class Product {
 public:
  // spacing: of the coarse grid; 0: the cheapest.
  Product(Tables<T>& tables, int spacing);

  void bind(const Tiles& tiles, const Frame& frame, Targets targets);

  // Takes x, over the domain, as the sources.
  void load(const T* x);
  // One tile of the frame of H x, 16 x 16.
  void tile(TilePlace place, T* out) const;

  bool parallel() const { return plan_.parallel(); }
  int spacing() const { return plan_.spacing; }
  const ShortRange<T>& short_range() const { return *short_range_; }
  // After load(): the smooth part alone. For x >= 0 it is at most the whole less short_range().lowest() sum x. Needs a spacing.
  void smooth_tile(TilePlace place, T* out) const;

 private:
  void make_windows();
  void gather(const T* x);
  void collect_rows();
  std::int64_t nodes_per_tile() const { return side / plan_.spacing; }
  std::int64_t node_rows() const { return frame_.ny * nodes_per_tile() + count_ - nodes_per_tile(); }
  Weights<T> weights() const { return {weights_x_.data(), weights_y_.data(), transposed_.data(), count_, stride_}; }

  Tables<T>& tables_;
  const rc_team& team_;
  Loops<T> loops_;
  int wanted_spacing_;

  const Tiles* tiles_ = nullptr;
  Frame frame_;
  Plan plan_;
  int window_spacing_ = 0;  // the spacing that the weights are for
  typename Tables<T>::Table short_range_;
  std::int64_t count_ = 0, stride_ = 0;  // nodes that a tile spreads to along each axis
  Array<T> weights_x_, weights_y_;       // [16][stride]
  Array<T> transposed_;                  // [count][16]
  typename Tables<T>::Held convolution_;

  // The sources: those of a tile begin where its entries do; rows_[17 tile + r] of them lie before its row r.
  Array<T> values_, patches_;  // patches: [tile][count][stride]
  std::vector<std::uint8_t> cells_;
  std::vector<std::int32_t> rows_;
};

}  // namespace rc_split
