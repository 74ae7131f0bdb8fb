#include "formats/form.h"

#include <Eigen/Dense>
#include <cmath>

namespace rc::formats {

namespace {

constexpr int most_terms = 6;
using Terms = Eigen::Matrix<double, most_terms, 1>;

int number_of_terms(Form form) {
  if (form == Form::quadric) return 6;
  return form == Form::plane ? 3 : 1;
}

// The position of a point on -1 .. 1.
double centred(std::int64_t index, std::int64_t count) {
  return count > 1 ? (2 * static_cast<double>(index) - static_cast<double>(count - 1)) / static_cast<double>(count - 1) : 0;
}

// Legendre polynomials, which are nearly orthogonal over the grid: the normal equations stay well conditioned.
Terms terms_at(double x, double y, int count) {
  Terms terms;
  terms << 1, x, y, 1.5 * x * x - 0.5, x * y, 1.5 * y * y - 0.5;
  terms.tail(most_terms - count).setZero();
  return terms;
}

template <class Visit> void for_each_valid(const Surface& surface, int count, Visit visit) {
  for (std::int64_t iy = 0; iy < surface.ny; ++iy) {
    for (std::int64_t ix = 0; ix < surface.nx; ++ix) {
      const auto i = static_cast<std::size_t>(iy * surface.nx + ix);
      if (!std::isnan(surface.heights[i])) visit(i, terms_at(centred(ix, surface.nx), centred(iy, surface.ny), count));
    }
  }
}

}  // namespace

void remove_form(Form form, Surface& surface) {
  if (form == Form::none) return;
  const int count = number_of_terms(form);

  // If heights are small compared with their mean, a second pass removes the rounding error of the first one.
  for (int pass = 0; pass < 2; ++pass) {
    Eigen::Matrix<double, most_terms, most_terms> products = decltype(products)::Zero();
    Terms moments = Terms::Zero();
    for_each_valid(surface, count, [&](std::size_t i, const Terms& terms) {
      products += terms * terms.transpose();
      moments += surface.heights[i] * terms;
    });
    // The solution of least norm, because a grid of one or two rows leaves terms undetermined.
    const Terms coefficients = products.completeOrthogonalDecomposition().solve(moments);
    for_each_valid(surface, count, [&](std::size_t i, const Terms& terms) { surface.heights[i] -= coefficients.dot(terms); });
  }
}

}  // namespace rc::formats
