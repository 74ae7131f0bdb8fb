// The deflection that certified steps leave in bodies that creep. In each term of their compliance a deflection v follows the
// elastic one w = H p by v' = (w - v) / time; w is taken to change linearly in time over a step.
#pragma once

#include <roughcontact/plugin.h>

#include <span>
#include <utility>
#include <vector>

#include "contact/surface/prony.h"

namespace rc {

// A step from the time of the last certified one. Its deflection is its compliance times w, and what is left of before.
struct CreepStep {
  struct Shares {
    double kept = 1, before = 0, now = 0;  // v at the end, of v, w before and w now
  };
  double time = 0;
  double compliance = 1;            // over that at once
  std::vector<Shares> shares = {};  // of each term
};

class Creep {
 public:
  explicit Creep(const std::vector<PronyTerm>& terms) : terms_(terms) {}
  // After a step at this time. values: as write() gives them; not read if no step has left anything, time NaN. Throws
  // Error(ARGUMENT).
  Creep(const std::vector<PronyTerm>& terms, std::span<const double> values, double time);

  bool none() const { return terms_.empty(); }       // the bodies are elastic
  bool empty() const { return !begun_ && !ended_; }  // no step has left anything
  double time() const { return ended_ ? step_.time : time_; }

  // Throws Error(ARGUMENT) if the time is before that of the last certified step. The bodies are at rest before the first one.
  CreepStep step_to(double time) const;
  // gap: with what is left of before, over the compliance, so that a step of the elastic bodies has the step's pressures.
  void put_into(std::span<double> gap, const CreepStep& step, const rc_team& team) const;
  int roundings() const { return 2 * (static_cast<int>(terms_.size()) + 3); }  // of each such gap, at most
  void begin(CreepStep&& step) { step_ = std::move(step); }
  // The step that has begun is certified, with this w at all points.
  void leave(std::vector<double>&& elastic) {
    next_ = std::move(elastic);
    ended_ = true;
  }
  void leave_nothing() { ended_ = false; }
  // The time of the next step counts from the last one that has left something.
  void settle(const rc_team& team);
  void forget() { *this = Creep(terms_); }
  void write(std::span<double> to, const rc_team& team) const;

 private:
  std::vector<PronyTerm> terms_;
  bool begun_ = false;  // a step has left this:
  double time_ = 0;
  std::vector<double> elastic_;               // w
  std::vector<std::vector<double>> delayed_;  // v of each term
  CreepStep step_;
  bool ended_ = false;  // the step that has begun is certified, with this:
  std::vector<double> next_;
};

}  // namespace rc
