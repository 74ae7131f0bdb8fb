// All that is said of a step, and the one writer of rc_result. The caller's arrays are apart from it.
#pragma once

#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "contact/answer.h"
#include "contact/problem.h"
#include "contact/proof/bounds.h"
#include "contact/proof/certificate.h"
#include "contact/slopes/stiffness.h"
#include "contact/surface/outputs.h"
#include "contact/target.h"

namespace rc {

// Sums over the pressures of all processes.
struct Totals {
  double sum = 0;  // [force/length^2]
  double energy = 0, overlap = 0, max_pressure = 0, largest_p = 0, largest_product = 0, on_rim = 0, largest_on_rim = 0;
  std::int64_t contacts = 0, capped = 0;

  Totals operator+(const Totals& b) const;
};

// Where an answer comes from, and how far it may be from that on the whole grid: rc_result.model_nx and what follows it.
struct Accuracy {
  std::int64_t nx = 0, ny = 0;
  double error = 0, area_error = 0, left_out = 0;
};

// The cost of a step.
struct Work {
  std::int64_t iterations = 0, products = 0, levels = 0;
  double seconds = 0, setup_seconds = 0;
};

// As much of the text as fits.
template <std::size_t size> void copy_text(char (&to)[size], const char* text) { std::snprintf(to, size, "%s", text); }

// As many remarks as fit into this many characters, each whole, and how many more there are.
std::string note_from(const std::vector<std::string>& remarks, std::size_t room);

// All that rc_result says.
struct Numbers {
  rc_status status = RC_OK;
  Totals totals = {};
  double approach = 0;  // [length]
  std::int64_t candidates = 0, modelled = 0;
  Certificate certificate = {};
  double tolerance = 0;
  Bounds bounds = {};
  double mean_gap = std::numeric_limits<double>::quiet_NaN();  // [length]
  StiffnessInterval stiffness = {};
  double punch_stiffness = std::numeric_limits<double>::quiet_NaN();
  Work work = {};
  // Texts of a fixed size: once the caller's arrays are written, nothing may lack memory.
  char solver[sizeof rc_result::solver] = "none", backend[sizeof rc_result::backend] = "none", note[sizeof rc_result::note] = "";
  Accuracy accuracy = {};

  double load(const System& system) const { return totals.sum * system.cell_area(); }
  double energy(const System& system) const { return totals.energy * system.cell_area(); }
  // For lengths that were divided by this.
  void multiply_lengths(double by);
};

inline double contact_area(const Numbers& numbers, const System& system) {
  return static_cast<double>(numbers.totals.contacts) * system.cell_area();
}

// Writes all members but the arrays. Nothing else writes any.
void write(const Numbers& numbers, const System& system, rc_result& result);

}  // namespace rc
