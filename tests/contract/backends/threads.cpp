#include <atomic>
#include <string>
#include <thread>

#include "cases.h"
#include "fixtures.h"
#include "support/cmocka.hpp"

namespace contract {

namespace {

// Large enough that a backend has reason to share the work.
constexpr std::int64_t nx = 200, ny = 180;

Index scattered_domain() {
  Index domain;
  for (std::int64_t i = 5; i < nx * ny; i += 31 + i % 5) domain.push_back(i);
  return domain;
}

struct Products {
  Vector apply, field, apply_float;
  bool operator==(const Products&) const = default;
};

// repeats: as many more must be the same.
Products products(const rc_backend& backend, StandInHost& host, std::int32_t boundary, int repeats = 20) {
  const Index domain = scattered_domain();
  const Vector x = random_vector(domain.size(), 5);
  Operator op(backend, host, halfspace(boundary, nx, ny, 1.0, 0.9));
  op.bind(domain, boundary == RC_BOUNDARY_PERIODIC ? 0.3 : 0.0);
  Products result{op.apply(x), op.field(x), {}};
  if (backend.apply_float) result.apply_float = op.apply_float(x);
  for (int repeat = 0; repeat < repeats; ++repeat) {
    assert_true(op.apply(x) == result.apply);
    if (backend.apply_float) assert_true(op.apply_float(x) == result.apply_float);
  }
  return result;
}

bool takes(const rc_backend& backend, std::int32_t boundary) {
  return backend.caps & (boundary == RC_BOUNDARY_FREE ? RC_CAP_FREE : RC_CAP_PERIODIC);
}

}  // namespace

void results_do_not_depend_on_threads(const rc_backend& backend) {
  for (std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    if (!takes(backend, boundary)) continue;
    StandInHost host(backend);
    const Products alone = products(backend, host, boundary, 1);
    for (const char* threads : {"2", "3"}) {
      host.set("threads", threads);
      assert_true(products(backend, host, boundary) == alone);
    }
  }
}

void operators_work_side_by_side(const rc_backend& backend) {
  for (std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    if (!takes(backend, boundary)) continue;
    StandInHost host(backend);
    host.set("threads", "2");
    const Products expected = products(backend, host, boundary, 1);
    std::atomic<int> equal{0};
    std::vector<std::thread> users;
    for (int user = 0; user < 4; ++user)
      users.emplace_back([&] { equal += products(backend, host, boundary) == expected ? 1 : 0; });
    for (std::thread& user : users) user.join();
    assert_int_equal(equal, 4);
  }
}

}  // namespace contract
