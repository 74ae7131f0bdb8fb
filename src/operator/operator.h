// The C++ view of a backend's operator: products with H on the trial set, scaled to a dimensionless problem.
#pragma once

#include <roughcontact/plugin.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/rows.h"
#include "registry/context.h"

namespace rc {

// The points that may carry pressure. Without an index: all `n` of the grid.
struct TrialSet {
  std::int64_t n = 0;
  std::vector<std::int64_t> index;  // ascending; empty: every point
  double zero_mode = 0;

  std::int64_t point(std::int64_t i) const { return index.empty() ? i : index[static_cast<std::size_t>(i)]; }
  bool operator==(const TrialSet&) const = default;
};

class Operator {
 public:
  // `options`, `team`, `rows` and the context's host must outlive it. The product is divided by `scale` [length per pressure].
  // If rows are shared, vectors have every point of this rank's rows.
  Operator(const rc_backend& backend, const rc_host& host, const rc_system& system, const std::string& kernel,
           const rc_options& options, const rc_team& team, double scale, const Rows& rows = {});
  // An operator for ranks that all have the same trial set and vectors; they make each product together. rows: bound to every
  // point of this rank's rows; it must outlive this one.
  explicit Operator(Operator& rows)
      : backend_(rows.backend_),
        system_(rows.system_),
        kernel_(rows.kernel_),
        scale_(rows.scale_),
        self_(rows.self_),
        rows_(&rows) {}
  ~Operator();
  Operator(const Operator&) = delete;
  Operator& operator=(const Operator&) = delete;

  // Does nothing if the set is the one bound already.
  void bind(const TrialSet& trial);
  const TrialSet& trial() const { return trial_; }

  // Becomes as new, but keeps the count of products. False if the backend cannot do that: then make a new operator.
  bool forget();
  // No product follows soon.
  void rest() {
    room_.reset();
    if (backend_.rest && !rows_) backend_.rest(self_);
  }

  // While it lives, it is asked before every product; a status other than 0 stops it.
  class Watch {
   public:
    Watch(Operator& watched, std::function<rc_status()> ask) : watched_(watched) { watched.ask_ = std::move(ask); }
    ~Watch() { watched_.ask_ = nullptr; }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

   private:
    Operator& watched_;
  };

  rc_status apply(const double* x, double* y);      // y = H[T,T] x
  rc_status apply_float(const float* x, float* y);  // likewise; only with RC_CAP_FLOAT
  // y = H[all,T] x; all: with ranks this rank's rows.
  void field(std::span<const double> x, std::span<double> y);
  // H[T,T] x into request.y, and the points outside T that overlap. Only with RC_CAP_SCREEN. request.unit: that of apply's H x.
  void screen(std::span<const double> x, rc_screen& request);
  std::int64_t modelled() { return backend_.modelled(self_); }

  // H[a,a] x = b for ascending positions a in the trial set: the backend's factorisation, or conjugate gradients on `apply` from
  // the x given until the residual is tol times the largest |b|, or no longer falls.
  rc_status subset(std::span<const std::int64_t> a, const double* b, double* x, double tol = 0);
  bool has_subset() const { return backend_.subset != nullptr; }
  // (H + rho I) x = b: the backend's, or conjugate gradients from the x given until the residual is at most tol times |b|, or no
  // longer falls.
  rc_status shifted(double rho, double tol, const double* b, double* x);
  rc_status norm(double& out);  // Frobenius; only with RC_CAP_NORM
  std::uint64_t capabilities() const { return backend_.caps; }
  std::int64_t points() const { return system_.nx * system_.ny; }

  std::int64_t products() const { return products_; }
  void count(std::int64_t products) { products_ += products; }  // made elsewhere
  const char* name() const { return backend_.name; }
  // Throws for a status < 0 of this operator, with its backend as the component at fault.
  void check(rc_status status, const char* what) const {
    if (status != RC_OK) raise_if_failed(status, what, {.backend = backend_.name});
  }
  // Whether one of the backend's functions returned an error.
  bool failed() const { return failed_; }

 private:
  rc_status seen(rc_status status) {
    failed_ = failed_ || status < 0;
    return status;
  }
  template <class Real> using Multiply = rc_status (*)(void*, const Real*, Real*);
  template <class Real> rc_status product(Multiply<Real> multiply, const Real* x, Real* y);
  void begin_shared() const;
  void locate_own();
  template <class Real> Real* own_values();
  template <class Real> void multiply_rows(Multiply<Real> multiply, const Real* x, Real* y);
  template <class Real> void multiply_together(Multiply<Real> multiply, const Real* x, Real* y);
  rc_status subset_by_products(std::span<const std::int64_t> a, const double* b, double* x, double tol);

  const rc_backend& backend_;
  rc_system system_;
  std::string kernel_;
  // The spec, with the operator that a backend's poll() needs.
  struct Spec : rc_operator_spec {
    const Operator* op;
  };
  Spec spec_{};
  SharedRows shared_;
  double scale_;
  std::function<rc_status()> ask_;
  void* self_ = nullptr;
  TrialSet trial_;
  bool bound_ = false;
  std::int64_t products_ = 0;
  bool failed_ = false;

  Operator* rows_ = nullptr;            // null: products are its own
  std::vector<std::int64_t> first_of_;  // [ranks + 1] positions in the trial set: where the points of each rank's rows begin
  std::unique_ptr<std::byte[]> room_;   // two vectors over this rank's rows
};

}  // namespace rc
