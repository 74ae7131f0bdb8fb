// The gap at some tiles of a surface that processes share by rows. All gather the same tiles, and then have the same values.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace rc {

class StepSurface;

class GatheredTiles {
 public:
  // shared: of this process's rows; it must outlive the tiles.
  explicit GatheredTiles(const StepSurface& shared) : shared_(shared) {}

  const StepSurface& shared() const { return shared_; }
  // Gathers the tiles, or those of the points, that are not here yet. All processes give the same ones.
  void hold(std::span<const std::int64_t> tiles);
  void hold_tiles_of(std::span<const std::int64_t> points);
  // At a point of a tile that is here; NaN: it is masked.
  double gap(std::int64_t point) const;

 private:
  const StepSurface& shared_;
  std::unordered_map<std::int64_t, std::size_t> first_;  // of a tile: its place among the values
  std::vector<double> values_;
};

}  // namespace rc
