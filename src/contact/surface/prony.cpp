#include "contact/surface/prony.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/array.h"
#include "core/error.h"

namespace rc {

namespace {

constexpr std::int32_t most_terms = 1000;

// As the caller gives them. Terms of ratio 0 do nothing.
std::vector<PronyTerm> given_terms(const rc_system& system) {
  const double *const ratios = values_of<double>(system.creep_ratio), *const times = values_of<double>(system.creep_time);
  std::vector<PronyTerm> terms;
  for (std::int32_t k = 0; k < system.creep_terms; ++k) {
    if (!(std::isfinite(ratios[k]) && ratios[k] >= 0))
      fail(RC_ERR_ARGUMENT, "rc_system.creep_ratio[", k, "] = ", ratios[k], " must be finite and >= 0");
    if (!(std::isfinite(times[k]) && times[k] > 0))
      fail(RC_ERR_ARGUMENT, "rc_system.creep_time[", k, "] = ", times[k], " must be finite and > 0");
    terms.push_back({ratios[k], times[k]});
  }
  return terms;
}

std::vector<PronyTerm> with_one_term_for_each_time(std::vector<PronyTerm> terms) {
  std::ranges::sort(terms, {}, &PronyTerm::time);
  std::vector<PronyTerm> merged;
  for (const PronyTerm& term : terms) {
    if (term.ratio == 0) continue;
    if (!merged.empty() && merged.back().time == term.time)
      merged.back().ratio += term.ratio;
    else
      merged.push_back(term);
  }
  return merged;
}

// The Laplace transform of the relaxing modulus, times s, at s = -1/t where t = terms[j].time + beyond. The transform of the
// compliance is its inverse, whose poles are the times of the compliance.
class Relaxation {
 public:
  explicit Relaxation(const std::vector<PronyTerm>& terms) : terms_(terms) {
    for (const PronyTerm& term : terms) last_ -= term.ratio;
  }
  double last() const { return last_; }  // the modulus after all times, over that at once

  double at(std::size_t j, double beyond) const {
    double sum = last_;
    for (const PronyTerm& term : terms_) sum -= term.ratio * term.time / distance(j, beyond, term);
    return sum;
  }
  // The term of the compliance, at a zero.
  PronyTerm compliance(std::size_t j, double beyond) const {
    double slope = 0;
    const double time = terms_[j].time + beyond;
    for (const PronyTerm& term : terms_) slope += term.ratio * term.time * time / std::pow(distance(j, beyond, term), 2);
    return {1 / slope, time};
  }
  // How far the zero beyond terms[j].time lies from it, before the next time or, after the last one, before any bound.
  double zero_beyond(std::size_t j) const {
    double least = 0, most = 0;
    if (j + 1 < terms_.size())
      most = terms_[j + 1].time - terms_[j].time;
    else
      for (const PronyTerm& term : terms_) most += term.ratio * term.time / last_;
    for (;;) {
      const double middle = least + 0.5 * (most - least);
      if (!(middle > least && middle < most)) return middle;
      (at(j, middle) < 0 ? least : most) = middle;
    }
  }

 private:
  double distance(std::size_t j, double beyond, const PronyTerm& term) const { return terms_[j].time - term.time + beyond; }

  const std::vector<PronyTerm>& terms_;
  double last_ = 1;
};

// Each time of the compliance lies between two of the modulus, or after the last one.
std::vector<PronyTerm> compliances_of(const std::vector<PronyTerm>& moduli) {
  const Relaxation relaxation(moduli);
  if (!(relaxation.last() > 0))
    fail(RC_ERR_ARGUMENT, "rc_system.creep_ratio: moduli relax to ", relaxation.last(),
         " of the modulus at once, which must be > 0; the ratios must sum up to less than 1");
  std::vector<PronyTerm> compliances;
  for (std::size_t j = 0; j < moduli.size(); ++j) compliances.push_back(relaxation.compliance(j, relaxation.zero_beyond(j)));
  return compliances;
}

}  // namespace

std::vector<PronyTerm> prony_terms(const rc_system& system) {
  if (system.creep_by != RC_CREEP_COMPLIANCES && system.creep_by != RC_CREEP_MODULI)
    fail(RC_ERR_ARGUMENT, "rc_system.creep_by = ", system.creep_by,
         " is neither RC_CREEP_COMPLIANCES (0) nor RC_CREEP_MODULI (1)");
  if (system.creep_terms < 0 || system.creep_terms > most_terms)
    fail(RC_ERR_ARGUMENT, "rc_system.creep_terms = ", system.creep_terms, " must be 0 .. ", most_terms);
  if (system.creep_terms == 0) return {};
  if (!system.creep_ratio.data || !system.creep_time.data)
    fail(RC_ERR_ARGUMENT, "rc_system.creep_terms = ", system.creep_terms, " but rc_system.",
         system.creep_ratio.data ? "creep_time" : "creep_ratio", " is null");
  std::vector<PronyTerm> terms = given_terms(system);
  if (system.creep_by == RC_CREEP_COMPLIANCES) return terms;
  const std::size_t given = terms.size();
  terms = compliances_of(with_one_term_for_each_time(std::move(terms)));
  terms.resize(given, {0, 1});  // so that the caller knows how many there are
  return terms;
}

}  // namespace rc
