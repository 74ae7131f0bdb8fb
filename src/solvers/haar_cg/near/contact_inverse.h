// The inverse of H on a set of points that changes by a few at a time, in single precision.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rc {

class ContactInverse {
 public:
  // coupling [ny*nx]: H of a grid without periods, at the offsets (ix, iy). most: points that there is memory for.
  ContactInverse(std::int64_t nx, std::int64_t ny, const std::vector<double>& coupling, std::size_t most);

  std::size_t size() const { return x_.size(); }
  std::size_t most() const { return most_; }
  bool has(std::int64_t point) const { return place_[static_cast<std::size_t>(point)] >= 0; }
  // The position of this point in the set's vectors.
  std::size_t place(std::int64_t point) const { return static_cast<std::size_t>(place_[static_cast<std::size_t>(point)]); }
  std::int64_t point(std::size_t place) const { return y_[place] * nx_ + x_[place]; }

  // H between two points of the grid.
  double coupling(std::int64_t a, std::int64_t b) const;
  // to += p times the column of H of that point, at every point of the grid.
  void add_column(std::int64_t point, double p, std::vector<double>& to) const;

  // False, and the inverse is of no more use, if there is no memory for one more or rounding has spoilt the inverse.
  bool add(std::int64_t point);
  void remove(std::int64_t point);
  // x = H^-1 b and, if it is given, y = H^-1 c; all have room for padded() values.
  void multiply(const std::vector<float>& b, std::vector<float>& x, const std::vector<float>* c = nullptr,
                std::vector<float>* y = nullptr) const;
  std::size_t padded() const { return stride_; }

 private:
  float* row(std::size_t place) { return inverse_.data() + place * stride_; }

  const std::int64_t nx_;
  const std::size_t most_, stride_;
  std::vector<float> coupling_, inverse_, column_, change_;
  std::vector<std::int32_t> x_, y_, place_;  // of each point of the set; of each point of the grid its place, or -1
};

}  // namespace rc
