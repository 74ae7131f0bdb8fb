// A set of points of the grid, as bits.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rc {

class LawPoints {
 public:
  explicit LawPoints(std::int64_t points) : words_(static_cast<std::size_t>((points + 63) / 64)) {}

  void add(std::int64_t point) { words_[static_cast<std::size_t>(point / 64)] |= std::uint64_t{1} << (point % 64); }
  bool has(std::int64_t point) const { return (words_[static_cast<std::size_t>(point / 64)] >> (point % 64) & 1) != 0; }
  bool empty() const {
    return std::all_of(words_.begin(), words_.end(), [](std::uint64_t word) { return word == 0; });
  }
  LawPoints without(const LawPoints& other) const {
    LawPoints rest = *this;
    for (std::size_t i = 0; i < words_.size(); ++i) rest.words_[i] &= ~other.words_[i];
    return rest;
  }
  bool within(const LawPoints& other) const {
    for (std::size_t i = 0; i < words_.size(); ++i)
      if ((words_[i] & ~other.words_[i]) != 0) return false;
    return true;
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace rc
