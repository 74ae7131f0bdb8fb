// Near field and limits of the cholmod backend, and what it asks of the BLAS.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "common/products.h"
#include "conjugate_gradients.h"
#include "failure.h"
#include "fixtures.h"
#include "near_field.h"
#include "one_thread.h"
#include "support/cmocka.hpp"
#include "working_set.h"

RC_PLUGIN_LINKAGE rc_status rc_builtin_cholmod(const rc_host*, const rc_plugin**);

extern "C" {
__attribute__((weak)) int omp_get_max_threads(void);
__attribute__((weak)) void omp_set_num_threads(int);
__attribute__((weak)) int openblas_get_parallel(void);
__attribute__((weak)) int openblas_get_num_threads(void);
__attribute__((weak)) void openblas_set_num_threads(int);
}

namespace {

using contract::Index;
using contract::StandInHost;
using contract::Vector;

const rc_backend& backend() {
  const rc_plugin* plugin = nullptr;
  rc_builtin_cholmod(nullptr, &plugin);
  return *plugin->backends[0];
}

Index every_third(std::int64_t n) {
  Index positions;
  for (std::int64_t i = 0; i < n; ++i)
    if (i % 3 != 1) positions.push_back(i);
  return positions;
}

void assert_solves(const contract::Problem& problem, const Index& points, double rho, const Vector& b, const Vector& x) {
  Vector left = problem.matrix().product(points, points, x);
  double largest = 1.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    left[i] += rho * x[i];
    largest = std::max(largest, std::abs(x[i]));
  }
  assert_true(contract::largest_difference(left, b) <= 1e-11 * (problem.matrix().norm() + rho) * largest);
}

void near_field_solves_the_whole_system(void**) {
  for (const char* radius : {"0.4", "1.5", "3", "1000"})
    contract::for_each_problem(backend(), 13, 10, 1.0, 0.8, [&](const contract::Problem& problem) {
      StandInHost host(backend());
      host.set("cholmod.near_field", radius);
      contract::Operator op(backend(), host, problem.system());
      op.bind(problem.all(), problem.zero_mode());
      const Index some = every_third(130);
      const Vector b = contract::random_vector(some.size(), 1), all = contract::random_vector(130, 2);
      for (int repeat = 0; repeat < 2; ++repeat) {
        assert_solves(problem, some, 0.0, b, op.subset(some, b));
        assert_solves(problem, problem.all(), 0.3, all, op.shifted(0.3, all));
      }
    });
}

struct Iterations {
  std::int64_t plain, preconditioned;
};

Iterations iterations(const rc_backend& tested, std::int32_t boundary, std::int64_t side, double radius) {
  StandInHost host(tested);
  const rc_system system = contract::halfspace(boundary, side, side, 1.0, 1.0);
  const rc_operator_spec spec = contract::spec_of(system, host);
  rc_common::Products products(&host, spec, rc_cholmod::component);
  Index index;
  for (std::int64_t i = 0; i < side * side; ++i)
    if (std::hypot(static_cast<double>(i % side - side / 2), static_cast<double>(i / side - side / 2)) <
        0.4 * static_cast<double>(side))
      index.push_back(i);
  const rc_domain domain{sizeof(rc_domain), static_cast<std::int64_t>(index.size()), index.data(), 0.0};
  products.bind(domain);
  const rc_common::MemoryLimit limit(&host, spec, rc_cholmod::component, "cholmod.memory_limit");
  rc_cholmod::Session session;
  const rc_cholmod::Session::Factor near =
      rc_cholmod::near_field(session, limit, spec, products.entries(), products.points(), radius, 0.0);
  const auto multiply = [&](const double* x, double* y) { products.apply(x, y); };
  const Vector b(index.size(), 1.0);
  Vector x(index.size());
  const auto n = static_cast<std::int64_t>(index.size());
  const auto plain = rc_cholmod::conjugate_gradients(n, multiply, {}, b.data(), x.data());
  const auto faster = rc_cholmod::conjugate_gradients(
      n, multiply, [&](double* r) { session.solve(*near, r); }, b.data(), x.data());
  assert_true(plain.residual < 1e-13 && faster.residual < 1e-13);
  return {plain.iterations, faster.iterations};
}

void near_field_saves_iterations(void**) {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC})
    for (const double radius : {3.0, 6.0}) {
      const Iterations count = iterations(backend(), boundary, 48, radius);
      print_message("%s, disc in 48x48, radius %g: %lld iterations instead of %lld\n",
                    boundary == RC_BOUNDARY_FREE ? "free" : "periodic", radius, static_cast<long long>(count.preconditioned),
                    static_cast<long long>(count.plain));
      assert_true(count.preconditioned < count.plain);
    }
}

// The factor of all entries would take 22 GB; that of the near field is a few megabytes. Points are as far apart as the grid is
// wide.
void near_field_works_where_a_full_factor_does_not_fit(void**) {
  constexpr std::int64_t side = 200, n = side * side;
  const Vector b(n, 1.0);
  Vector x(n);
  for (const char* radius : {"0", "4"}) {
    StandInHost host(backend());
    host.set("cholmod.near_field", radius);
    contract::Operator op(backend(), host, contract::halfspace(RC_BOUNDARY_FREE, side, side, 1.0, 1.0));
    op.bind(contract::range(0, n), 0.0, true);
    if (*radius == '0') {
      assert_int_equal(backend().subset(op.handle(), n, contract::range(0, n).data(), b.data(), x.data()), RC_ERR_MEMORY);
      assert_true(StandInHost::message().find("cholmod: the Cholesky factor of 40000 unknowns needs 22400000000 bytes") == 0);
      continue;
    }
    Index some{n - 1};
    for (std::int64_t i = n - 2; i >= 0; --i)
      if (i % side < 30 && i / side < 30) some.insert(some.begin(), i);
    assert_true(op.subset(some, Vector(some.size(), 1.0))[0] > 0.0);
  }
}

void a_near_field_takes_memory_that_grows_with_the_points(void**) {
  StandInHost host(backend());
  host.set("cholmod.memory_limit", "64");
  const rc_system system = contract::halfspace(RC_BOUNDARY_FREE, 200, 200, 1.0, 1.0);
  const rc_operator_spec spec = contract::spec_of(system, host);
  rc_common::Products products(&host, spec, rc_cholmod::component);
  const rc_domain domain{sizeof(rc_domain), 40000, nullptr, 0.0};
  products.bind(domain);
  const rc_common::MemoryLimit limit(&host, spec, rc_cholmod::component, "cholmod.memory_limit");
  rc_cholmod::Session session;
  const auto near = rc_cholmod::near_field(session, limit, spec, products.entries(), products.points(), 3.0, 0.0);
  print_message("40000 points, radius 3: CHOLMOD's peak %zu bytes\n", session.common()->memory_usage);
  assert_true(session.common()->memory_usage < 128u << 20);
}

// Asked between rows of the near field and between iterations.
void a_near_field_stops_when_it_is_asked_to(void**) {
  StandInHost host(backend());
  host.set("cholmod.near_field", "2");
  const rc_system system = contract::halfspace(RC_BOUNDARY_FREE, 12, 12, 1.0, 1.0);
  const Index all = contract::range(0, 144);
  const Vector b(144, 1.0);
  Vector x(144);
  static int asked, allowed;
  int needed = 0;
  for (allowed = 0;; ++allowed) {
    asked = 0;
    rc_operator_spec spec = contract::spec_of(system, host);
    spec.poll = [](const rc_operator_spec*) -> rc_status { return asked++ < allowed ? RC_OK : RC_STOP_CANCELLED; };
    void* self = nullptr;
    const rc_domain domain{sizeof(rc_domain), 144, nullptr, 0.0};
    assert_int_equal(backend().create(&host, &spec, &self), RC_OK);
    assert_int_equal(backend().bind(self, &domain), RC_OK);
    const rc_status status = backend().subset(self, 144, all.data(), b.data(), x.data());
    backend().destroy(self);
    if (status == RC_OK) break;
    assert_int_equal(status, RC_STOP_CANCELLED);
    assert_int_equal(asked, allowed + 1);
    ++needed;
  }
  assert_true(needed > 8);
}

// OpenBLAS takes 128 MiB of addresses at its first call, and tries for ever if it does not get them.
void too_few_addresses_for_the_blas_are_reported(void**) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(30);
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t most = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (64 << 20);
    const rlimit limit{most, most};
    setrlimit(RLIMIT_AS, &limit);
    StandInHost host(backend());
    const rc_system system = contract::halfspace(RC_BOUNDARY_FREE, 12, 12, 1.0, 1.0);
    const rc_operator_spec spec = contract::spec_of(system, host);
    const rc_domain domain{sizeof(rc_domain), 144, nullptr, 0.0};
    void* self = nullptr;
    Vector x(144, 1.0);
    if (backend().create(&host, &spec, &self) != RC_OK || backend().bind(self, &domain) != RC_OK) _exit(1);
    const rc_status status = backend().shifted(self, 1.0, x.data(), x.data());
    _exit(status == (openblas_get_num_threads ? RC_ERR_MEMORY : RC_OK) ? 0 : 2);
  }
  int status = 0;
  assert_int_equal(waitpid(child, &status, 0), child);
  assert_int_equal(status, 0);
}

void the_blas_has_one_thread_meanwhile_and_its_own_number_afterwards(void**) {
  if (openblas_set_num_threads) openblas_set_num_threads(2);
  const int blas = openblas_get_num_threads ? openblas_get_num_threads() : 1;
  if (omp_set_num_threads) omp_set_num_threads(3);
  const auto assert_threads = [](int of_blas, int of_openmp) {
    if (openblas_get_num_threads) assert_int_equal(openblas_get_num_threads(), of_blas);
    if (omp_get_max_threads) assert_int_equal(omp_get_max_threads(), of_openmp);
  };
  {
    const rc_cholmod::OneThread outer;
    { const rc_cholmod::OneThread inner; }
    if (omp_get_max_threads) assert_int_equal(omp_get_max_threads(), 1);
    if (openblas_get_parallel && openblas_get_parallel() == 1) assert_int_equal(openblas_get_num_threads(), 1);
  }
  assert_threads(blas, 3);
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([] {
      for (int i = 0; i < 500; ++i) const rc_cholmod::OneThread one;
    });
  for (std::thread& thread : threads) thread.join();
  assert_threads(blas, 3);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(too_few_addresses_for_the_blas_are_reported),  // first: the BLAS keeps what it has
      cmocka_unit_test(the_blas_has_one_thread_meanwhile_and_its_own_number_afterwards),
      cmocka_unit_test(near_field_solves_the_whole_system),
      cmocka_unit_test(near_field_saves_iterations),
      cmocka_unit_test(near_field_works_where_a_full_factor_does_not_fit),
      cmocka_unit_test(a_near_field_takes_memory_that_grows_with_the_points),
      cmocka_unit_test(a_near_field_stops_when_it_is_asked_to),
  };
  return cmocka_run_group_tests_name("cholmod", tests, nullptr, nullptr);
}
