// Products in one precision from the tiles of a domain to tiles of a frame: the short range summed directly, the smooth rest over
// a coarse grid.
#pragma once

#include <memory>
#include <optional>

#include "choice.h"
#include "convolution.h"
#include "short_range.h"
#include "tiles.h"

namespace rc_split {

// Tables of one kernel in one precision; made when first asked for.
template <class T> class Tables {
 public:
  Tables(const rc_host* host, const rc_operator_spec& spec);

  using Table = std::shared_ptr<const ShortRange<T>>;  // one that has been replaced may still be in use

  Table split(int spacing, const FarField& far);
  Table direct(std::int64_t tiles_x, std::int64_t tiles_y);
  const Smoothed& smoothed() const { return smoothed_; }

 private:
  const rc_host* host_;
  const rc_operator_spec& spec_;
  Smoothed smoothed_;
  Table direct_, split_[3];
};

template <class T> class Product {
 public:
  // spacing: of the coarse grid; 0: what costs least.
  Product(const rc_host* host, const rc_operator_spec& spec, Tables<T>& tables, int spacing);

  // `targets`: how many tiles of the frame are going to be asked for. far(): the far field, asked for where it is needed.
  template <class Far> void bind(const Tiles& tiles, const Frame& frame, std::int64_t targets, const Far& far) {
    const double hx = spec_.system->hx, hy = spec_.system->hy;
    const Plan plan = choose<T>(tiles, frame, targets, hx, hy, wanted_spacing_);
    bind(tiles, frame, plan, plan.spacing ? &far() : nullptr);
  }

  // Takes x, over the domain, as the sources.
  void load(const T* x);
  // One tile of the frame of H x, 16 x 16.
  void tile(TilePlace place, T* out) const;

  bool parallel() const { return plan_.parallel(); }
  int spacing() const { return plan_.spacing; }
  const ShortRange<T>& short_range() const { return *short_range_; }
  // After load(): nodes [count][ld] that a tile is interpolated from, and the least sum of their weights, which are positive.
  const T* nodes(TilePlace place) const;
  std::int64_t nodes_per_axis() const { return weights().count; }
  std::int64_t nodes_per_tile() const { return side / plan_.spacing; }
  std::int64_t node_stride() const { return convolution_->stride(); }
  std::int64_t node_rows() const { return frame_.ny * nodes_per_tile() + nodes_per_axis() - nodes_per_tile(); }
  double least_weight() const;
  const Frame& frame() const { return frame_; }

 private:
  void bind(const Tiles& tiles, const Frame& frame, const Plan& plan, const FarField* far);
  void make_windows();
  void make_convolution(const FarField& far);
  void gather(const T* x);
  void collect_rows();
  Weights<T> weights() const { return {weights_x_.data(), weights_y_.data(), transposed_.data(), count_, stride_}; }

  const rc_host* host_;
  const rc_operator_spec& spec_;
  Tables<T>& tables_;
  Loops<T> loops_;
  int wanted_spacing_;

  const Tiles* tiles_ = nullptr;
  Frame frame_;
  Plan plan_;
  int coarse_spacing_ = 0;  // what the weights and the convolution are for
  typename Tables<T>::Table short_range_;
  std::int64_t count_ = 0, stride_ = 0;  // nodes that a tile spreads to along each axis
  Array<T> weights_x_, weights_y_;       // [16][stride]
  Array<T> transposed_;                  // [count][16]
  std::optional<Convolution<T>> convolution_;

  // The sources: those of a tile begin where its entries do; rows_[17 tile + r] of them lie before its row r.
  Array<T> values_, patches_;  // patches: [tile][count][stride]
  std::vector<std::uint8_t> cells_;
  std::vector<std::int32_t> rows_;
};

}  // namespace rc_split
