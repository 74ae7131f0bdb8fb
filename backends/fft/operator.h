// H of a half-space grid: which transform serves which domain.
#pragma once

#include <cstdint>
#include <optional>
#include <roughcontact/plugin.hpp>

#include "failure.h"
#include "points.h"
#include "transform.h"

namespace rc_fft {

class Operator {
 public:
  static constexpr roughcontact::Component component = rc_fft::component;

  Operator(const rc_host* host, const rc_operator_spec& spec);

  const rc_host* host() const { return host_; }
  std::int64_t modelled() const { return box_.points(); }

  void bind(const rc_domain& domain);
  void apply(const double* x, double* y);
  void field(const double* x, double* y);
  double norm();  // Frobenius, of H[T,T]

 private:
  bool periodic() const { return spec_.system->boundary == RC_BOUNDARY_PERIODIC; }
  void build(std::optional<Transform>& transform, Lengths lengths, std::int64_t rows);
  Transform& field_transform();
  Lengths box_lengths() const;

  const rc_host* host_;
  rc_operator_spec spec_;
  unsigned effort_;
  const rc_team& team_;
  Workspace workspace_;

  Box box_;        // that the domain's products are made on
  Points points_;  // of the domain, in the box
  Points whole_;   // all points of the grid
  double zero_mode_ = 0.0;
  std::optional<Transform> transform_;       // covers the box
  std::optional<Transform> grid_transform_;  // covers the grid, where the other does not
};

}  // namespace rc_fft
