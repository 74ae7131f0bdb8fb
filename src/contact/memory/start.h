// The start of one step: the pressures that the step gives, or else those of earlier steps.
#pragma once

#include <vector>

#include "contact/answer.h"
#include "contact/memory/memory.h"
#include "contact/target.h"

namespace rc {

class Start {
 public:
  // Without pressures.
  Start() = default;
  // The memory must outlive it.
  Start(const Memory& memory, const Step& step);
  // The same without earlier steps.
  Start cold() const;
  // The same from other copies of the earlier steps, or of one or none of them. They must outlive it.
  Start from(const Memory& copies) const;

  bool given() const { return given_.data != nullptr; }  // by the step
  // The last two certified steps; empty if the step may not start from them.
  const CertifiedStep& last() const { return warm_ ? memory_->last : none_; }
  const CertifiedStep& before() const { return warm_ ? memory_->before : none_; }
  // Whether the surface has a plastic indentation, of these steps or earlier ones.
  bool indented() const { return memory_ && memory_->indented; }
  // How far beyond the last step the new target lies, in units of the last step's change; 0 if no extrapolation is possible.
  double ahead() const { return ahead_; }

  // The last step's pressures, or those of the line through both steps; they may be negative.
  std::vector<double> extrapolated(const TrialSet& trial) const;
  // Dimensionless pressures to start from, up to the cap.
  std::vector<double> pressures(const TrialSet& trial, const AnswerUnits& units, const rc_team& team) const;
  // The kept answers from which pressures() is built; without a last one, the room of the one before.
  KeptSteps kept() const;
  // Pressures there at the approach that a warm step comes from; empty if it comes from none.
  std::vector<double> earlier(const TrialSet& trial) const;

 private:
  const Memory* memory_ = nullptr;  // null: no step
  CertifiedStep none_;
  rc_const_array given_ = {};
  bool warm_ = false;
  double ahead_ = 0;
};

// Estimated pressures in these units, on the points of a trial set, up to the cap.
std::vector<double> dimensionless(const Pressures& estimate, const TrialSet& trial, const AnswerUnits& units);

}  // namespace rc
