// The patch of a law: solves single nodes through the public interface, and says in overclosures what they prove.
#pragma once

#include <roughcontact/law.h>

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "law/points.h"

namespace rc {

// Whether the overclosure can be the change of the mean gap.
bool takes_mean_gap(const rc_system& system);

// A solved node.
struct LawSample {
  rc_law_point node = RC_LAW_POINT_INIT;                         // bounds and between_...: of no interval yet
  double approach = 0;                                           // from first touch on
  double bounded_to = std::numeric_limits<double>::quiet_NaN();  // approach of the next node for which node.bounds holds
  bool proven = true;  // load and stiffness lie in proven intervals, and sets of points grow with the approach
  LawPoints contacts, capped;
};

class LawPatch {
 public:
  // The contact and the struct's arrays are used until the patch ends. Throws Error.
  LawPatch(const rc_system& system, const rc_options* options, const rc_law_spec& spec);

  LawSample origin() const;
  LawSample at_load(double load) { return solve(RC_CONTROL_LOAD, load); }
  LawSample at_approach(double approach) { return solve(RC_CONTROL_APPROACH, approach); }

  // Slopes of the law between which those of all sets are that hold `least` and lie in `most`; nothing if none are proven.
  struct Slopes {
    double lower, upper;
  };
  std::optional<Slopes> slopes(const LawPoints& least, const LawPoints& most) const;

  double area() const { return area_; }
  double mean_gap() const { return mean_gap_; }
  std::int32_t bulk() const { return bulk_; }
  double bulk_yield() const { return spec_.bulk_stiffness > 0 ? area_ / spec_.bulk_stiffness : 0; }
  std::int64_t solves() const { return solves_; }
  bool homogeneous() const { return homogeneous_; }  // rc_result.homogeneous, once a node is solved
  bool plastic() const;

 private:
  // How far the overclosure goes with the approach, and the interval of that; how uncertain the overclosure itself is.
  struct Yield {
    double x, rate, rate_lower, rate_upper, error;
  };
  struct Destroy {
    void operator()(rc_contact* contact) const { rc_contact_destroy(contact); }
    void operator()(rc_options* options) const { rc_options_destroy(options); }
  };

  LawSample solve(std::int32_t control, double target);
  bool included(std::int64_t i) const;  // the mask lets it carry pressure
  void check_yield(const rc_result& result, const Yield& yields) const;
  bool sets_grow();
  Yield yield(std::int32_t control, const rc_result& result, const LawSample& sample);
  Yield mean_yield(std::int32_t control, const rc_result& result, const LawSample& sample);
  void set_options(const rc_options* given);
  double pressed_flat();  // 1'H1 hx hy over the points that are not masked

  rc_system system_;
  rc_law_spec spec_;
  std::int64_t n_, open_ = 0;  // points, and those that are not masked
  double area_, mean_gap_ = 0, flat_ = 0;
  std::int32_t bulk_;
  std::int64_t solves_ = 0;
  std::unique_ptr<rc_options, Destroy> options_;
  std::unique_ptr<rc_contact, Destroy> contact_;
  bool placed_ = false;             // the contact has the surface
  bool homogeneous_ = false;        // see homogeneous()
  std::optional<bool> sets_grow_;   // once it is known
  std::vector<double> from_touch_;  // the undeformed gap, with 0 at the lowest point
  std::vector<std::int64_t> index_;
  std::vector<double> p_, gap_;
};

}  // namespace rc
