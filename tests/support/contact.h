// The C interface with ownership: a problem, options as text, a contact, an answer that holds its arrays.
#pragma once

#include <roughcontact/registry.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/harness.h"
#include "support/unit_system.h"

namespace pairs {

struct Problem {
  rc_system system = support::unit_system();
  std::string kernel = "auto";
  Field gap;
  std::vector<std::uint8_t> mask;
  std::int32_t control = RC_CONTROL_APPROACH;
  double target = 0;

  std::size_t points() const { return static_cast<std::size_t>(system.nx * system.ny); }
  double cell_area() const { return system.hx * system.hy; }
  bool periodic() const { return system.op == RC_OPERATOR_HALFSPACE && system.boundary == RC_BOUNDARY_PERIODIC; }
  bool semi_periodic() const {
    return system.op == RC_OPERATOR_HALFSPACE &&
           (system.boundary == RC_BOUNDARY_PERIODIC_X || system.boundary == RC_BOUNDARY_PERIODIC_Y);
  }
  bool included(std::size_t i) const { return mask.empty() || mask[i] != 0; }
  double lowest_gap() const;
  rc_step step() const;
};

struct Answer {
  rc_status status = RC_ERR_INTERNAL;
  rc_result result = {};
  Field p, gap;
  std::string message;

  double worst_residual() const;
};

struct Pair {
  std::string solver, backend;
  std::string name() const { return solver + "*" + backend; }
};
inline const Pair automatic{"auto", "auto"};

using Settings = std::vector<std::pair<std::string, std::string>>;

struct DestroyOptions {
  void operator()(rc_options* options) const { rc_options_destroy(options); }
};
struct DestroyContact {
  void operator()(rc_contact* contact) const { rc_contact_destroy(contact); }
};
struct DestroyContext {
  void operator()(rc_context* context) const { rc_context_destroy(context); }
};
using Options = std::unique_ptr<rc_options, DestroyOptions>;
using Context = std::unique_ptr<rc_context, DestroyContext>;

/** Solver and backend of the pair, tol 1e-12, then the settings. */
Options make_options(const Pair& pair, const std::string& kernel, const Settings& settings = {}, rc_context* context = nullptr);

/** A solver that may fail, see may_fail() of registry.h, gets the option with which it repairs its answer, unless the settings
 *  say otherwise. */
class Contact {
 public:
  Contact(const Problem& problem, const Pair& pair, const Settings& settings = {}, rc_context* context = nullptr);

  rc_contact* handle() const { return contact_.get(); }
  Answer solve(const rc_step& step) const;
  Answer solve(const Problem& problem) const { return solve(problem.step()); }
  Answer certify(const rc_step& step, const Field& p) const;

 private:
  std::size_t points_;
  std::unique_ptr<rc_contact, DestroyContact> contact_;
};

/** A fresh contact, one step. */
Answer solve(const Problem& problem, const Pair& pair, const Settings& settings = {});
/** The same; fails unless certified. */
Answer solved(const Problem& problem, const Pair& pair, const Settings& settings = {});

void check_status(const Answer& answer, rc_status expected, const std::string& what = "status");

/** The load-controlled problem whose answer this is. */
Problem at_load(Problem problem, double load);

}  // namespace pairs
