// Which solver and which backend: as named, or by counts. Never by clocks, so that the choice can be repeated.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "contact/system.h"
#include "registry/options_handle.h"

namespace rc {

struct Counts {
  std::int64_t candidates = 0;  // points of the trial set
  std::int64_t box = 0;         // points of its bounding box
  std::int64_t points = 0;      // points of the grid
  double tol = 0;
};

struct Choice {
  const rc_solver* solver = nullptr;
  const rc_backend* backend = nullptr;
};

// The solver that "auto" stands for: on a backend that factors or does not, with unknowns on a grid or without.
const char* suited(bool factors, bool grid);

// Why this solver cannot run on a backend with these capabilities; "" if it can.
std::string missing_operation(const rc_solver& solver, std::uint64_t capabilities, bool fallbacks);

// Why this pair cannot solve this system under this control; "" if it can.
std::string obstacle(const rc_solver& solver, const rc_backend& backend, const System& system, std::int32_t control,
                     bool fallbacks);

// Throws Error(NO_SOLVER, NO_BACKEND, INCOMPATIBLE, PLUGIN). "auto" passes over the names of components that failed.
Choice choose(const rc_options& options, const System& system, std::int32_t control, const Counts& counts,
              const std::vector<std::string>& failed = {});

// The backend named for the certificate. Throws Error(NO_BACKEND, INCOMPATIBLE, PLUGIN).
const rc_backend& certifying_backend(const std::string& name, const rc_options& options, const System& system);

// For a step whose contact may be far sparser than its candidates: a backend that screens the points it does not look at, and the
// solver for the others. Nothing where the options name others, or the grid is too small for that to pay.
std::optional<Choice> choose_for_few(const rc_options& options, const System& system, std::int32_t control,
                                     const std::vector<std::string>& failed);
// Whether contacts this dense are still few.
bool few(std::int64_t contacts, std::int64_t points);

}  // namespace rc
