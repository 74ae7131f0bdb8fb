// Properties that hold in every scene. A property asks the library, keeps its answers, and judges them. Its spoiler changes the
// answers by as little as the property must notice: properties that notice nothing are found by the spoilt answers.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>

#include "case.h"

namespace scenes {

enum class Verdict { held, undecidable };

class Property {
 public:
  virtual ~Property() = default;
  /** Why this scene does not have the property, "" if it does. */
  virtual std::string ask(const Case& c) = 0;
  /** Throws pairs::Failure if the answers contradict the property. */
  virtual Verdict judge(const Case& c) const = 0;
  /** False where nothing can be spoilt. */
  virtual bool spoil(const Case& c, Random& random) = 0;
  /** Adds to numbers of which the driver prints the medians of all scenes, and which must not exceed `most_median`. */
  virtual void measure(std::map<std::string, Field>&) const {}
};

/** Half the width of a load's interval over the actual error of the load: 9 to 18 in the median, and at most twice that. */
constexpr double most_median = 40;

struct Kind {
  const char* name;
  std::uint64_t every, at;  // seeds with seed % every == at
  double least_asked;       // share of these seeds
  double most_undecidable;  // share of those asked
  std::unique_ptr<Property> (*make)();
};

template <class P> std::unique_ptr<Property> made() { return std::make_unique<P>(); }

std::span<const Kind> properties_of_steps();
std::span<const Kind> properties_of_sequences();
std::span<const Kind> properties_of_slopes();
std::span<const Kind> properties_of_laws();
std::span<const Kind> properties_of_costs();
std::span<const Kind> properties_of_creep();
std::span<const Kind> properties_of_ways();
std::span<const Kind> properties_of_flows();  // these two: where libroughcontact-flow is built
std::span<const Kind> properties_of_closing();

/** A text with a number for failures. */
inline std::string number(Real value) { return pairs::text(static_cast<double>(value)); }
inline void need(bool condition, const std::string& what) {
  if (!condition) throw pairs::Failure(what);
}

/** The residuals and the gap are those of the pressures, whether certified or not. */
void judge_residuals(const Case& c, const Surface& surface, const StepAnswer& answer, double target);
/** Every member but those of time, pressures and gap. */
void need_same_answer(const StepAnswer& found, const StepAnswer& wanted, const std::string& what);
/** The answer is what its solver must certify: `target` of the scene's control. */
void judge_certified(const Case& c, const Surface& surface, const StepAnswer& answer, double target);
/** It is the exact one, as closely as tol promises. */
Verdict judge_exact(const Case& c, const Surface& surface, const StepAnswer& answer, const Exact& exact, double target);
/** The exact answer lies in the intervals that the library proves. Also for answers that are not certified. */
Verdict judge_intervals(const Case& c, const Surface& surface, const StepAnswer& answer, const Exact& exact);

}  // namespace scenes
