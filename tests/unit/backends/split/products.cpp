// Products compared with sums over all sources.
#include <algorithm>
#include <cmath>

#include "scene.h"
#include "support/cmocka.hpp"

namespace split {

namespace {

// What the backend promises, relative to the largest product with the absolute values.
constexpr double accuracy = 3e-11, float_accuracy = 6e-6;

Vector at(const Vector& values, const Index& positions) {
  Vector some;
  for (const std::int64_t i : positions) some.push_back(values[static_cast<std::size_t>(i)]);
  return some;
}

// All products of an operator that is bound to the domain, at some of the points.
void check_products(Operator& op, const Grid& grid, const Reference& reference, const Index& domain, const Vector& x) {
  constexpr std::size_t samples = 400;
  const Index positions = some_of(contract::range(0, static_cast<std::int64_t>(domain.size())), samples);
  Index points;
  for (const std::int64_t i : positions) points.push_back(domain[static_cast<std::size_t>(i)]);
  const Vector expected = reference.product(points, domain, x);
  const Index anywhere = some_of(every_point(grid), samples);
  Vector size = x;
  for (double& value : size) value = std::abs(value);
  const double scale =
      std::max(largest(reference.product(points, domain, size)), largest(reference.product(anywhere, domain, size)));

  const auto check = [&](const char* what, double off, double allowed) {
    if (!(off <= allowed * scale))
      fail_msg("%s, %s, %ld x %ld: off by %.3g of the largest", grid.kernel.c_str(), what, static_cast<long>(grid.nx),
               static_cast<long>(grid.ny), off / scale);
  };
  check("apply", largest_difference(at(op.apply(x), positions), expected), accuracy);
  check("apply_float", largest_difference(at(op.apply_float(x), positions), expected), float_accuracy);
  check("field", largest_difference(at(op.field(x), anywhere), reference.product(anywhere, domain, x)), accuracy);
}

void check_grid(const Grid& grid, const char* spacing, double share, unsigned seed) {
  Random random(seed);
  const Index domain = islands(grid, share, random);
  const Vector x = pressures(domain, random);
  Operator op(grid, spacing);
  op.bind(domain);
  check_products(op, grid, Reference(grid), domain, x);
}

}  // namespace

void every_kernel_is_accurate(void**) {
  for (const char* kernel : {"love", "galerkin", "disc", "punch", "eq9"})
    check_grid({300, 250, 1.0, 1.0, kernel}, "auto", 0.03, 1);
}

void every_spacing_is_accurate(void**) {
  for (const char* spacing : {"4", "8", "16"})
    for (const char* kernel : {"love", "punch"}) check_grid({530, 411, 1.0, 1.0, kernel}, spacing, 0.02, 2);
}

void cells_need_not_be_square(void**) {
  for (const double ratio : {4.0, 1.5, 0.4, 0.25})
    for (const char* kernel : {"love", "galerkin"})
      check_grid({310, 290, std::sqrt(ratio), 1 / std::sqrt(ratio), kernel}, "auto", 0.02, 3);
}

// One cell, one tile, tiles at corners and edges, a line, scattered cells, all cells; pressure of both signs; none.
void any_domain_is_accurate(void**) {
  const Grid grid{201, 187, 1.0, 1.0, "love"};
  const Reference reference(grid);
  const auto box = [&](std::int64_t x, std::int64_t y, std::int64_t nx, std::int64_t ny) {
    Index index;
    for (std::int64_t iy = y; iy < y + ny; ++iy)
      for (std::int64_t ix = x; ix < x + nx; ++ix) index.push_back(iy * grid.nx + ix);
    return index;
  };
  std::vector<Index> domains{box(0, 0, 1, 1),
                             box(200, 186, 1, 1),
                             box(100, 90, 1, 1),
                             box(32, 48, 16, 16),
                             box(0, 0, 16, 16),
                             box(185, 0, 16, 16),
                             box(0, 171, 16, 16),
                             box(192, 176, 9, 11),
                             box(0, 80, 16, 16),
                             box(0, 93, 201, 1),
                             box(100, 0, 1, 187),
                             box(15, 15, 2, 2),
                             {0, 200, 186 * 201, grid.points() - 1}};
  Index scattered;
  for (std::int64_t i = 3; i < grid.points(); i += 211) scattered.push_back(i);
  domains.push_back(scattered);
  domains.push_back(every_point(grid));
  for (const Index& domain : domains)
    for (const char* spacing : {"auto", "8"}) {
      Random random(4);
      Vector x(domain.size());
      for (double& value : x) value = 2 * uniform(random) - 1;
      Operator op(grid, spacing);
      op.bind(domain);
      check_products(op, grid, reference, domain, x);
      const Vector zero(domain.size(), 0.0);
      assert_true(op.apply(zero) == zero);
      assert_true(largest(op.field(zero)) == 0.0);
      assert_true(op.apply_float(zero) == zero);
    }
}

// What is kept from other domains changes nothing: domains that gain tiles around those that they have, up to the whole grid, and
// the first one again.
void a_growing_domain_equals_a_fresh_operator(void**) {
  const Grid grid{620, 560, 1.0, 1.0, "love"};
  Random random(9);
  std::vector<char> inside(static_cast<std::size_t>(grid.points()));
  for (const std::int64_t i : islands({grid.nx / 2, grid.ny / 2, 1.0, 1.0, "love"}, 0.01, random))
    inside[static_cast<std::size_t>(i / (grid.nx / 2) * grid.nx + i % (grid.nx / 2))] = 1;
  for (const char* spacing : {"auto", "16"}) {
    Operator op(grid, spacing);
    std::vector<char> now = inside;
    for (int step = 0; step < 9; ++step) {
      if (step == 8) now = inside;
      Index domain;
      for (std::int64_t i = 0; i < grid.points(); ++i)
        if (now[static_cast<std::size_t>(i)]) domain.push_back(i);
      const Vector x = pressures(domain, random);
      Operator fresh(grid, spacing);
      fresh.bind(domain);
      op.bind(domain);
      assert_true(op.every_product(x, true) == fresh.every_product(x, step % 2 == 0));
      for (int tile = 0; tile < (step < 6 ? 4 : 200); ++tile) {
        const auto near = [&](std::int64_t length) { return std::min<std::int64_t>(length, (step + 5) * length / 11) / 16; };
        const auto column = static_cast<std::int64_t>(random()) % near(grid.nx),
                   row = static_cast<std::int64_t>(random()) % near(grid.ny);
        for (std::int64_t iy = 16 * row; iy < 16 * row + 16; ++iy)
          for (std::int64_t ix = 16 * column; ix < 16 * column + 16; ++ix) now[static_cast<std::size_t>(iy * grid.nx + ix)] = 1;
      }
    }
  }
}

// A long strip: the coarse grid's circle must not bring one end to the other.
void pressure_far_from_the_domain_s_middle_counts(void**) {
  for (const char* spacing : {"4", "16"}) check_grid({2100, 40, 1.0, 1.0, "love"}, spacing, 0.02, 6);
}

void results_do_not_depend_on_threads(void**) {
  const Grid grid{700, 650, 1.0, 1.0, "love"};
  Random random(7);
  const Index domain = islands(grid, 0.05, random);
  const Vector x = pressures(domain, random);
  const auto products = [&](const char* threads) {
    Operator op(grid, "auto", threads);
    op.bind(domain);
    return op.every_product(x);
  };
  const Vector alone = products("1");
  assert_true(products("2") == alone);
  assert_true(products("3") == alone);
}

void long_cells_and_periodic_grids_are_refused(void**) {
  const auto created = [](std::int32_t boundary, double hy) {
    contract::StandInHost host(backend());
    const rc_system system = contract::halfspace(boundary, 300, 300, 2.0, hy);
    const rc_operator_spec spec = contract::spec_of(system, host);
    void* self = nullptr;
    const rc_status status = backend().create(&host, &spec, &self);
    if (status == RC_OK) backend().destroy(self);
    return status;
  };
  assert_int_equal(created(RC_BOUNDARY_FREE, 0.5), RC_OK);
  assert_int_equal(created(RC_BOUNDARY_FREE, 0.499), RC_ERR_INCOMPATIBLE);
  assert_true(contract::StandInHost::message().find("\"fft\"") != std::string::npos);
  assert_int_equal(created(RC_BOUNDARY_PERIODIC, 2.0), RC_ERR_INCOMPATIBLE);
}

void modelled_points_follow_the_domain(void**) {
  const Grid grid{4000, 3000, 1.0, 1.0, "love"};
  Operator op(grid);
  op.bind({0, 17, grid.points() - 1});
  assert_int_equal(op.modelled(), 2 * 256 + 16 * 8);  // 3000 is 187 tiles and half of one
}

const std::vector<CMUnitTest> product_tests = {
    cmocka_unit_test(every_kernel_is_accurate),
    cmocka_unit_test(every_spacing_is_accurate),
    cmocka_unit_test(cells_need_not_be_square),
    cmocka_unit_test(any_domain_is_accurate),
    cmocka_unit_test(a_growing_domain_equals_a_fresh_operator),
    cmocka_unit_test(pressure_far_from_the_domain_s_middle_counts),
    cmocka_unit_test(results_do_not_depend_on_threads),
    cmocka_unit_test(long_cells_and_periodic_grids_are_refused),
    cmocka_unit_test(modelled_points_follow_the_domain),
};

}  // namespace split
