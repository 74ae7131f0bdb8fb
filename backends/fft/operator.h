// H of a half-space grid: which transform serves which domain.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <optional>

#include "points.h"
#include "transform.h"
#include "workers.h"

namespace rc_fft {

class Operator {
 public:
  Operator(const rc_host* host, const rc_operator_spec& spec, std::int64_t threads, unsigned effort);

  const rc_host* host() const { return host_; }
  std::int64_t modelled() const { return box_.points(); }

  void bind(const rc_domain& domain);
  void apply(const double* x, double* y);
  void field(const double* x, double* y);

 private:
  bool periodic() const { return spec_.system->boundary == RC_BOUNDARY_PERIODIC; }
  void build(std::optional<Transform>& transform, Lengths lengths, std::int64_t rows);
  Transform& field_transform();

  const rc_host* host_;
  rc_operator_spec spec_;
  unsigned effort_;
  Workers workers_;
  Workspace workspace_;

  Box box_;                                  // that the domain's products are made on
  Points points_;                            // of the domain, in the box
  Points whole_;                             // all points of the grid
  std::optional<Transform> transform_;       // covers the box
  std::optional<Transform> grid_transform_;  // covers the grid, where the other does not
};

}  // namespace rc_fft
