#include "operator.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <vector>

namespace rc_fft {

namespace {

unsigned planning_effort(const rc_host* host, const rc_options* options) {
  const char* const planning = roughcontact::option_text(host, options, "fft.planning");
  return std::strcmp(planning, "measure") == 0 ? FFTW_MEASURE : FFTW_ESTIMATE;
}

}  // namespace

Operator::Operator(const rc_host* host, const rc_operator_spec& spec)
    : host_(host),
      spec_(spec),
      effort_(planning_effort(host, spec.options)),
      team_(*spec.team),
      whole_(spec.system->nx, spec.system->ny) {
  const rc_system& system = *spec.system;
  if (system.op != RC_OPERATOR_HALFSPACE)
    fail(RC_ERR_INCOMPATIBLE, "only half-space grids can be transformed; use another backend");
  if (std::max(system.nx, system.ny) > longest_axis)
    fail(RC_ERR_SHAPE, "a grid of ", system.nx, "x", system.ny, " points has an axis longer than the limit ", longest_axis,
         "; use a coarser grid");
}

void Operator::bind(const rc_domain& domain) {
  const std::int64_t nx = spec_.system->nx, ny = spec_.system->ny;
  const Box grid{0, 0, nx, ny};
  box_ = periodic() ? grid : bounding_box(domain, nx, ny);
  points_ = domain.index ? Points(domain, box_, nx) : whole_;
  zero_mode_ = domain.zero_mode;
  if (periodic()) {
    build(transform_, {nx, ny}, ny);
    transform_->set_zero_mode(domain.zero_mode);
    return;
  }
  const Lengths needed = box_lengths();
  const Lengths largest{exact_length(0, nx, nx), exact_length(0, ny, ny)};
  build(transform_, choose_lengths(needed, largest, transform_ ? transform_->lengths() : Lengths{}), box_.ny);
}

Lengths Operator::box_lengths() const { return {exact_length(0, box_.nx, box_.nx), exact_length(0, box_.ny, box_.ny)}; }

void Operator::apply(const double* x, double* y) { transform_->multiply(points_, 0, 0, x, points_, y); }

void Operator::field(const double* x, double* y) { field_transform().multiply(points_, box_.x, box_.y, x, whole_, y); }

// The sum of the squares of H's entries between points of the domain is 1' S 1 over the domain, where S(i, j) = H(i, j)^2 depends
// on offsets only, as H does: one product with the transform of the squared coefficients.
double Operator::norm() {
  const Lengths lengths =
      periodic() ? Lengths{box_.nx, box_.ny} : Lengths{fast_length(box_lengths().x), fast_length(box_lengths().y)};
  Transform squares(host_, lengths, box_.ny, effort_, workspace_, team_);
  const double mean = zero_mode_ / (static_cast<double>(spec_.system->nx) * static_cast<double>(spec_.system->ny));
  squares.load_squares(host_, spec_, periodic() ? mean : 0.0);
  const std::vector<double> ones(static_cast<std::size_t>(points_.count()), 1.0);
  std::vector<double> sums(ones.size());
  squares.multiply(points_, 0, 0, ones.data(), points_, sums.data());
  return std::sqrt(std::accumulate(sums.begin(), sums.end(), 0.0));
}

Transform& Operator::field_transform() {
  const std::int64_t nx = spec_.system->nx, ny = spec_.system->ny;
  if (periodic()) return *transform_;
  const Lengths needed{exact_length(box_.x, box_.nx, nx), exact_length(box_.y, box_.ny, ny)};
  if (covers(transform_->lengths(), needed)) {
    grid_transform_.reset();
    return *transform_;
  }
  const Lengths largest{exact_length(0, nx, nx), exact_length(0, ny, ny)};
  build(grid_transform_, choose_lengths(needed, largest, grid_transform_ ? grid_transform_->lengths() : Lengths{}), ny);
  return *grid_transform_;
}

void Operator::build(std::optional<Transform>& transform, Lengths lengths, std::int64_t rows) {
  if (transform && transform->lengths() == lengths) return;
  transform.reset();
  transform.emplace(host_, lengths, rows, effort_, workspace_, team_);
  try {
    if (periodic())
      transform->load_periodic(host_, spec_);
    else
      transform->load_free(host_, spec_);
  } catch (...) {
    transform.reset();
    throw;
  }
}

}  // namespace rc_fft
