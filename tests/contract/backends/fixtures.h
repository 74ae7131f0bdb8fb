// Operators of a backend on problems whose matrix is known.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <functional>
#include <string>

#include "matrix.h"
#include "stand_in_host.h"

namespace contract {

// n points whose matrix has rows of `ld` numbers.
rc_system callers_matrix(const Vector& entries, std::int64_t n, std::int64_t ld);

// A system that a backend with this RC_CAP_* bit handles, and its matrix. It may not move.
class Problem {
 public:
  Problem(std::uint64_t cap, std::int64_t nx, std::int64_t ny, double hx, double hy, double zero_mode);
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;

  const rc_system& system() const { return system_; }
  const Matrix& matrix() const { return matrix_; }
  double zero_mode() const { return zero_mode_; }
  Index all() const;

 private:
  double zero_mode_;
  rc_system system_;
  const Matrix& matrix_;
  Vector rows_;  // a caller's matrix: not a number between the rows
};

// On an nx x ny grid, one for each kind of input that the backend takes; periodic ones with and without zero mode.
void for_each_problem(const rc_backend& backend, std::int64_t nx, std::int64_t ny, double hx, double hy,
                      const std::function<void(const Problem&)>& body);

// An operator of the backend. Calls fail the test unless they return RC_OK.
class Operator {
 public:
  Operator(const rc_backend& backend, StandInHost& host, const rc_system& system, const std::string& kernel = "");
  ~Operator();
  Operator(const Operator&) = delete;
  Operator& operator=(const Operator&) = delete;

  // With NULL for the index if `whole`, which must then list every point.
  void bind(const Index& domain, double zero_mode = 0.0, bool whole = false);
  void forget();
  Vector apply(const Vector& x);
  Vector apply_float(const Vector& x);  // x is rounded to single precision first
  Vector field(const Vector& x);
  Vector subset(const Index& positions, const Vector& b);
  Vector shifted(double rho, const Vector& b);
  double norm();
  void screen(const Vector& x, rc_screen& request);
  std::int64_t modelled() { return backend_.modelled(self_); }
  void* handle() const { return self_; }

 private:
  const rc_backend& backend_;
  const rc_system system_;
  std::string kernel_;
  rc::ThreadTeam team_;
  rc_operator_spec spec_;
  void* self_ = nullptr;
  Index domain_;
};

// Subsets of an nx x ny grid: single points, boxes in corners and middle, random points with holes and empty rows, all.
std::vector<Index> domains(std::int64_t nx, std::int64_t ny, unsigned seed);

// What a StandInHost hands to create().
rc_operator_spec spec_of(const rc_system& system, const StandInHost& host);

// Every operation that the backend has, on a domain and then on part of it, with factors that grow, lose points and are cut.
// Takes its memory beforehand and asserts nothing: allocations may be failing.
class Walk {
 public:
  Walk(const Index& domain, std::int64_t points_of_grid);
  // The first failure.
  rc_status operator()(const rc_backend& backend, void* self);
  rc_status from_creation(const rc_backend& backend, const rc_host& host, const rc_operator_spec& spec);

 private:
  Index domain_, half_;
  std::vector<Index> sets_;  // positions
  Vector x_, y_, gap_;
  std::vector<float> single_, product_;
  std::int64_t found_[4];
  double depth_[4];
};

Index range(std::int64_t first, std::int64_t end);

// Whether the backend takes half-space grids.
inline bool takes_grids(const rc_backend& backend) { return backend.caps & (RC_CAP_FREE | RC_CAP_PERIODIC); }

}  // namespace contract
