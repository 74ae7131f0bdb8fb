// The reference cases with the solvers' options, which the pairs leave at their defaults, and to the accuracy of exact solvers.
#include "support/contact.h"
#include "support/reference_cases.h"
#include "support/registry.h"

namespace pairs {

namespace {

constexpr double exact = 1e-11, iterative = 1e-9;  // allowed |p - p_ref| / max p

struct Variant {
  std::string name;
  Pair pair;
  Settings settings;
  double accuracy;
  std::int64_t most_candidates;
  const char* why_not_more;
};

const Variant variants[] = {
    {"nnls_single",
     {"nnls", "dense"},
     {{"nnls.pivoting", "single"}},
     exact,
     1600,
     "one solve and one product for every point of the contact set"},
    {"nnls_warmed_up",
     {"nnls", "dense"},
     {{RC_OPT_WARMUP, "gp"}, {RC_OPT_WARMUP_ITERATIONS, "50"}},
     exact,
     3000,
     "dense products"},
    {"nnls_single_warmed_up",
     {"nnls", "dense"},
     {{"nnls.pivoting", "single"}, {RC_OPT_WARMUP, "gp"}},
     exact,
     1600,
     "a solve for every point of the start that does not stay"},
    {"nnls_single_fft",
     {"nnls", "fft"},
     {{"nnls.pivoting", "single"}},
     iterative,
     150,
     "every solve is one of conjugate gradients"},
    {"greedy_cholesky",
     {"greedy", "dense"},
     {{"greedy.inner", "cholesky"}, {"greedy.repair", "0"}},
     exact,
     1600,
     "factors of all candidates"},
    {"greedy_cholesky_fft", {"greedy", "fft"}, {{"greedy.inner", "cholesky"}, {"greedy.repair", "0"}}, iterative, 10000, ""},
    {"greedy_gauss_seidel",
     {"greedy", "dense"},
     {{"greedy.inner", "gauss-seidel"}, {"greedy.repair", "0"}},
     iterative,
     700,
     "stores the matrix"},
    {"greedy_gauss_seidel_fft",
     {"greedy", "fft"},
     {{"greedy.inner", "gauss-seidel"}, {"greedy.repair", "0"}},
     iterative,
     700,
     "stores the matrix"},
    {"greedy_repair", {"greedy", "dense"}, {{"greedy.repair", "1"}}, iterative, 1600, "dense products"},
    {"greedy_repair_fft", {"greedy", "fft"}, {{"greedy.repair", "1"}}, iterative, 10000, ""},
    {"gp_frobenius", {"gp", "dense"}, {{"gp.lipschitz", "frobenius"}}, iterative, 1600, "dense products"},
    {"gp_frobenius_fft", {"gp", "fft"}, {{"gp.lipschitz", "frobenius"}}, iterative, 10000, ""},
    {"gp_without_restart",
     {"gp", "fft"},
     {{"gp.restart", "0"}, {RC_OPT_TOL, "1e-8"}},
     1e-3,
     1600,
     "thousands of iterations even to 1e-8"},
    {"admm_without_relaxation", {"admm", "fft"}, {{"admm.relaxation", "1"}}, iterative, 10000, ""},
    {"admm_rho_1", {"admm", "fft"}, {{"admm.rho", "1"}}, iterative, 10000, ""},
};

void solve_case(const Variant& variant, const ReferenceCase& reference) {
  if (reference.candidates > variant.most_candidates)
    throw Skipped(std::to_string(reference.candidates) + " candidates: " + variant.why_not_more);
  if (quick() && reference.candidates > 300) throw Skipped("left out of the reduced set");
  const Answer answer = solve(reference.problem, variant.pair, variant.settings);
  if (is_told_failure(variant.pair, reference.problem, answer))
    throw Skipped("not certified, as it says: " + std::string(answer.result.note));
  check_status(answer, RC_OK);
  check_near(answer.p, reference.p, variant.accuracy, "p");
  if (reference.count_is_robust && variant.accuracy <= iterative)
    check_equal(answer.result.contacts, reference.contacts, "contacts");
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  std::vector<Test> tests;
  const auto reference = read_reference_cases();
  for (const Variant& variant : variants)
    for (const ReferenceCase& each : reference.cases)
      tests.push_back({variant.name + "/" + each.name, [&] { solve_case(variant, each); }});
  return run_group("solvers.variants", tests, argc, argv);
}
