// Every solver on every backend, in both controls, on every reference case: as a half-space grid, as the caller's dense matrix
// and as the caller's product. Periodic pairs, which have no reference case, solve a generated surface judged by naive code.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <set>

#include "support/callers_product.h"
#include "support/naive.h"
#include "support/reference_cases.h"
#include "support/registry.h"
#include "support/surfaces.h"
#include "support/unit_system.h"

namespace pairs {

namespace {

// Allowed |p - p_ref| / max p: exact solvers on a factoring backend, others on it, matrix-free backends.
constexpr double exact = 1e-11, dense = 1e-9, iterative = 1e-8;

bool stores_matrix(const Pair& pair) { return pair.backend == "dense" || pair.backend == "cholmod"; }

double accuracy_of(const Pair& pair, std::int32_t control) {
  if (!stores_matrix(pair)) return iterative;
  return pair.solver == "nnls" && control == RC_CONTROL_APPROACH ? exact : dense;
}

const Settings unrepaired = {{"greedy.repair", "0"}};  // of no other solver

std::set<std::string> groups_run;              // solved, or told that they have failed
std::map<std::string, std::int64_t> left_out;  // cases by reason, decided where they are listed

// The influence matrix of the case's unmasked points, from the library's coefficients.
struct Matrix {
  std::int64_t n = 0;
  Field entries;
};

Matrix matrix_of(const ReferenceCase& reference) {
  const rc_system& s = reference.problem.system;
  Field table(reference.problem.points());
  check(rc_kernel_coefficients(reference.problem.kernel.c_str(), s.hx, s.hy, s.nx, s.ny, table.data()) == RC_OK, rc_last_error());
  Matrix matrix{reference.rows * reference.columns, {}};
  for (std::int64_t i = 0; i < matrix.n; ++i)
    for (std::int64_t j = 0; j < matrix.n; ++j) {
      const std::int64_t dy = std::abs(i / reference.columns - j / reference.columns),
                         dx = std::abs(i % reference.columns - j % reference.columns);
      matrix.entries.push_back(table[static_cast<std::size_t>((dy * s.nx + dx) * reference.spacing)] / s.modulus);
    }
  return matrix;
}

// Keeps p, load and counts; the system becomes the caller's matrix or product.
ReferenceCase as_operator(ReferenceCase reference, std::int32_t op, Matrix& matrix) {
  reference.problem.gap = stored_points(reference, reference.problem.gap);
  reference.p = stored_points(reference, reference.p);
  reference.problem.mask.clear();
  rc_system& s = reference.problem.system;
  s.op = op;
  s.nx = reference.columns;
  s.ny = reference.rows;
  s.dense = matrix.entries.data();
  s.dense_ld = matrix.n;
  s.apply = support::multiply;
  s.user = matrix.entries.data();
  return reference;
}

// The caller's products here are plain sums, whose round-off comes near the usual tolerance; those of split are approximate on
// large grids.
double tolerance_of(const Pair& pair, const Problem& problem) {
  if (pair.backend == "split" && problem.points() > 128 * 128) return 1e-10;
  return pair.backend == "callback" ? 2e-12 : 1e-12;
}

void check_solution(const ReferenceCase& reference, const Pair& pair, const Problem& problem) {
  Settings settings = unrepaired;
  settings.emplace_back(RC_OPT_TOL, text(tolerance_of(pair, problem)));
  const Answer answer = solve(problem, pair, settings);
  groups_run.insert(group_name(pair, problem.system, problem.control));
  if (is_told_failure(pair, problem, answer)) return report("not certified, as it says: " + std::string(answer.result.note));
  check_status(answer, RC_OK);
  const rc_result& r = answer.result;
  const bool halfspace = problem.system.op == RC_OPERATOR_HALFSPACE;
  check_near(answer.p, reference.p, accuracy_of(pair, problem.control), "p");
  check_near(r.load, reference.load, dense * reference.load, "load");
  check_near(r.approach, reference.problem.target, dense * reference.depth, "approach");
  check(answer.worst_residual() <= tolerance_of(pair, problem), "the residuals are above the tolerance");
  if (reference.count_is_robust) check_equal(r.contacts, reference.contacts, "contacts");
  if (halfspace && reference.load > 0 && problem.control == RC_CONTROL_APPROACH)
    check_equal(r.candidates, reference.candidates, "candidates");
  if (reference.load > 0) check(pair.solver == r.solver && pair.backend == r.backend, "the result names another pair");
}

// Backends are proven against each other by tests/contract/backends: two of them run every case, the others these, unless all is
// asked for.
const std::set<std::string> in_short = {"s12_spacing2_eq9", "s20_rect_6x15", "s21_SI_units"};

std::string too_large(const ReferenceCase& reference, const Pair& pair, std::int32_t op, std::int32_t control) {
  const std::int64_t n = reference.rows * reference.columns;
  const bool under_load = control == RC_CONTROL_LOAD && n >= (op == RC_OPERATOR_DENSE ? 48 * 48 : 64 * 64);
  const bool in_full = pair.backend == "dense" || pair.backend == "fft";
  if (!full() && (in_full ? stores_matrix(pair) && (under_load || n > 4096) : !in_short.count(reference.name)))
    return "RC_TEST_FULL=1 runs it";
  if (quick() && n > 1024) return "of more than 1024 points, beyond the reduced set";
  if (op == RC_OPERATOR_DENSE && n > 4096)
    return "a dense matrix of more than 4096 points, all of them candidates, takes minutes";
  if (stores_matrix(pair) && multiplies_often(pair) && n > 4096)
    return "hundreds of products with the stored matrix of more than 4096 points take minutes";
  if (op == RC_OPERATOR_CALLBACK && n > 1024) return "naive products of more than 1024 points take minutes";
  return "";
}

void run_case(const ReferenceCase& reference, const Pair& pair, std::int32_t op, std::int32_t control, double load) {
  Matrix matrix;
  ReferenceCase given = reference;
  if (op != RC_OPERATOR_HALFSPACE) {
    matrix = matrix_of(reference);
    given = as_operator(reference, op, matrix);
  }
  check_solution(given, pair, control == RC_CONTROL_LOAD ? at_load(given.problem, load) : given.problem);
}

void solve_rough(std::int32_t boundary, const Pair& pair, std::int32_t control) {
  Problem problem = rough_problem(12, 10, boundary, 0.5, 0.75);
  problem.target *= boundary == RC_BOUNDARY_PERIODIC ? 1.6 : 3;
  if (control == RC_CONTROL_LOAD) problem = at_load(problem, 20);
  const Answer answer = solve(problem, pair, unrepaired);
  groups_run.insert(group_name(pair, problem.system, control));
  if (is_told_failure(pair, problem, answer)) return report("not certified, as it says: " + std::string(answer.result.note));
  check_status(answer, RC_OK);
  check(answer.result.contacts > 10 && answer.result.contacts < 100, "the surface should be in partial contact");
  check_against_naive(problem, answer);
}

std::vector<std::string> floor_list() {
  std::ifstream in(RC_PAIRS_FLOOR);
  check(static_cast<bool>(in), RC_PAIRS_FLOOR " cannot be read");
  std::vector<std::string> names;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line[0] != '#') names.push_back(line);
  check(!names.empty(), RC_PAIRS_FLOOR " is empty");
  return names;
}

void check_floor() {
  std::string missing;
  for (const std::string& name : floor_list())
    if (!groups_run.count(name)) missing += " " + name;
  check(missing.empty(), "pairs of expected.txt that did not run:" + missing);
}

void add_pair(std::vector<Test>& tests, const Pair& pair, std::int32_t op, std::int32_t control,
              const ReferenceCases& reference) {
  rc_system system = support::unit_system();
  system.op = op;
  const double one = 1;
  system.dense = &one;
  system.dense_ld = 1;
  system.apply = support::multiply;
  const std::string group = group_name(pair, system, control);
  if (const std::string reason = obstacle(pair, system, control); !reason.empty()) {
    ++left_out[reason.substr(0, reason.find(':')) + ", what cannot be combined"];
    return;
  }
  const auto add = [&](const std::string& name, const ReferenceCase& each, const std::function<void()>& body) {
    if (const std::string reason = too_large(each, pair, op, control); !reason.empty())
      ++left_out[reason];
    else
      tests.push_back({group + "/" + name, body});
  };
  std::map<std::string, const ReferenceCase*> by_name;
  for (const ReferenceCase& each : reference.cases) {
    by_name[each.name] = &each;
    add(each.name, each, [=, &each] { run_case(each, pair, op, control, each.load); });
  }
  if (control != RC_CONTROL_LOAD || op != RC_OPERATOR_HALFSPACE) return;
  for (const LoadEntry& entry : reference.load_control)
    add(entry.name, *by_name.at(entry.inputs), [=, &entry, &inputs = *by_name.at(entry.inputs)] {
      check_near(entry.approach, inputs.problem.target, 1e-15 * entry.approach, "the entry's approach");
      check_equal(entry.contacts, inputs.contacts, "the entry's contacts");
      run_case(inputs, pair, op, control, entry.load);
    });
}

std::vector<Test> all_tests(const ReferenceCases& reference) {
  std::vector<Test> tests;
  tests.push_back({"there_are_29_reference_cases", [&reference] {
                     check_equal(static_cast<std::int64_t>(reference.cases.size()), 29, "cases");
                     check_equal(static_cast<std::int64_t>(reference.load_control.size()), 6, "load_control");
                   }});
  for (const Pair& pair : all_pairs())
    for (const std::int32_t control : controls) {
      for (const std::int32_t op : {RC_OPERATOR_HALFSPACE, RC_OPERATOR_DENSE, RC_OPERATOR_CALLBACK})
        add_pair(tests, pair, op, control, reference);
      for (const std::int32_t boundary : {RC_BOUNDARY_PERIODIC, RC_BOUNDARY_PERIODIC_X}) {
        rc_system system = support::unit_system();
        system.boundary = boundary;
        const std::string group = group_name(pair, system, control), reason = obstacle(pair, system, control);
        if (reason.empty())
          tests.push_back({group + "/rough", [=] { solve_rough(boundary, pair, control); }});
        else
          ++left_out[reason.substr(0, reason.find(':')) + ", what cannot be combined"];
      }
    }
  return tests;
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  const ReferenceCases reference = read_reference_cases();
  std::vector<Test> tests = all_tests(reference);
  // After all others, as it asks which of them ran; a filter leaves them out.
  if (argc == 1 && !std::getenv("RC_TEST_SOLVER")) tests.push_back({"no_pair_of_the_floor_list_has_vanished", check_floor});
  for (const auto& [reason, cases] : left_out)
    std::printf("left out: %lld cases: %s\n", static_cast<long long>(cases), reason.c_str());
  return run_group("pairs.cases", tests, argc, argv);
}
