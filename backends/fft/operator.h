// H of a half-space grid. It decides which transform is used for which domain.
#pragma once

#include <cstdint>
#include <memory>
#include <roughcontact/plugin.hpp>

#include "cache.h"
#include "common/pool.h"
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
  void forget() { cache_.forget(box_transforms_, grid_transforms_); }
  // Lends its workspace to other operators until the next product.
  void rest();
  void apply(const double* x, double* y);
  void apply_float(const float* x, float* y);
  void field(const double* x, double* y);
  double norm();  // Frobenius, of H[T,T]

 private:
  // Throws if products in single precision are too inaccurate for tol. Each step may have another tol.
  void check_tolerance() const;
  Conversion conversion(const double* x) const;
  template <class Real> double norm_in();
  bool periodic() const { return spec_.system->boundary == RC_BOUNDARY_PERIODIC; }
  template <class Real> Transform<Real>& made(Transforms& transforms, std::int64_t rows);
  template <class Real> std::shared_ptr<const Waves<Real>> waves(Transforms& transforms);
  void wake();
  Transforms& field_transforms();
  Lengths box_lengths() const;   // least lengths for products on the box
  Lengths grid_lengths() const;  // and on the grid

  const rc_host* host_;
  rc_operator_spec spec_;
  bool single_;  // option fft.precision: nothing is kept or made in double precision
  const rc_team& team_;
  Lengths period_;
  Cache cache_;
  std::shared_ptr<rc_common::Pool<Workspace>> pool_;
  Workspace workspace_;
  bool resting_ = true;  // the workspace is empty, for all that is known

  Box box_;        // the domain's products are computed on it
  Points points_;  // of the domain, in the box
  Points whole_;   // all points of the grid
  double zero_mode_ = 0.0;
  std::unique_ptr<Transforms> box_transforms_;   // cover the box
  std::unique_ptr<Transforms> grid_transforms_;  // cover the grid, where the others do not; null where they do
};

}  // namespace rc_fft
