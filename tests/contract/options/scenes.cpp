#include "scenes.h"

#include <algorithm>
#include <cmath>

namespace options {

namespace {

constexpr std::int64_t side = 8, points = side * side;

// Stored influences of the caller's: far points count for little, so that it is positive definite.
double influence(std::int64_t i, std::int64_t j) {
  const double dx = static_cast<double>(i % side - j % side), dy = static_cast<double>(i / side - j / side);
  return std::exp(-0.5 * std::hypot(dx, dy));
}

int32_t multiply(const double* x, double* y, int64_t n, void* user) {
  const auto* matrix = static_cast<const double*>(user);
  for (std::int64_t i = 0; i < n; ++i) {
    y[i] = 0;
    for (std::int64_t j = 0; j < n; ++j) y[i] += matrix[i * n + j] * x[j];
  }
  return 0;
}

}  // namespace

Scene::Scene(const std::string& kind) : gap_(points), matrix_(points * points), p_(points), deformed_(points) {
  for (std::int64_t i = 0; i < points; ++i) {
    gap_[static_cast<std::size_t>(i)] =
        0.5 + 0.25 * std::cos(1.3 * static_cast<double>(i)) + 0.25 * std::sin(0.7 * static_cast<double>(i * i));
    for (std::int64_t j = 0; j < points; ++j) matrix_[static_cast<std::size_t>(i * points + j)] = influence(i, j);
  }
  system_.nx = system_.ny = side;
  if (kind == "periodic") system_.boundary = RC_BOUNDARY_PERIODIC;
  if (kind == "matrix") {
    system_.op = RC_OPERATOR_DENSE;
    system_.dense = matrix_.data();
    system_.dense_ld = points;
  }
  if (kind == "product") {
    system_.op = RC_OPERATOR_CALLBACK;
    system_.apply = multiply;
    system_.user = matrix_.data();
  }
}

std::string Scene::wrong(rc_status status, const rc_result& result, bool memory) const {
  const std::string name = rc_status_name(status), message = rc_last_error();
  if (name == "RC_STATUS_UNKNOWN") return "status " + std::to_string(status);
  if (status != RC_OK && message.empty()) return name + " without a message";
  if (status == RC_ERR_MEMORY && !memory) return "so small a problem needs no such memory: " + message;
  if (status < 0) return "";
  if (!std::all_of(p_.begin(), p_.end(), [](double p) { return std::isfinite(p); }))
    return name + " with pressures that are not finite";
  const double worst = std::max({result.kkt_primal, result.kkt_dual, result.kkt_complementarity, result.kkt_control});
  if (status == RC_OK && !(worst <= result.tolerance)) return "certified beyond its tolerance";
  return "";
}

std::string Scene::judge(const rc_options* options, bool memory) {
  rc_contact* contact = nullptr;
  rc_result result = RC_RESULT_INIT;
  result.p.data = p_.data();
  result.gap.data = deformed_.data();
  rc_status status = rc_contact_create(&system_, options, &contact);
  std::string fault = status == RC_OK ? "" : wrong(status, result, memory);
  const double targets[] = {0.4, 0.6, 1, 2};
  const std::int32_t controls[] = {RC_CONTROL_APPROACH, RC_CONTROL_APPROACH, RC_CONTROL_LOAD, RC_CONTROL_LOAD};
  for (int k = 0; contact && fault.empty() && k < 4; ++k) {
    rc_step step = RC_STEP_INIT;
    step.undeformed_gap.data = gap_.data();
    step.control = controls[k];
    step.target = targets[k];
    status = rc_contact_solve(contact, &step, &result);
    fault = wrong(status, result, memory);
    if (status < 0 || !fault.empty()) continue;
    fault = wrong(rc_contact_certify(contact, &step, &result), result, memory);
  }
  rc_contact_destroy(contact);
  return fault;
}

}  // namespace options
