// A caller's product or matrix with p'Hp <= 0 for a pressure p is refused, whichever solver meets it.
#include <cmath>

#include "honesty_tests.h"
#include "support/contact.h"

namespace pairs {

namespace {

constexpr std::size_t n = 12;

// Positive on constant vectors, so that the first check passes, and negative on alternating ones: H = 1 1' + c I.
struct Indefinite {
  double diagonal;
  static std::int32_t apply(const double* x, double* y, std::int64_t points, void* user) {
    double sum = 0;
    for (std::int64_t i = 0; i < points; ++i) sum += x[i];
    for (std::int64_t i = 0; i < points; ++i) y[i] = sum + static_cast<Indefinite*>(user)->diagonal * x[i];
    return 0;
  }
};

Problem by_product(Indefinite& product) {
  Problem problem;
  problem.system.op = RC_OPERATOR_CALLBACK;
  problem.system.nx = n;
  problem.system.apply = Indefinite::apply;
  problem.system.user = &product;
  problem.gap.assign(n, 10);
  problem.gap[4] = 0;
  return problem;
}

void check_refused(const Answer& answer, const std::string& what) {
  check_status(answer, RC_ERR_NUMERIC, what);
  check(answer.message.find("not positive definite") != std::string::npos, answer.message);
}

// One point carries everything, and p'Hp = (1 + c) p^2 < 0.
void pressures_that_yield_work_are_refused() {
  for (const double scale : {1.0, 1e-180, 1e140}) {
    Indefinite product{-3.5};
    const Problem problem = by_product(product);
    const Contact contact(problem, {"polonsky-keer", "callback"});
    Field p(n, 0.0);
    p[4] = scale;
    check_refused(contact.certify(problem.step(), p), "certify");
  }
  Indefinite definite{3.5};
  const Problem problem = by_product(definite);
  Field p(n, 0.0);
  p[4] = 1e-180;
  check_status(Contact(problem, {"polonsky-keer", "callback"}).certify(problem.step(), p), RC_UNCERTIFIED);
}

// Every pair of unknowns, and the sum of the entries, is as it should be: (1, 1, 1, 0) is not.
void a_solution_of_an_indefinite_matrix_is_refused() {
  const double c = -0.6;
  Field matrix = {1, c, c, 0, c, 1, c, 0, c, c, 1, 0, 0, 0, 0, 5};
  Problem problem;
  problem.system.op = RC_OPERATOR_DENSE;
  problem.system.nx = problem.system.dense_ld = 4;
  problem.system.dense = matrix.data();
  problem.gap = {0, 0, 0, 0};
  problem.target = 1;
  const Contact contact(problem, {"polonsky-keer", "dense"});
  check_refused(contact.certify(problem.step(), {1, 1, 1, 0}), "certify");
  const Answer plain = contact.certify(problem.step(), {1, 0, 0, 1});
  check_status(plain, RC_UNCERTIFIED);
}

void no_solver_certifies_an_indefinite_product() {
  for (const char* solver : {"polonsky-keer", "gp", "admm", "greedy", "nnls"})
    for (const double diagonal : {-0.5, -1.5, -3.5}) {
      Indefinite product{diagonal};
      Problem problem = by_product(product);
      problem.target = 1;
      const Answer answer = solve(problem, {solver, "callback"}, {{RC_OPT_MAX_ITER, "500"}});
      if (answer.status >= 0) {
        double work = 0, sum = 0;
        for (const double p : answer.p) {
          work += diagonal * p * p;
          sum += p;
        }
        check(work + sum * sum > 0, std::string(solver) + ": an answer with p'Hp = " + text(work + sum * sum));
      }
    }
}

}  // namespace

std::vector<Test> not_definite() {
  return RC_TESTS(pressures_that_yield_work_are_refused, a_solution_of_an_indefinite_matrix_is_refused,
                  no_solver_certifies_an_indefinite_product);
}

}  // namespace pairs
