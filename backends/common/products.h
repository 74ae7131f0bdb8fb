// Products with H on the points of a domain, from a stored matrix or from the entries themselves.
#pragma once

#include <cstdint>
#include <memory>
#include <roughcontact/plugin.hpp>
#include <span>
#include <vector>

#include "common/influence.h"
#include "common/pool.h"

namespace rc_common {

// For rc_backend.score. Throws where the matrix of a grid needs more than the option `key` [MiB] or the machine has.
void estimate_matrix(const rc_facts&, rc_estimate&, const roughcontact::Component&, const char* key);

class Products {
 public:
  enum class Change { none, points, entries };

  Products(const rc_host*, const rc_operator_spec&, const roughcontact::Component&);

  // Returns what has changed. Any change drops the stored matrix.
  Change bind(const rc_domain&);

  std::int64_t size() const { return static_cast<std::int64_t>(points_.size()); }
  std::span<const Point> points() const { return points_; }
  std::vector<Point> points_at(std::span<const std::int64_t> positions) const;
  // Entries between points of the domain.
  const Influence& entries();
  // Entries of H[T,T], by positions in the domain.
  ColumnSource source() { return entries().between(points_); }

  void store();
  void forget() { matrix_.reset(); }
  // Lends a stored matrix that is not large to other operators until the next store().
  void rest();
  double stored_bytes() const { return matrix_ ? bytes() : 0.0; }

  void apply(const double* x, double* y);  // y = H[T,T] x
  void field(const double* x, double* y);  // y = H[all points, T] x
  double norm();                           // Frobenius, of H[T,T]

 private:
  // A matrix of an operator that rests, and what it is of.
  struct Stored {
    std::vector<Point> points;
    double zero_mode = 0.0;
    std::unique_ptr<SymmetricMatrix> matrix;
  };

  double bytes() const { return SymmetricMatrix::bytes(static_cast<double>(size())); }
  Point point(std::int64_t number) const { return {number / system_->nx, number % system_->nx}; }
  bool is_bound(const rc_domain&) const;

  const rc_system* system_;
  std::unique_ptr<Influence> influence_;
  double zero_mode_ = 0.0;
  std::vector<Point> points_;  // of the domain, ascending
  std::unique_ptr<SymmetricMatrix> matrix_;
  std::shared_ptr<Pool<Stored>> pool_;
};

}  // namespace rc_common
