// The caller's matrix-free product as a backend.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <roughcontact/plugin.hpp>
#include <vector>

namespace {

class Callback {
 public:
  static constexpr roughcontact::Component component{"callback", "two vectors over all points do not fit"};

  Callback(const rc_host* host, const rc_operator_spec& spec) : host_(host), system_(spec.system) {
    if (system_->op != RC_OPERATOR_CALLBACK || !system_->apply)
      refuse(RC_ERR_INCOMPATIBLE, "callback: the system has no product of the caller's (rc_system.apply)");
  }

  // As if the caller had a matrix: what a product costs is not known.
  static void score(const rc_facts& facts, rc_estimate& estimate) {
    estimate.product = estimate.field = 1e-9 * static_cast<double>(facts.n) * static_cast<double>(facts.n);
  }
  const rc_host* host() const { return host_; }
  std::int64_t modelled() const { return system_->nx * system_->ny; }

  void bind(const rc_domain& domain) {
    index_.assign(domain.index, domain.index ? domain.index + domain.n : domain.index);
    const auto n = static_cast<std::size_t>(domain.index ? modelled() : 0);
    full_x_.assign(n, 0.0);
    full_y_.resize(n);
  }

  void apply(const double* x, double* y) {
    if (index_.empty()) return multiply(x, y);
    scatter(x);
    multiply(full_x_.data(), full_y_.data());
    for (std::size_t i = 0; i < index_.size(); ++i) y[i] = full_y_[static_cast<std::size_t>(index_[i])];
  }

  void field(const double* x, double* y) {
    if (index_.empty()) return multiply(x, y);
    scatter(x);
    multiply(full_x_.data(), y);
  }

 private:
  // Allocates nothing, because an allocation may be what failed.
  void refuse(rc_status code, const char* message) const { roughcontact::check(host_->fail(host_, code, message)); }

  void multiply(const double* x, double* y) const {
    if (system_->apply(x, y, modelled(), system_->user) != 0)
      refuse(RC_ERR_EXTERNAL, "callback: the caller's apply function reported failure");
    if (!std::all_of(y, y + modelled(), [](double value) { return std::isfinite(value); }))
      refuse(RC_ERR_NUMERIC, "callback: the caller's apply function returned a value that is not finite");
  }

  void scatter(const double* x) {
    for (std::size_t i = 0; i < index_.size(); ++i) full_x_[static_cast<std::size_t>(index_[i])] = x[i];
  }

  const rc_host* host_;
  const rc_system* system_;
  std::vector<std::int64_t> index_;  // empty: every point
  std::vector<double> full_x_, full_y_;
};

constexpr rc_backend backend = roughcontact::backend<Callback>("the caller's own product", "BSD-3-Clause", RC_CAP_CALLBACK);
constexpr const rc_backend* backends[] = {&backend};
constexpr rc_plugin plugin = roughcontact::plugin("callback", "0.1.0", backends);

}  // namespace

RC_PLUGIN_ENTRY(callback, , out) {
  *out = &plugin;
  return RC_OK;
}
