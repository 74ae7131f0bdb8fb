#include "contact/calls/agreement.h"

#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/text.h"

namespace rc {

namespace {

template <class Array> const char* which(const Array& array) {
  return !array.data ? "none" : array.type == RC_SINGLE ? "float" : "double";
}

}  // namespace

std::vector<Fact> facts_of(const rc_system& system, const rc_options& options) {
  std::int32_t major = 0, minor = 0, patch = 0, abi = 0;
  rc_version(&major, &minor, &patch, &abi);
  std::vector<Fact> facts{{"the library's version", join(major, ".", minor, ".", patch, ", ABI ", abi)},
                          {"rc_system.op", join(system.op)},
                          {"rc_system.boundary", join(system.boundary)},
                          {"rc_system.nx", join(system.nx)},
                          {"rc_system.ny", join(system.ny)},
                          {"rc_system.hx", exact(system.hx)},
                          {"rc_system.hy", exact(system.hy)},
                          {"rc_system.modulus", exact(system.modulus)},
                          {"rc_system.hardness", exact(system.hardness)},
                          {"rc_system.creep_by", join(system.creep_by)},
                          {"rc_system.creep_terms", join(system.creep_terms)}};
  for (const auto& [name, values] :
       {std::pair<const char*, const rc_const_array&>{"creep_ratio", system.creep_ratio}, {"creep_time", system.creep_time}})
    for (std::int32_t k = 0; values.data && k < system.creep_terms; ++k)
      facts.push_back({join("rc_system.", name, "[", k, "]"), exact(values_of<double>(values)[k])});
  for (const OptionSpec* spec : options.context->known_options())
    if (spec->key != RC_OPT_THREADS) facts.push_back({join("option ", spec->key), options.values.text_of(*spec)});
  return facts;
}

std::vector<Fact> facts_of(const rc_step& step, const Outputs& outputs) {
  return {{"rc_step.control", join(step.control)},
          {"rc_step.warm_start", join(step.warm_start)},
          {"rc_step.target", exact(step.target)},
          {"rc_step.time", exact(step.time)},
          {"the type of rc_step.undeformed_gap", which(step.undeformed_gap)},
          {"rc_step.mask", step.mask.data ? "given" : "none"},
          {"the type of rc_step.p0", which(step.p0)},
          {"the type of rc_result.p", which(outputs.p.array)},
          {"the type of rc_result.gap", which(outputs.gap.array)}};
}

std::vector<Fact> facts_of(const rc_history& path) {
  std::vector<Fact> facts{{"rc_history.control", join(path.control)},
                          {"rc_history.warm_start", join(path.warm_start)},
                          {"rc_history.n", join(path.n)},
                          {"the type of rc_history.undeformed_gap", which(path.undeformed_gap)},
                          {"rc_history.mask", path.mask.data ? "given" : "none"},
                          {"rc_history.fn", path.fn ? "given" : "none"},
                          {"rc_history.want_gap", join(path.want_gap)},
                          {"rc_history.virgin", join(path.virgin)}};
  for (const auto& [name, output] : {std::pair<const char*, const rc_array&>{"mean_gap", path.columns.mean_gap},
                                     {"stiffness", path.columns.stiffness},
                                     {"load_lower", path.columns.load_lower},
                                     {"load_upper", path.columns.load_upper},
                                     {"area_lower", path.columns.area_lower},
                                     {"area_upper", path.columns.area_upper},
                                     {"stiffness_lower", path.columns.stiffness_lower},
                                     {"stiffness_upper", path.columns.stiffness_upper}})
    facts.push_back({join("rc_history.columns.", name), output.data ? "given" : "none"});
  for (const auto& [name, values] :
       {std::pair<const char*, const rc_const_array&>{"targets", path.targets}, {"times", path.times}})
    for (std::int64_t i = 0; values.data && i < path.n; ++i)
      facts.push_back({join("rc_history.", name, "[", i, "]"), exact(values_of<double>(values)[i])});
  return facts;
}

void check_agreement(const Ranks& ranks, const std::vector<Fact>& facts, bool counts) {
  std::string mine;
  for (const Fact& fact : facts) mine += fact.name + '\n' + fact.value + '\n';
  const std::vector<char> counted = ranks.of_each(static_cast<char>(counts));
  const std::vector<std::int64_t> sizes = ranks.of_each(static_cast<std::int64_t>(mine.size()));
  const std::vector<char> all = ranks.of_any(std::vector<char>(mine.begin(), mine.end()));
  const std::string first(all.data(), static_cast<std::size_t>(sizes.front()));
  std::size_t at = first.size();
  for (std::size_t rank = 1; rank < sizes.size(); ++rank) {
    const std::string other(all.data() + at, static_cast<std::size_t>(sizes[rank]));
    at += other.size();
    if (counted[rank] == 0 || other == first) continue;
    const std::vector<std::string> here = split(first, '\n'), there = split(other, '\n');
    for (std::size_t i = 0; i + 1 < std::min(here.size(), there.size()); i += 2)
      if (here[i] != there[i] || here[i + 1] != there[i + 1])
        fail(RC_ERR_ARGUMENT, "rank ", rank, " and rank 0 disagree on ", here[i], ": ", there[i + 1], " and ", here[i + 1]);
    fail(RC_ERR_ARGUMENT, "rank ", rank, " and rank 0 have different options: their components differ");
  }
}

}  // namespace rc
