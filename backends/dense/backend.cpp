// Products and solves with stored entries of H: exact, for small problems and as the reference for every other backend.
#include <roughcontact/plugin.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "failure.h"
#include "influence.h"
#include "memory_limit.h"
#include "symmetric_matrix.h"
#include "working_set.h"

namespace rc_dense {

namespace {

class DenseOperator {
 public:
  DenseOperator(const rc_host* host, const rc_operator_spec& spec, MemoryLimit limit)
      : host_(host), system_(spec.system), limit_(limit), influence_(make_influence(host, spec)), working_set_(limit) {}

  const rc_host* host() const { return host_; }
  std::int64_t size() const { return static_cast<std::int64_t>(points_.size()); }

  // The matrix belongs to a domain; the factor to grid points, so that it outlives a change of domain.
  void bind(const rc_domain& domain) {
    const bool same_operator = domain.zero_mode == zero_mode_;
    if (same_operator && is_bound(domain)) return;
    matrix_.reset();
    if (!same_operator) {
      working_set_.clear();
      influence_->set_zero_mode(domain.zero_mode);
      zero_mode_ = domain.zero_mode;
    }
    points_.resize(static_cast<std::size_t>(domain.n));
    for (std::int64_t i = 0; i < domain.n; ++i) points_[static_cast<std::size_t>(i)] = point(domain, i);
  }

  void apply(const double* x, double* y) {
    if (!matrix_) assemble();
    matrix_->multiply(x, y);
  }

  void field(const double* x, double* y) { influence_->field(points_, x, y); }

  void subset(std::span<const std::int64_t> positions, const double* b, double* x) {
    if (positions.empty()) return;
    prepare();
    std::vector<Point> points(positions.size());
    std::transform(positions.begin(), positions.end(), points.begin(),
                   [this](std::int64_t i) { return points_[static_cast<std::size_t>(i)]; });
    working_set_.solve(*influence_, points, b, x, matrix_ ? SymmetricMatrix::bytes(static_cast<double>(size())) : 0.0);
  }

 private:
  Point point(const rc_domain& domain, std::int64_t i) const {
    const std::int64_t number = domain.index ? domain.index[i] : i;
    return {number / system_->nx, number % system_->nx};
  }

  bool is_bound(const rc_domain& domain) const {
    if (domain.n != size()) return false;
    for (std::int64_t i = 0; i < domain.n; ++i)
      if (points_[static_cast<std::size_t>(i)] != point(domain, i)) return false;
    return true;
  }

  // Entries are needed for offsets within the domain's bounding box.
  void prepare() {
    const auto [left, right] = std::minmax_element(points_.begin(), points_.end(), [](Point a, Point b) { return a.x < b.x; });
    influence_->prepare(right->x - left->x + 1, points_.back().y - points_.front().y + 1);
  }

  void assemble() {
    limit_.require("the matrix", size(), SymmetricMatrix::bytes(static_cast<double>(size())), working_set_.bytes());
    prepare();
    const std::span<const Point> points(points_);
    matrix_.emplace(size(), [&](std::int64_t first_row, std::int64_t rows, std::int64_t column, double* out) {
      influence_->column(points.subspan(static_cast<std::size_t>(first_row), static_cast<std::size_t>(rows)),
                         points[static_cast<std::size_t>(column)], out);
    });
  }

  const rc_host* host_;
  const rc_system* system_;
  MemoryLimit limit_;
  std::unique_ptr<Influence> influence_;
  std::vector<Point> points_;  // of the domain, ascending
  double zero_mode_ = 0.0;
  std::optional<SymmetricMatrix> matrix_;  // H[T,T], once a product has been asked for
  WorkingSet working_set_;
};

// No exception leaves the backend. The message of a failed allocation is itself free of allocations.
template <class Action> rc_status guard(const rc_host* host, Action action) {
  const char* const no_memory = "dense: out of memory; use a matrix-free backend or lower dense.memory_limit";
  try {
    action();
    return RC_OK;
  } catch (const Failure& failure) {
    return failure.message.empty() ? failure.code : host->fail(host, failure.code, failure.message.c_str());
  } catch (const std::bad_alloc&) {
    return host->fail(host, RC_ERR_MEMORY, no_memory);
  } catch (const std::length_error&) {
    return host->fail(host, RC_ERR_MEMORY, no_memory);
  } catch (...) {
    return host->fail(host, RC_ERR_INTERNAL, "dense: an exception of unknown type");
  }
}

DenseOperator& operator_of(void* self) { return *static_cast<DenseOperator*>(self); }

rc_status create(const rc_host* host, const rc_operator_spec* spec, void** self) {
  return guard(host, [=] {
    double limit = 0.0;
    const rc_status status = host->option_real(host, spec->options, "dense.memory_limit", &limit);
    if (status != RC_OK) throw Failure{status, {}};
    *self = new DenseOperator(host, *spec, MemoryLimit(limit));
  });
}

void destroy(void* self) { delete static_cast<DenseOperator*>(self); }

rc_status bind(void* self, const rc_domain* domain) {
  return guard(operator_of(self).host(), [=] { operator_of(self).bind(*domain); });
}

rc_status apply(void* self, const double* x, double* y) {
  return guard(operator_of(self).host(), [=] { operator_of(self).apply(x, y); });
}

rc_status field(void* self, const double* x, double* y) {
  return guard(operator_of(self).host(), [=] { operator_of(self).field(x, y); });
}

std::int64_t modelled(void* self) { return operator_of(self).size(); }

rc_status subset(void* self, std::int64_t na, const std::int64_t* a, const double* b, double* x) {
  return guard(operator_of(self).host(), [=] { operator_of(self).subset(std::span(a, static_cast<std::size_t>(na)), b, x); });
}

const rc_option_spec memory_limit = {sizeof(rc_option_spec),
                                     "dense.memory_limit",
                                     "8192",
                                     nullptr,
                                     "most memory for the matrix and the factor together [MiB]",
                                     RC_TYPE_REAL,
                                     1,
                                     1.0,
                                     1e9};
const rc_option_spec* const options[] = {&memory_limit};
const rc_backend backend = {sizeof(rc_backend),
                            "dense",
                            "stored matrix with an updatable Cholesky factor",
                            "BSD-3-Clause AND MPL-2.0",
                            RC_CAP_FREE | RC_CAP_PERIODIC | RC_CAP_DENSE_INPUT | RC_CAP_SUBSET | RC_CAP_THREAD_INVARIANT,
                            1,
                            options,
                            create,
                            destroy,
                            bind,
                            apply,
                            field,
                            modelled,
                            subset,
                            nullptr,
                            nullptr};
const rc_backend* const backends[] = {&backend};
const rc_plugin plugin = {sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "dense", "0.1.0", 1, 0, backends, nullptr};

}  // namespace

}  // namespace rc_dense

RC_PLUGIN_ENTRY(dense, , out) {
  *out = &rc_dense::plugin;
  return RC_OK;
}
