// Eigenvalues of the circular operator: real, because the kernel is even along both axes.
#include <algorithm>

#include "transform.h"

namespace rc_fft {

namespace {

// Coefficients 0..count-1, of both signs of the offset, every `stride`-th value of a circular array; zero beyond.
void extend_evenly(const double* half, std::int64_t half_stride, std::int64_t count, double* circle, std::int64_t stride,
                   std::int64_t length) {
  for (std::int64_t i = 0; i < length; ++i) {
    const std::int64_t offset = std::min(i, length - i);
    circle[i * stride] = offset < count ? half[offset * half_stride] : 0.0;
  }
}

}  // namespace

double Transform::scale() const { return 1.0 / (static_cast<double>(lengths().x) * static_cast<double>(lengths().y)); }

template <class Change>
void Transform::load_coefficients(const rc_host* host, const rc_operator_spec& spec, const Change& change) {
  const std::int64_t nx = layout_.lengths.x, ny = layout_.lengths.y;
  const std::int64_t half_x = layout_.half_x;
  const std::int64_t mx = std::min(half_x, spec.system->nx), my = std::min(layout_.half_y, spec.system->ny);
  roughcontact::check(host->coefficients(host, spec.system, spec.kernel, mx, my, spectrum_.data()));
  change(spectrum_.data(), mx * my);

  // From the table, kept where the eigenvalues will be, along x into rows of half_x, then along y.
  double* const table = workspace_.rows.data();
  roughcontact::for_each(team_, my, parallel_, [&](std::int64_t iy, std::int64_t thread) {
    double* const line = scratch(thread);
    double* const transformed = line + aligned(nx);
    extend_evenly(spectrum_.data() + iy * mx, 1, mx, line, 1, nx);
    plans_->line_to_row(line, transformed);
    for (std::int64_t kx = 0; kx < half_x; ++kx) table[iy * half_x + kx] = transformed[2 * kx];
  });
  const double factor = scale();
  roughcontact::for_each(team_, layout_.blocks(), parallel_, [&](std::int64_t block, std::int64_t thread) {
    const std::int64_t first = block * columns_per_block, last = std::min(first + columns_per_block, half_x);
    double* const column = scratch(thread);
    for (std::int64_t kx = first; kx < last; ++kx) {
      std::fill_n(column, 2 * ny, 0.0);
      extend_evenly(table + kx, half_x, my, column, 2, ny);
      plans_->forward(column);
      for (std::int64_t ky = 0; ky < layout_.half_y; ++ky) eigenvalues(kx)[ky] = factor * column[2 * ky];
    }
  });
}

void Transform::load_free(const rc_host* host, const rc_operator_spec& spec) {
  load_coefficients(host, spec, [](double*, std::int64_t) {});
}

void Transform::load_squares(const rc_host* host, const rc_operator_spec& spec, double constant) {
  load_coefficients(host, spec, [constant](double* table, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) table[i] = (table[i] + constant) * (table[i] + constant);
  });
}

void Transform::load_periodic(const rc_host* host, const rc_operator_spec& spec) {
  double* const table = workspace_.rows.data();
  roughcontact::check(host->symbol(host, spec.system, spec.kernel, table));
  const double factor = scale();
  for (std::int64_t ky = 0; ky < layout_.half_y; ++ky)
    for (std::int64_t kx = 0; kx < layout_.half_x; ++kx) eigenvalues(kx)[ky] = factor * table[ky * layout_.half_x + kx];
}

void Transform::set_zero_mode(double eigenvalue) { *eigenvalues(0) = scale() * eigenvalue; }

}  // namespace rc_fft
