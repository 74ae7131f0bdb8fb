// Every solver on every backend, in both controls, on every reference case: as a half-space grid, as the caller's dense matrix
// and as the caller's product. Periodic pairs, which have no reference case, solve a generated surface judged by naive code.
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <set>

#include "naive.h"
#include "registry.h"
#include "shared_cases.h"
#include "surfaces.h"

namespace pairs {

namespace {

// Allowed |p - p_ref| / max p: exact solvers on a factoring backend, others on it, matrix-free backends.
constexpr double exact = 1e-11, dense = 1e-9, iterative = 1e-8;

bool stores_matrix(const Pair& pair) { return pair.backend != "fft" && pair.backend != "split" && pair.backend != "callback"; }

double accuracy_of(const Pair& pair, std::int32_t control) {
  if (!stores_matrix(pair)) return iterative;
  return pair.solver == "nnls" && control == RC_CONTROL_DISPLACEMENT ? exact : dense;
}

const Settings unrepaired = {{"greedy.repair", "0"}};  // of no other solver

std::set<std::string> groups_run;

// The influence matrix of the case's unmasked points, from the library's coefficients.
struct Matrix {
  std::int64_t n = 0;
  Field entries;
};

Matrix matrix_of(const SharedCase& shared) {
  const rc_system& s = shared.problem.system;
  Field table(shared.problem.points());
  check(rc_kernel_coefficients(shared.problem.kernel.c_str(), s.hx, s.hy, s.nx, s.ny, table.data()) == RC_OK, rc_last_error());
  Matrix matrix{shared.rows * shared.columns, {}};
  for (std::int64_t i = 0; i < matrix.n; ++i)
    for (std::int64_t j = 0; j < matrix.n; ++j) {
      const std::int64_t dy = std::abs(i / shared.columns - j / shared.columns),
                         dx = std::abs(i % shared.columns - j % shared.columns);
      matrix.entries.push_back(table[static_cast<std::size_t>((dy * s.nx + dx) * shared.spacing)] / s.modulus);
    }
  return matrix;
}

std::int32_t multiply(const double* x, double* y, std::int64_t n, void* user) {
  const double* row = static_cast<const Matrix*>(user)->entries.data();
  for (std::int64_t i = 0; i < n; ++i, row += n) {
    y[i] = 0;
    for (std::int64_t j = 0; j < n; ++j) y[i] += row[j] * x[j];
  }
  return 0;
}

// Keeps p, load and counts; the system becomes the caller's matrix or product.
SharedCase as_operator(SharedCase shared, std::int32_t op, Matrix& matrix) {
  shared.problem.gap = stored_points(shared, shared.problem.gap);
  shared.p = stored_points(shared, shared.p);
  shared.problem.mask.clear();
  rc_system& s = shared.problem.system;
  s.op = op;
  s.nx = shared.columns;
  s.ny = shared.rows;
  s.dense = matrix.entries.data();
  s.dense_ld = matrix.n;
  s.apply = multiply;
  s.user = &matrix;
  return shared;
}

// The caller's products here are plain sums, whose round-off comes near the usual tolerance; those of split are approximate on
// large grids.
double tolerance_of(const Pair& pair, const Problem& problem) {
  if (pair.backend == "split" && problem.points() > 128 * 128) return 1e-10;
  return pair.backend == "callback" ? 2e-12 : 1e-12;
}

void check_solution(const SharedCase& shared, const Pair& pair, const Problem& problem) {
  groups_run.insert(group_name(pair, problem.system, problem.control));
  Settings settings = unrepaired;
  settings.emplace_back(RC_OPT_TOL, text(tolerance_of(pair, problem)));
  const Answer answer = solve(problem, pair, settings);
  if (is_told_failure(pair, problem, answer)) throw Skipped("not certified, as it says: " + std::string(answer.result.note));
  check_status(answer, RC_OK);
  const rc_result& r = answer.result;
  const bool halfspace = problem.system.op == RC_OPERATOR_HALFSPACE;
  check_near(answer.p, shared.p, accuracy_of(pair, problem.control), "p");
  check_near(r.load, shared.load, dense * shared.load, "load");
  check_near(r.displacement, shared.problem.target, dense * shared.depth, "approach");
  check(answer.worst_residual() <= tolerance_of(pair, problem), "the residuals are above the tolerance");
  if (shared.count_is_robust) check_equal(r.contacts, shared.contacts, "contacts");
  if (halfspace && shared.load > 0 && problem.control == RC_CONTROL_DISPLACEMENT)
    check_equal(r.candidates, shared.candidates, "candidates");
  if (shared.load > 0) check(pair.solver == r.solver && pair.backend == r.backend, "the result names another pair");
}

std::string too_large(const SharedCase& shared, const Pair& pair, std::int32_t op, std::int32_t control) {
  const std::int64_t n = shared.rows * shared.columns;
  const bool under_load =
      control == RC_CONTROL_LOAD && (op == RC_OPERATOR_DENSE ? n >= 48 * 48 : stores_matrix(pair) && n >= 64 * 64);
  if (!full() && (under_load || (pair.backend == "cholmod" && n > 4096)))
    return "most of the time of all cases together is that of the largest; RC_TEST_FULL=1 runs them";
  if (quick() && n > 1024) return "left out of the reduced set: " + std::to_string(n) + " points";
  if (op == RC_OPERATOR_DENSE && n > 4096)
    return "a dense matrix of " + std::to_string(n) + " points, all of them candidates, takes minutes";
  if (stores_matrix(pair) && multiplies_often(pair) && n > 4096)
    return "hundreds of products with the stored matrix of up to " + std::to_string(n) + " points take minutes";
  if (op == RC_OPERATOR_CALLBACK && n > 1024) return "naive products of " + std::to_string(n) + " points take minutes";
  return "";
}

void run_case(const SharedCase& shared, const Pair& pair, std::int32_t op, std::int32_t control, double load) {
  if (const std::string reason = too_large(shared, pair, op, control); !reason.empty()) throw Skipped(reason);
  Matrix matrix;
  SharedCase given = shared;
  if (op != RC_OPERATOR_HALFSPACE) {
    matrix = matrix_of(shared);
    given = as_operator(shared, op, matrix);
  }
  check_solution(given, pair, control == RC_CONTROL_LOAD ? at_load(given.problem, load) : given.problem);
}

void solve_periodic(const Pair& pair, std::int32_t control) {
  Problem problem = rough_problem(12, 10, RC_BOUNDARY_PERIODIC, 0.5, 0.75);
  problem.target *= 1.6;
  if (control == RC_CONTROL_LOAD) problem = at_load(problem, 20);
  groups_run.insert(group_name(pair, problem.system, control));
  const Answer answer = solve(problem, pair, unrepaired);
  if (is_told_failure(pair, problem, answer)) throw Skipped("not certified, as it says: " + std::string(answer.result.note));
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

void check_floor(bool have_cases) {
  std::string missing;
  for (const std::string& name : floor_list())
    if (!groups_run.count(name) && (have_cases || name.find("/periodic/") != std::string::npos)) missing += " " + name;
  check(missing.empty(), "pairs of expected.txt that did not run:" + missing);
}

void add_pair(std::vector<Test>& tests, const Pair& pair, std::int32_t op, std::int32_t control,
              const std::shared_ptr<const SharedCases>& shared) {
  rc_system system = RC_SYSTEM_INIT;
  system.op = op;
  const double one = 1;
  system.dense = &one;
  system.dense_ld = 1;
  system.apply = multiply;
  const std::string group = group_name(pair, system, control);
  if (const std::string reason = obstacle(pair, system, control); !reason.empty()) {
    tests.push_back({group, [reason] { throw Skipped(reason); }});
    return;
  }
  if (!shared) {
    tests.push_back({group, [] { throw Skipped("the reference cases are not at " RC_SHARED_DIR "/cases"); }});
    return;
  }
  std::map<std::string, const SharedCase*> by_name;
  for (const SharedCase& each : shared->cases) {
    by_name[each.name] = &each;
    tests.push_back({group + "/" + each.name, [=, &each] { run_case(each, pair, op, control, each.load); }});
  }
  if (control != RC_CONTROL_LOAD || op != RC_OPERATOR_HALFSPACE) return;
  for (const LoadEntry& entry : shared->load_control)
    tests.push_back({group + "/" + entry.name, [=, &entry, &inputs = *by_name.at(entry.inputs)] {
                       check_near(entry.approach, inputs.problem.target, 1e-15 * entry.approach, "the entry's approach");
                       check_equal(entry.contacts, inputs.contacts, "the entry's contacts");
                       run_case(inputs, pair, op, control, entry.load);
                     }});
}

std::vector<Test> all_tests(const std::shared_ptr<const SharedCases>& shared) {
  std::vector<Test> tests;
  if (shared)
    tests.push_back({"there_are_29_reference_cases", [&shared = *shared] {
                       check_equal(static_cast<std::int64_t>(shared.cases.size()), 29, "cases");
                       check_equal(static_cast<std::int64_t>(shared.load_control.size()), 6, "load_control");
                     }});
  rc_system periodic = RC_SYSTEM_INIT;
  periodic.boundary = RC_BOUNDARY_PERIODIC;
  for (const Pair& pair : all_pairs())
    for (const std::int32_t control : controls) {
      for (const std::int32_t op : {RC_OPERATOR_HALFSPACE, RC_OPERATOR_DENSE, RC_OPERATOR_CALLBACK})
        add_pair(tests, pair, op, control, shared);
      const std::string group = group_name(pair, periodic, control), reason = obstacle(pair, periodic, control);
      tests.push_back({reason.empty() ? group + "/rough" : group, [=] {
                         if (!reason.empty()) throw Skipped(reason);
                         solve_periodic(pair, control);
                       }});
    }
  return tests;
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  std::shared_ptr<const SharedCases> shared;
  if (auto cases = read_shared_cases()) shared = std::make_shared<const SharedCases>(std::move(*cases));
  std::vector<Test> tests = all_tests(shared);
  // After all others, as it asks which of them ran; a filter leaves them out.
  if (argc == 1) tests.push_back({"no_pair_of_the_floor_list_has_vanished", [&] { check_floor(shared != nullptr); }});
  return run_group("pairs.cases", tests, argc, argv);
}
