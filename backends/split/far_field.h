// H far from its source, for any kernel: the deflection under a compact source that is symmetric in both axes.
#pragma once

#include <array>
#include <cstdint>
#include <roughcontact/plugin.hpp>
#include <vector>

#include "scheme.h"

namespace rc_split {

// A table of H at offsets 0 <= ix < mx, 0 <= iy < my.
class Coefficients {
 public:
  Coefficients(const rc_host* host, const rc_operator_spec& spec, std::int64_t mx, std::int64_t my);
  double operator()(std::int64_t ix, std::int64_t iy) const { return table_[static_cast<std::size_t>(iy * mx_ + ix)]; }

 private:
  std::int64_t mx_;
  std::vector<double> table_;
};

// Laplace's expansion H = F/r sum_k r^(-2k) sum_(l <= k) c_kl cos(2 l angle), F = hx hy / (pi modulus), with c_kl fitted to a
// table of H. Towards the source it is continued by the potential of point sources with the same moments, in which the smooth
// part replaces 1/r.
class FarField {
 public:
  // Throws if H is not of this form.
  FarField(const rc_host* host, const rc_operator_spec& spec);

  double smooth(double x, double y, double rc, const Smoothed& smoothed) const;
  // Beyond rc plus this length the smooth part is H itself.
  double margin() const { return 2 * step_; }

 private:
  static constexpr int terms = 9;   // up to k = 3
  static constexpr int groups = 6;  // of symmetric point sources: as many as terms up to k = 2
  static constexpr std::size_t points = 13, lanes = (points + Smoothed::lanes - 1) / Smoothed::lanes * Smoothed::lanes;

  double expansion(double x, double y) const;

  double force_, step_;
  std::array<double, terms> c_{};
  std::array<double, lanes> x_{}, y_{}, strength_{};  // of the point sources; those beyond `points` are 0
};

}  // namespace rc_split
