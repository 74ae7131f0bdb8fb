// The certificate against verify_kkt.py on every reference case: on our pressures, on the trusted ones and on perturbed ones.
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "certificate_tests.h"
#include "support/reference_cases.h"

namespace pairs {

namespace {

using nlohmann::json;

constexpr double loose = 1e-6, certified_tolerance = 1e-9, perturbation = 1e-3;
constexpr double round_off = 2e-13;

struct Judged {
  const ReferenceCase* reference;
  std::string variant;
  Answer answer;
  json verdict;
};

Field perturbed(Field p) {
  for (std::size_t i = 0; i < p.size(); ++i) p[i] *= 1 + (i % 2 == 0 ? perturbation : -perturbation);
  return p;
}

Answer certify(const ReferenceCase& reference, const Field& p) {
  const Problem& problem = reference.problem;
  return Contact(problem, {"auto", "fft"}, {{RC_OPT_TOL, text(certified_tolerance)}}).certify(problem.step(), p);
}

std::vector<Judged> answers_of(const ReferenceCases& reference) {
  std::vector<Judged> all;
  for (const ReferenceCase& each : reference.cases) {
    if (quick() && each.problem.points() > 1024) continue;
    // An early stop leaves residuals well above round-off, so that the comparison says something.
    all.push_back({&each, "stopped_early", solve(each.problem, {"polonsky-keer", "fft"}, {{RC_OPT_TOL, text(loose)}}), {}});
    all.push_back({&each, "solved", solve(each.problem, automatic), {}});
    all.push_back({&each, "trusted", certify(each, each.p), {}});
    if (each.load > 0) all.push_back({&each, "perturbed", certify(each, perturbed(each.p)), {}});
  }
  return all;
}

json job_of(const Judged& judged) {
  const ReferenceCase& reference = *judged.reference;
  const Problem& problem = reference.problem;
  Field u = stored_points(reference, problem.gap), force = stored_points(reference, judged.answer.p);
  for (double& value : u) value = problem.target - value;
  for (double& value : force) value *= problem.cell_area();
  return {{"n1", reference.rows},
          {"n2", reference.columns},
          {"u", u},
          {"p", force},
          {"kernel", problem.kernel},
          {"delta", problem.system.hx},
          {"Es", problem.system.modulus},
          {"spacing", reference.spacing}};
}

struct Scratch {
  std::filesystem::path folder = std::filesystem::temp_directory_path() / ("roughcontact-pairs-" + std::to_string(getpid()));
  Scratch() { std::filesystem::create_directory(folder); }
  ~Scratch() { std::filesystem::remove_all(folder); }
};

// Without NumPy the verdicts stay null.
void judge(std::vector<Judged>& all) {
  const Scratch scratch;
  const std::string jobs = scratch.folder / "jobs.json", results = scratch.folder / "results.json";
  json list = json::array();
  for (const Judged& each : all) list.push_back(job_of(each));
  std::ofstream(jobs) << list;
  const std::string command = std::string(RC_TEST_PYTHON " " RC_PAIRS_VERIFY " ") + jobs + " " + results;
  const int ended = std::system(command.c_str());
  if (WIFEXITED(ended) && (WEXITSTATUS(ended) == 77 || WEXITSTATUS(ended) == 127)) return;
  check(ended == 0, "the independent checker failed: " + command);
  const json verdicts = json::parse(std::ifstream(results));
  for (std::size_t i = 0; i < all.size(); ++i) all[i].verdict = verdicts[i];
}

void check_status_of(const Judged& judged) {
  const Answer& answer = judged.answer;
  check_status(answer, judged.variant == "perturbed" ? RC_UNCERTIFIED : RC_OK);
  if (judged.variant == "trusted")
    check(answer.worst_residual() <= certified_tolerance, "the residuals of the trusted pressures");
  if (judged.variant == "perturbed")
    check(answer.worst_residual() > 1e-2 * perturbation, "the residuals do not show the perturbation");
}

void check_verdict(const Judged& judged) {
  const rc_result& r = judged.answer.result;
  const json& verdict = judged.verdict;
  if (verdict.is_null()) throw Skipped("verify_kkt.py needs python3 with NumPy");
  check_near(r.kkt_primal, verdict["neg_p"], round_off, "kkt_primal and neg_p");
  check_near(r.kkt_dual, verdict["neg_w"], round_off, "kkt_dual and neg_w");
  check_near(r.kkt_complementarity, verdict["compl"], round_off, "kkt_complementarity and its definition");
  check(r.kkt_complementarity <= verdict["w_contact"].get<double>() + round_off, "kkt_complementarity is above w_contact");
  check_near(r.load, verdict["load"], 1e-13 * r.load, "load");
  check_equal(r.contacts, verdict["contacts"], "contacts");
}

std::vector<Test> tests_on_cases() {
  const auto reference = std::make_shared<const ReferenceCases>(read_reference_cases());
  const auto all = std::make_shared<std::vector<Judged>>(answers_of(*reference));
  judge(*all);
  std::vector<Test> tests;
  for (const Judged& each : *all) {
    const std::string name = each.reference->name + "/" + each.variant;
    tests.push_back({"certificate_judges_rightly/" + name, [&each, all, reference] { check_status_of(each); }});
    tests.push_back({"certificate_agrees_with_verify_kkt/" + name, [&each, all, reference] { check_verdict(each); }});
  }
  return tests;
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  std::vector<Test> tests = tests_of_liars();
  for (Test& test : tests_on_cases()) tests.push_back(std::move(test));
  return run_group("pairs.certificate", tests, argc, argv);
}
