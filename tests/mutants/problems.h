// Small problems in the library's internal types.
#pragma once

#include <roughcontact/roughcontact.h>

#include <cstdint>
#include <string>
#include <vector>

#include "contact/proof/bounds.h"
#include "contact/proof/survey.h"
#include "contact/surface/pressures.h"
#include "contact/surface/step_surface.h"
#include "contact/system.h"
#include "core/thread_team.h"
#include "support/unit_system.h"

namespace mutants {

// The same numbers on every machine.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed * 2654435761u + 12345) {}
  double uniform() {  // 0 .. 1, 24 bits
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 40) / 16777216.0;
  }

 private:
  std::uint64_t state_;
};

struct Small {
  rc_system given = support::unit_system();
  std::string kernel = "auto";
  std::vector<double> gap, matrix;
  std::vector<std::uint8_t> mask;
  bool summed = false;  // the gap is that of an indented surface
  double compression = 0;
  rc::Deflected answer;

  Small(std::int64_t nx, std::int64_t ny);
  std::size_t points() const { return gap.size(); }
  rc::System system() const {
    rc_options options{rc::Context::standard(), {}};
    options.set(RC_OPT_KERNEL, kernel);
    return rc::checked_system(given, options, true);
  }
  rc::StepSurface surface() const {
    static const rc::ThreadTeam team(1);
    return rc::StepSurface({given.nx, given.ny, gap, mask, true, 0, summed}, team);
  }
  rc::Survey survey() const { return rc::survey(surface(), compression, answer); }
  // Pressures on the points below the compression, and a product that leaves gaps of the size `off` of the compression there.
  void press(double depth, double off, std::uint64_t seed);
  // Only these points are listed; the others are apart by `beyond`.
  void list(const std::vector<std::int64_t>& points, double beyond);
  void make_dense(double weakest);
  // The hardness, which the pressures do not exceed: where they did, the gap is less by what that pressure deflects.
  void cap(double hardness);
};

// One of each kernel, boundary and shape.
std::vector<Small> systems();

class Figures;
// Writes the figures of a result. solved: the residual and the bounds are left out, which are round-off.
void put(Figures& figures, rc_status status, const rc_result& result, const std::vector<double>& p,
         const std::vector<double>& gap, bool solved);
// Writes a section with the bounds.
rc::Bounds put(Figures& figures, const std::string& name, const Small& small, rc::ProvenSets* sets = nullptr);

}  // namespace mutants
