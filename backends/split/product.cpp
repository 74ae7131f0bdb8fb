// The short range of H is summed over neighbours, the smooth rest interpolated from a coarse grid, where it is a convolution.
#include "product.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rc_split {

namespace {

constexpr std::int64_t row_marks = side + 1;

int slot(int spacing) { return spacing == 4 ? 0 : spacing == 8 ? 1 : 2; }

}  // namespace

template <class T> typename Tables<T>::Table Tables<T>::split(int spacing) {
  auto& table = split_[slot(spacing)];
  if (!table) table = std::make_shared<const ShortRange<T>>(kernel_, smoothed_, cutoff<T>(spacing, kernel_.hx(), kernel_.hy()));
  return table;
}

template <class T> typename Tables<T>::Table Tables<T>::direct(std::int64_t tiles_x, std::int64_t tiles_y) {
  if (!direct_ || direct_->range().x < tiles_x - 1 || direct_->range().y < tiles_y - 1)
    direct_ = std::make_shared<const ShortRange<T>>(kernel_, tiles_x, tiles_y);
  return direct_;
}

template <class T> void Tables<T>::convolution(int spacing, std::int64_t nodes_x, std::int64_t nodes_y, Held& held) {
  Recent& recent = recent_[slot(spacing)];
  Held found = recent.nodes_x == nodes_x && recent.nodes_y == nodes_y ? recent.convolution.lock() : nullptr;
  held = std::move(found);
  if (held) return;
  const FarField& far = kernel_.far();
  const double hx = spacing * kernel_.hx(), hy = spacing * kernel_.hy(), rc = cutoff<T>(spacing, kernel_.hx(), kernel_.hy());
  const auto axis = [&](std::int64_t nodes, double h) {
    return Axis{nodes, scheme<T>.bend,
                [window = Window(scheme<T>.nodes, scheme<T>.shape * h / rc)](double theta) { return window.transform(theta); }};
  };
  held = std::make_shared<Convolution<T>>(kernel_.host(), *kernel_.spec().team, axis(nodes_x, hx), axis(nodes_y, hy),
                                          [&](double x, double y) { return far.smooth(hx * x, hy * y, rc, smoothed_); });
  recent = {held, nodes_x, nodes_y};
}

template <class T>
Product<T>::Product(Tables<T>& tables, int spacing)
    : tables_(tables), team_(*tables.kernel().spec().team), loops_(best_loops<T>()), wanted_spacing_(spacing) {}

template <class T> void Product<T>::bind(const Tiles& tiles, const Frame& frame, Targets targets) {
  tiles_ = nullptr;
  frame_ = frame;
  plan_ = choose<T>(tiles, frame, targets, tables_.kernel().hx(), tables_.kernel().hy(), wanted_spacing_);
  short_range_ = plan_.spacing ? tables_.split(plan_.spacing) : tables_.direct(frame.nx, frame.ny);
  const std::int64_t entries = tiles.first(tiles.count());
  make_room(values_, entries);
  cells_.resize(static_cast<std::size_t>(entries));
  rows_.resize(static_cast<std::size_t>(row_marks * tiles.count()));
  if (plan_.spacing) {
    make_windows();
    make_room(patches_, tiles.count() * count_ * stride_);
    const std::int64_t nodes_x = frame.nx * nodes_per_tile() + count_ - nodes_per_tile();
    tables_.convolution(plan_.spacing, nodes_x, node_rows(), convolution_);
  }
  tiles_ = &tiles;
}

template <class T> void Product<T>::make_windows() {
  if (window_spacing_ == plan_.spacing) return;
  window_spacing_ = 0;
  const std::int64_t q = scheme<T>.nodes, spacing = plan_.spacing;
  constexpr std::int64_t vector = 64 / sizeof(T);
  count_ = side / spacing + q - 1;
  stride_ = (count_ + vector - 1) / vector * vector;
  const double rc = cutoff<T>(plan_.spacing, tables_.kernel().hx(), tables_.kernel().hy());
  const auto fill = [&](Array<T>& weights, double h) {
    const Window window(scheme<T>.nodes, scheme<T>.shape * static_cast<double>(spacing) * h / rc);
    weights.assign(static_cast<std::size_t>(side * stride_), T(0));
    for (std::int64_t cell = 0; cell < side; ++cell)
      for (std::int64_t node = 0; node < count_; ++node) {
        const double t = (static_cast<double>(cell) + 0.5) / static_cast<double>(spacing) - static_cast<double>(node - q / 2 + 1);
        weights[static_cast<std::size_t>(cell * stride_ + node)] = static_cast<T>(window(t));
      }
  };
  fill(weights_x_, tables_.kernel().hx());
  fill(weights_y_, tables_.kernel().hy());
  transposed_.assign(static_cast<std::size_t>(count_ * side), T(0));
  for (std::int64_t node = 0; node < count_; ++node)
    for (std::int64_t cell = 0; cell < side; ++cell)
      transposed_[static_cast<std::size_t>(node * side + cell)] = weights_x_[static_cast<std::size_t>(cell * stride_ + node)];
  window_spacing_ = plan_.spacing;
}

template <class T> void Product<T>::load(const T* x) {
  gather(x);
  if (!plan_.spacing) return;
  collect_rows();
  convolution_->columns(node_rows(), parallel());
  constexpr std::int64_t rows_per_item = 8;
  roughcontact::for_each(team_, (node_rows() + rows_per_item - 1) / rows_per_item, parallel(),
                         [&](std::int64_t item, std::int64_t thread) {
                           const std::int64_t end = std::min((item + 1) * rows_per_item, node_rows());
                           for (std::int64_t row = item * rows_per_item; row < end; ++row) convolution_->backward(row, thread);
                         });
}

// Collects the nonzero sources of each tile and spreads them to the tile's patch of nodes.
template <class T> void Product<T>::gather(const T* x) {
  constexpr std::int64_t tiles_per_item = 8;
  const std::int64_t tiles = tiles_->count();
  roughcontact::for_each(team_, (tiles + tiles_per_item - 1) / tiles_per_item, parallel(), [&](std::int64_t item, std::int64_t) {
    for (std::int64_t tile = item * tiles_per_item; tile < std::min((item + 1) * tiles_per_item, tiles); ++tile) {
      const std::int64_t first = tiles_->first(tile), entries = tiles_->entries(tile);
      const std::int64_t* const positions = tiles_->positions(tile);
      const std::uint8_t* const cells = tiles_->cells(tile);
      std::int32_t* const rows = rows_.data() + row_marks * tile;
      std::int32_t count = 0;
      std::int64_t row = 0;
      for (std::int64_t i = 0; i < entries; ++i) {
        const T value = x[positions[i]];
        if (value == 0) continue;
        for (; row <= cells[i] / side; ++row) rows[row] = count;
        values_[static_cast<std::size_t>(first + count)] = value;
        cells_[static_cast<std::size_t>(first + count)] = cells[i];
        ++count;
      }
      for (; row < row_marks; ++row) rows[row] = count;
      if (plan_.spacing && count > 0)
        loops_.spread(weights(), {values_.data() + first, cells_.data() + first, count},
                      patches_.data() + tile * count_ * stride_);
    }
  });
}

// Each item fills the rows of nodes that begin with one row of tiles. It adds the patches of that row and of those above, in a
// fixed order.
template <class T> void Product<T>::collect_rows() {
  const std::int64_t per_tile = nodes_per_tile(), items = (node_rows() + per_tile - 1) / per_tile;
  const std::int64_t above = (count_ - 1) / per_tile;
  roughcontact::for_each(team_, items, parallel(), [&](std::int64_t item, std::int64_t thread) {
    const std::int64_t begin = item * per_tile, end = std::min(begin + per_tile, node_rows());
    for (std::int64_t row = begin; row < end; ++row) std::fill_n(convolution_->row(row), convolution_->stride(), T(0));
    bool empty = true;
    for (std::int64_t y = std::max<std::int64_t>(item - above, 0); y <= std::min(item, frame_.ny - 1); ++y)
      for (auto [tile, last] = tiles_->row(frame_.y + y); tile < last; ++tile) {
        if (rows_[static_cast<std::size_t>(row_marks * tile + side)] == 0) continue;
        empty = false;
        const T* const patch = patches_.data() + tile * count_ * stride_;
        for (std::int64_t row = begin; row < std::min(end, y * per_tile + count_); ++row) {
          const T* const from = patch + (row - y * per_tile) * stride_;
          T* const to = convolution_->row(row) + (tiles_->place(tile).x - frame_.x) * per_tile;
          for (std::int64_t k = 0; k < count_; ++k) to[k] += from[k];
        }
      }
    if (empty) return;
    for (std::int64_t row = begin; row < end; ++row) convolution_->forward(row, thread);
  });
}

template <class T> void Product<T>::smooth_tile(TilePlace place, T* out) const {
  const T* const nodes = convolution_->row((place.y - frame_.y) * nodes_per_tile()) + (place.x - frame_.x) * nodes_per_tile();
  loops_.interpolate(weights(), nodes, convolution_->stride(), out);
}

template <class T> void Product<T>::tile(TilePlace place, T* out) const {
  if (plan_.spacing)
    smooth_tile(place, out);
  else
    std::fill_n(out, cells_of_tile, T(0));
  const Range& range = short_range_->range();
  for (std::int64_t dy = -range.y; dy <= range.y; ++dy) {
    const std::int64_t width = range.width[static_cast<std::size_t>(std::abs(dy))];
    // Rows of the source tile within the range of any row of this one.
    const std::int64_t from = std::clamp<std::int64_t>(-range.rows - dy * side, 0, side);
    const std::int64_t to = std::clamp<std::int64_t>(range.rows + side - dy * side, 0, side);
    for (std::int64_t dx = -width; dx <= width; ++dx) {
      const std::int64_t tile = tiles_->at(place.x + dx, place.y + dy);
      if (tile < 0) continue;
      const std::int32_t* const rows = rows_.data() + row_marks * tile;
      const std::int64_t first = rows[from], count = rows[to] - first;
      if (count <= 0) continue;
      const std::int64_t entry = tiles_->first(tile) + first;
      loops_.direct(short_range_->entry(-dx * side, -dy * side), short_range_->ld(),
                    {values_.data() + entry, cells_.data() + entry, count}, out);
    }
  }
}

template class Tables<float>;
template class Tables<double>;
template class Product<float>;
template class Product<double>;

}  // namespace rc_split
