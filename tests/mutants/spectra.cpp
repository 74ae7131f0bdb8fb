#include "contact/spectrum.h"
#include "kernel/lowest_eigenvalue.h"
#include "known_answers.h"
#include "problems.h"

namespace mutants {

void figures_of_spectra(Figures& figures) {
  const auto put = [&figures](const std::string& name, const Small& small) {
    const rc::Spectrum s = spectrum_of(small.system());
    figures.section("spectrum/" + name);
    figures.exact("lowest", s.lowest);
    figures.exact("diagonal", s.diagonal);
    figures.exact("flat_punch", s.flat_punch);
    figures.exact("share", s.galerkin_share);
  };
  for (const rc::kernel::Kernel& kernel : rc::kernel::all())
    for (const double hy : {1.0, 3.0, 1e-2}) {
      if (kernel.square_cells && hy != 1) continue;
      Small small(5, 7);
      small.kernel = kernel.name;
      small.given.hy = hy;
      const bool periodic = kernel.boundary == rc::kernel::Boundary::periodic;
      small.given.boundary = periodic ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE;
      put(std::string(kernel.name) + std::to_string(hy), small);
      figures.exact("of_cells", rc::kernel::lowest_eigenvalue(kernel, 2.5, 2.5 * hy));
      figures.exact("of_galerkin", rc::kernel::share_of_galerkin(kernel));
      for (const auto& [nx, ny] : {std::pair{1, 1}, {1, 2}, {2, 1}, {5, 8}, {4, 3}})
        figures.exact("of_waves" + std::to_string(10 * nx + ny),
                      rc::kernel::lowest_wave_eigenvalue(kernel, 2.5, 2.5 * hy, nx, ny));
    }
  for (const double weakest : {2.0, 1e-3, -0.1, -0.3333, -0.34})
    for (const std::int64_t n : {1, 2, 3, 11}) {
      Small small(n, 1);
      small.make_dense(weakest);
      put("matrix" + std::to_string(weakest) + "/" + std::to_string(n), small);
    }
  Small rows(3, 2);
  rows.make_dense(0.3);
  put("rows", rows);
  Small singular(2, 1);
  singular.make_dense(0);
  singular.matrix = {1, 1, 1, 1};
  singular.given.dense = singular.matrix.data();
  put("singular", singular);
  // Inverse iteration begins on the eigenvector (1, -1/2) and does not see the smaller eigenvalue of (1, 2).
  for (const double smaller : {0.95, 0.7, 0.55, 0.45}) {
    Small unseen(2, 1);
    unseen.make_dense(1);
    unseen.matrix = {smaller + 4, 2 * smaller - 2, 2 * smaller - 2, 4 * smaller + 1};
    unseen.given.dense = unseen.matrix.data();
    put("unseen" + std::to_string(smaller), unseen);
  }
  // Rows of the matrix further apart, and an eigenvector that alternates.
  Small strided(4, 1);
  strided.matrix.assign(4 * 6, 0.0);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) strided.matrix[6 * i + j] = i == j ? 3 + 0.5 * static_cast<double>(i) : 0.25;
  strided.given.op = RC_OPERATOR_DENSE;
  strided.given.dense = strided.matrix.data();
  strided.given.dense_ld = 6;
  put("strided", strided);
  for (const std::int64_t n : {rc::most_factorised_points, rc::most_factorised_points + 1}) {
    Small large(n, 1);
    large.make_dense(0.1);
    rc::System system = large.system();
    if (n > rc::most_factorised_points) put("large", large);
  }
  Small product(3, 1);
  product.given.op = RC_OPERATOR_CALLBACK;
  product.given.apply = [](const double* x, double* y, std::int64_t size, void*) {
    for (std::int64_t i = 0; i < size; ++i) y[i] = 2 * x[i];
    return std::int32_t{0};
  };
  put("product", product);
}

}  // namespace mutants
