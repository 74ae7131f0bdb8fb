// An operator that forgets gives the bits of a new one.
#include <cstdint>
#include <cstring>

#include "cases.h"
#include "fixtures.h"
#include "support/cmocka.hpp"

namespace contract {

namespace {

constexpr std::int64_t nx = 40, ny = 33;

Index box(std::int64_t x0, std::int64_t y0, std::int64_t width, std::int64_t height) {
  Index domain;
  for (std::int64_t iy = y0; iy < y0 + height; ++iy)
    for (std::int64_t ix = x0; ix < x0 + width; ++ix) domain.push_back(iy * nx + ix);
  return domain;
}

// Boxes that grow, and move, a little at a time: lengths that served the one before suit the next.
std::vector<Index> history(std::int64_t first) {
  std::vector<Index> result;
  for (std::int64_t size = first; size <= first + 8; size += 2) result.push_back(box(size / 4, size / 8, size, size));
  result.push_back(box(0, 0, first, first + 1));
  return result;
}

// All products of a history, in the order in which a solver makes them.
Vector products(const rc_backend& backend, Operator& op, std::int64_t first, double zero_mode) {
  Vector all;
  const auto add = [&](const Vector& values) { all.insert(all.end(), values.begin(), values.end()); };
  for (const Index& domain : history(first)) {
    op.bind(domain, zero_mode);
    Vector x(domain.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>((7 * i) % 11) / 11;
    if (backend.caps & RC_CAP_FLOAT) add(op.apply_float(x));
    add(op.field(x));
    add(op.apply(x));
  }
  return all;
}

}  // namespace

void forgetting_equals_a_fresh_operator(const rc_backend& backend) {
  for_each_problem(backend, nx, ny, 1.0, 1.0, [&](const Problem& problem) {
    StandInHost host(backend);
    Operator used(backend, host, problem.system());
    double zero_mode = problem.zero_mode();
    for (const std::int64_t first : {20, 9, 20, 14}) {
      Operator fresh(backend, host, problem.system());
      const Vector expected = products(backend, fresh, first, zero_mode), found = products(backend, used, first, zero_mode);
      assert_true(found.size() == expected.size());
      assert_true(std::memcmp(found.data(), expected.data(), found.size() * sizeof(double)) == 0);
      used.forget();
      if (zero_mode != 0) zero_mode *= 0.5;
    }
  });
}

}  // namespace contract
