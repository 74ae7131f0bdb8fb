// The backend "pairs": products by direct summation over pairs of points, from a table of coefficients. Memory for one grid,
// where a stored matrix takes that squared; time grows with the square of the candidates, spread over the contact's threads.
// Free and periodic boundaries, the same bits for every number of threads.
#include <cstdlib>
#include <roughcontact/plugin.hpp>
#include <vector>

namespace {

class Pairs {
 public:
  static constexpr roughcontact::Component component{"pairs", "use a smaller grid or another backend"};

  Pairs(const rc_host* host, const rc_operator_spec& spec)
      : host_(host),
        team_(*spec.team),
        nx_(spec.system->nx),
        ny_(spec.system->ny),
        parallel_from_(roughcontact::option_int(host, spec.options, "pairs.parallel_from")),
        table_(static_cast<std::size_t>(nx_ * ny_)) {
    roughcontact::check(host->coefficients(host, spec.system, spec.kernel, nx_, ny_, table_.data()));
  }

  // The estimate that `auto` compares: counts times the seconds that one takes, measured once.
  static void score(const rc_facts& facts, rc_estimate& estimate) {
    constexpr double pair = 1.5e-9;  // [s]
    const auto n = static_cast<double>(facts.n), points = static_cast<double>(facts.system->nx * facts.system->ny);
    estimate.product = pair * n * n;
    estimate.field = pair * n * points;
    estimate.bytes = 8 * points;
  }

  const rc_host* host() const { return host_; }

  void bind(const rc_domain& domain) {
    points_.resize(static_cast<std::size_t>(domain.n));
    for (std::int64_t i = 0; i < domain.n; ++i) points_[i] = place(domain.index ? domain.index[i] : i);
    mean_ = domain.zero_mode / static_cast<double>(nx_ * ny_);
  }

  void apply(const double* x, double* y) const {
    rows(modelled(), [&](std::int64_t i) { y[i] = sum(points_[i], x); });
  }

  void field(const double* x, double* y) const {
    rows(nx_ * ny_, [&](std::int64_t i) { y[i] = sum(place(i), x); });
  }

  std::int64_t modelled() const { return static_cast<std::int64_t>(points_.size()); }

 private:
  struct Place {
    std::int64_t x, y;
  };

  Place place(std::int64_t point) const { return {point % nx_, point / nx_}; }

  // A row is summed by one thread, in one order, whichever thread that is.
  template <class Row> void rows(std::int64_t n, const Row& row) const {
    const bool parallel = static_cast<double>(n) * static_cast<double>(modelled()) >= static_cast<double>(parallel_from_);
    roughcontact::for_each(team_, n, parallel, [&](std::int64_t i, std::int64_t) { row(i); });
  }

  double sum(Place at, const double* x) const {
    double total = 0;
    for (std::size_t j = 0; j < points_.size(); ++j) {
      const std::int64_t dx = std::abs(at.x - points_[j].x), dy = std::abs(at.y - points_[j].y);
      total += (table_[dy * nx_ + dx] + mean_) * x[j];
    }
    return total;
  }

  const rc_host* host_;
  const rc_team& team_;
  std::int64_t nx_, ny_, parallel_from_;
  std::vector<double> table_;  // H between two points by their distances in cells
  std::vector<Place> points_;  // the candidates
  double mean_ = 0;            // periodic: what the zero mode adds to every coefficient
};

constexpr rc_component parallel_from = roughcontact::int_option(
    "pairs.parallel_from", "100000", 1, 1e12, "pairs of points from which on a product is shared between threads");
constexpr const rc_component* options[] = {&parallel_from};

constexpr rc_backend backend =
    roughcontact::backend<Pairs>("direct summation over pairs of points, from a table of coefficients", "BSD-3-Clause",
                                 RC_CAP_FREE | RC_CAP_PERIODIC | RC_CAP_THREAD_INVARIANT, options);
constexpr const rc_backend* backends[] = {&backend};
constexpr rc_plugin plugin = roughcontact::plugin("pairs", "1.0", backends);

}  // namespace

RC_PLUGIN_ENTRY(pairs, host, out) {
  static_cast<void>(host);
  *out = &plugin;
  return RC_OK;
}
