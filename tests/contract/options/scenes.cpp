#include <algorithm>
#include <cmath>

#include "support/callers_product.h"
#include "support/contact.h"
#include "values.h"

namespace options {

namespace {

constexpr std::int64_t side = 8, points = side * side;

// Stored influences of the caller's: far points count for little, so that it is positive definite.
std::vector<double> influences() {
  std::vector<double> matrix;
  for (std::int64_t i = 0; i < points; ++i)
    for (std::int64_t j = 0; j < points; ++j)
      matrix.push_back(
          std::exp(-0.5 * std::hypot(static_cast<double>(i % side - j % side), static_cast<double>(i / side - j / side))));
  return matrix;
}

// Says what is wrong with the end of one call; "": nothing is. memory: see judge.
std::string wrong(rc_status status, const rc_result& result, const pairs::Field& p, bool memory) {
  const std::string name = rc_status_name(status), message = rc_last_error();
  if (name == "RC_STATUS_UNKNOWN") return "status " + std::to_string(status);
  if (status != RC_OK && message.empty()) return name + " without a message";
  if (status == RC_ERR_MEMORY && !memory) return "so small a problem needs no such memory: " + message;
  if (status < 0) return "";
  if (!std::ranges::all_of(p, [](double each) { return std::isfinite(each); }))
    return name + " with pressures that are not finite";
  const double worst = std::max({result.kkt_primal, result.kkt_dual, result.kkt_complementarity, result.kkt_control});
  if (status == RC_OK && !(worst <= result.tolerance)) return "certified beyond its tolerance";
  return "";
}

}  // namespace

std::string judge(const std::string& kind, const rc_options* options, bool memory) {
  static std::vector<double> matrix = influences();
  pairs::Problem problem;
  rc_system& system = problem.system;
  system.nx = system.ny = side;
  if (kind == "periodic") system.boundary = RC_BOUNDARY_PERIODIC;
  if (kind == "matrix") system.op = RC_OPERATOR_DENSE;
  if (kind == "product") system.op = RC_OPERATOR_CALLBACK;
  system.dense = kind == "matrix" ? matrix.data() : nullptr;
  system.dense_ld = kind == "matrix" ? points : 0;
  system.apply = kind == "product" ? support::multiply : nullptr;
  system.user = matrix.data();
  for (std::int64_t i = 0; i < points; ++i)
    problem.gap.push_back(0.5 + 0.25 * std::cos(1.3 * static_cast<double>(i)) +
                          0.25 * std::sin(0.7 * static_cast<double>(i * i)));
  pairs::Field p(points), gap(points);
  rc_result result = RC_RESULT_INIT;
  result.p.data = p.data();
  result.gap.data = gap.data();
  rc_contact* made = nullptr;
  rc_status status = rc_contact_create(&system, options, &made);
  const std::unique_ptr<rc_contact, pairs::DestroyContact> contact(made);
  if (!made) return wrong(status, result, p, memory);
  for (const auto& [control, target] :
       {std::pair{RC_CONTROL_APPROACH, 0.4}, {RC_CONTROL_APPROACH, 0.6}, {RC_CONTROL_LOAD, 1.0}, {RC_CONTROL_LOAD, 2.0}}) {
    problem.control = control;
    problem.target = target;
    const rc_step step = problem.step();
    status = rc_contact_solve(made, &step, &result);
    std::string fault = wrong(status, result, p, memory);
    if (status >= 0 && fault.empty()) fault = wrong(rc_contact_certify(made, &step, &result), result, p, memory);
    if (!fault.empty()) return fault;
  }
  return "";
}

}  // namespace options
