#include "operator.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "platform/memory.h"

namespace rc_fft {

namespace {

// A quarter of the bytes of the whole grid's eigenvalues; at least 1 MiB, because boxes on small grids differ between surfaces.
std::size_t cache_limit(const rc_system& system) {
  const double quarter = 2.0 * static_cast<double>(system.nx) * static_cast<double>(system.ny);
  constexpr double least = 1 << 20, most = 1e18;
  return static_cast<std::size_t>(std::clamp(quarter, least, most));
}

// Products in single precision have errors of up to 5e-7 of the largest entry, see README.md, and so have residuals.
constexpr double least_single_tol = 1e-5;

// Whether to use single precision alone: if the option says so, or if the accuracy goal never needs a tol below that limit. The
// core's tol is a hundredth of a goal for the load, a thousandth of one for the area.
bool in_single_precision(const rc_host* host, const rc_options* options) {
  const char* const named = roughcontact::option_text(host, options, "fft.precision");
  if (std::strcmp(named, "auto") == 0) {
    const bool of_area = std::strcmp(roughcontact::option_text(host, options, "accuracy.of"), "area") == 0;
    return roughcontact::option_real(host, options, "accuracy") >= (of_area ? 1000 : 100) * least_single_tol;
  }
  return std::strcmp(named, "single") == 0;
}

// The eigenvalues alone need this: they are made of a coefficient for each point of the box, or of a period's quarter.
void check_memory(const Box& box, bool periodic) {
  const double bytes = (periodic ? 2.0 : 8.0) * static_cast<double>(box.nx) * static_cast<double>(box.ny);
  if (const double machine = rc_platform::machine_bytes(); bytes > machine)
    fail(RC_ERR_MEMORY, "products on a box of ", box.nx, "x", box.ny, " points need ", bytes, " bytes, this machine has ",
         machine, "; use a coarser grid or a smaller domain");
}

}  // namespace

Operator::Operator(const rc_host* host, const rc_operator_spec& spec)
    : host_(host),
      spec_(spec),
      single_(in_single_precision(host, spec.options)),
      team_(*spec.team),
      period_(periods({spec.system->nx, spec.system->ny}, spec.system->boundary == RC_BOUNDARY_PERIODIC_X,
                      spec.system->boundary == RC_BOUNDARY_PERIODIC_Y)),
      cache_(cache_limit(*spec.system), period_),
      pool_(roughcontact::shared<rc_common::Pool<Workspace>>(host, component, "fft workspaces",
                                                             [] { return std::make_unique<rc_common::Pool<Workspace>>(); })),
      whole_(spec.system->nx, spec.system->ny) {
  const rc_system& system = *spec.system;
  if (system.op != RC_OPERATOR_HALFSPACE)
    fail(RC_ERR_INCOMPATIBLE, "only half-space grids can be transformed; use another backend");
  if (std::max(system.nx, system.ny) > longest_axis)
    fail(RC_ERR_SHAPE, "a grid of ", system.nx, "x", system.ny, " points has an axis longer than the limit ", longest_axis,
         "; use a coarser grid");
  check_tolerance();
}

void Operator::check_tolerance() const {
  if (!single_) return;
  const double tol = roughcontact::option_real(host_, spec_.options, "tol");
  if (tol < least_single_tol)
    fail(RC_ERR_OPTION, "tol = ", tol, " is below ", least_single_tol,
         ", the limit of fft.precision=single; raise tol or set fft.precision=mixed");
}

void Operator::wake() {
  if (resting_) workspace_ = pool_->take();
  resting_ = false;
}

void Operator::rest() {
  if (resting_) return;
  resting_ = true;
  pool_->give(std::exchange(workspace_, {}));
}

Conversion Operator::conversion(const double* x) const {
  return conversion_of(team_, points_.count(), x, zero_mode_, periodic() ? whole_.count() : 0);
}

void Operator::bind(const rc_domain& domain) {
  const std::int64_t nx = spec_.system->nx, ny = spec_.system->ny;
  const Box grid{0, 0, nx, ny};
  box_ = periodic() ? grid : rc_common::bounding_box(domain, nx, ny);
  check_memory(box_, periodic());  // the points take memory for each row
  points_ = domain.index ? Points(domain, box_, nx) : whole_;
  zero_mode_ = domain.zero_mode;
  if (!periodic()) {
    cache_.fit(box_transforms_, box_lengths(), grid_lengths());
    return;
  }
  if (!box_transforms_) box_transforms_ = std::make_unique<Transforms>(Lengths{nx, ny});
  std::apply([&](const auto&... each) { ((each ? each->set_zero_mode(zero_mode_) : void()), ...); }, box_transforms_->made);
}

Lengths Operator::box_lengths() const { return {exact_length(0, box_.nx, box_.nx), exact_length(0, box_.ny, box_.ny)}; }

Lengths Operator::grid_lengths() const {
  const std::int64_t nx = spec_.system->nx, ny = spec_.system->ny;
  return {exact_length(0, nx, nx), exact_length(0, ny, ny)};
}

void Operator::apply(const double* x, double* y) {
  check_tolerance();
  if (single_)
    made<float>(*box_transforms_, box_.ny).multiply(points_, 0, 0, x, points_, y, conversion(x));
  else
    made<double>(*box_transforms_, box_.ny).multiply(points_, 0, 0, x, points_, y);
}

void Operator::apply_float(const float* x, float* y) {
  made<float>(*box_transforms_, box_.ny).multiply(points_, 0, 0, x, points_, y);
}

void Operator::field(const double* x, double* y) {
  check_tolerance();
  const std::int64_t rows = spec_.system->ny;
  if (single_)
    made<float>(field_transforms(), rows).multiply(points_, box_.x, box_.y, x, whole_, y, conversion(x));
  else
    made<double>(field_transforms(), rows).multiply(points_, box_.x, box_.y, x, whole_, y);
}

// The sum of the squares of H's entries between points of the domain is 1' S 1 over the domain, where S(i, j) = H(i, j)^2 depends
// on offsets only, as H does: one product with the transform of the squared coefficients.
double Operator::norm() { return single_ ? norm_in<float>() : norm_in<double>(); }

template <class Real> double Operator::norm_in() {
  const Lengths lengths = periodic() ? Lengths{box_.nx, box_.ny} : fast_lengths(box_lengths(), period_);
  const double mean = zero_mode_ / (static_cast<double>(spec_.system->nx) * static_cast<double>(spec_.system->ny));
  wake();
  const auto waves = std::make_shared<Waves<Real>>(lengths);
  waves->load(Eigenvalues::squares(host_, spec_, periodic() ? mean : 0.0, lengths, workspace_), team_);
  Transform<Real> squares(waves, box_.ny, workspace_, team_);
  const std::vector<double> ones(static_cast<std::size_t>(points_.count()), 1.0);
  std::vector<double> sums(ones.size());
  squares.multiply(points_, 0, 0, ones.data(), points_, sums.data());
  return std::sqrt(std::accumulate(sums.begin(), sums.end(), 0.0));
}

Transforms& Operator::field_transforms() {
  const std::int64_t nx = spec_.system->nx, ny = spec_.system->ny;
  if (periodic()) return *box_transforms_;
  const Lengths needed{exact_length(box_.x, box_.nx, nx), exact_length(box_.y, box_.ny, ny)};
  if (covers(box_transforms_->lengths, needed, period_)) {
    cache_.retire(grid_transforms_);
    return *box_transforms_;
  }
  cache_.fit(grid_transforms_, needed, grid_lengths());
  return *grid_transforms_;
}

// In the precision asked for, from the other one where that is there: the values are the same.
template <class Real> std::shared_ptr<const Waves<Real>> Operator::waves(Transforms& transforms) {
  const Lengths lengths = transforms.lengths;
  const std::string key =
      "fft " + std::to_string(lengths.x) + " " + std::to_string(lengths.y) + " " + std::to_string(sizeof(Real));
  return roughcontact::shared<const Waves<Real>>(host_, component, key, [&] {
    auto result = std::make_unique<Waves<Real>>(lengths);
    if constexpr (std::is_same_v<Real, float>) {
      if (const auto& source = transforms.in<double>()) {
        result->load(source->waves());
        return result;
      }
    }
    result->load(periodic() ? Eigenvalues::periodic(host_, spec_, lengths, workspace_)
                            : Eigenvalues::free(host_, spec_, lengths, workspace_),
                 team_);
    return result;
  });
}

template <class Real> Transform<Real>& Operator::made(Transforms& transforms, std::int64_t rows) {
  wake();
  std::unique_ptr<Transform<Real>>& transform = transforms.in<Real>();
  if (transform) return *transform;
  if (!(transform = cache_.recalled<Real>(transforms.lengths)))
    transform = std::make_unique<Transform<Real>>(waves<Real>(transforms), rows, workspace_, team_);
  if (periodic()) transform->set_zero_mode(zero_mode_);
  return *transform;
}

}  // namespace rc_fft
