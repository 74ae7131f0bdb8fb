// Which solver and which backend: as named, or the pair that says it needs least time. By counts and never by clocks, so that the
// choice can be repeated.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "contact/system.h"
#include "operator/operator.h"
#include "registry/options_handle.h"

namespace rc {

class GridProblem;

// Facts about a step before it is solved.
struct StepFacts {
  std::int32_t control = RC_CONTROL_APPROACH;
  std::int64_t candidates = 0;  // points of the trial set
  std::int64_t box = 0;         // points of its bounding box
  double tol = 0;
  bool partial = false;                   // the solver is stopped after some steps, for the pressures that it has by then
  bool few = false;                       // the backend must screen the points that it does not look at
  bool shared = false;                    // processes share the grid by rows
  std::int64_t at_once = 1, threads = 1;  // so many contacts are solved, a thread each or together
};

struct Choice {
  const rc_solver* solver = nullptr;
  const rc_backend* backend = nullptr;
  StepFacts facts;  // for which they were chosen
};

// Why this solver cannot run on a backend with these capabilities; "" if it can.
std::string missing_operation(const rc_solver& solver, std::uint64_t capabilities, bool fallbacks);

// Why this solver cannot keep the system's hardness; "" if it can or there is none.
std::string missing_cap(const rc_solver& solver, const System& system);

// Why this pair cannot solve this system under this control; "" if it can.
std::string obstacle(const rc_solver& solver, const rc_backend& backend, const System& system, std::int32_t control,
                     bool fallbacks);

// Throws Error(NO_SOLVER, NO_BACKEND, INCOMPATIBLE, PLUGIN). "auto" passes over the names of components that failed.
Choice choose(const rc_options& options, const System& system, const StepFacts& facts,
              const std::vector<std::string>& failed = {});

// For a step on these unknowns. partial: for a solver that only tries the grid.
Choice choose_for(const GridProblem& problem, const TrialSet& trial, std::int32_t control, const std::vector<std::string>& failed,
                  bool partial);

// The solver that "auto" chooses inside another solver, on that solver's backend.
const rc_solver& solver_inside(const rc_options& options, const System& system, const StepFacts& facts,
                               const rc_backend& backend);

// The text of rc_contact_explain; "" without a choice.
std::string explained(const rc_options& options, const System& system, const Choice& choice,
                      const std::vector<std::string>& failed);

// The backend named for the certificate. Throws Error(NO_BACKEND, INCOMPATIBLE, PLUGIN).
const rc_backend& certifying_backend(const std::string& name, const rc_options& options, const System& system);

// For a step whose contact may be far sparser than its candidates: a backend that screens the points it does not look at, and the
// solver for the others. Nothing if the options name others, or the grid is too small for that to pay. Of processes that share
// a periodic grid by rows, the backend makes each product with them together.
std::optional<Choice> choose_for_few(const GridProblem& problem, std::int32_t control);
// Whether so many points in contact count as sparse contact. by_rows: every process has all of them, and makes a part of each
// product.
bool are_few(std::int64_t contacts, std::int64_t points, bool by_rows);

}  // namespace rc
