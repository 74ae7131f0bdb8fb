// Moduli, targets and the boundary.
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "request/history.h"
#include "request/request.h"

namespace rc::request {

namespace {

struct Body {
  std::vector<double> young, poisson;
};

// A unit left out or a prefix mistaken: "150" for 150 MPa.
void doubt(const Words& words, const char* word, double value, double least, rc_request& request) {
  if (value >= least) return;
  request.remarks.push_back({RC_REMARK_SMALL,
                             RC_DOUBTFUL,
                             word,
                             join(words.spelt(word), " is ", with_prefix(value, "Pa"), ", below ", with_prefix(least, "Pa"),
                                  ": check its unit, a number alone is in Pa"),
                             {value, least, 0}});
}

std::vector<double> pressures(const Words& words, const char* word, Units& units) {
  const Given* const given = words.find(word);
  if (!given) return {};
  words.positive(*given, Dimension::pressure);
  std::vector<double> found;
  const auto quantities = words.quantities(*given, Dimension::pressure);
  units.see(quantities);
  for (const Quantity& each : quantities) found.push_back(each.si());
  return found;
}

std::vector<double> ratios(const Words& words, const char* word) {
  const Given* const given = words.find(word);
  if (!given) return {};
  std::vector<double> found(given->numbers.begin(), given->numbers.end());
  if (given->text)
    for (const std::string_view each : split(given->text, ',')) found.push_back(finite_number(words.spelt(word), each));
  for (const double each : found)
    if (!(each > -1 && each <= 0.5)) throw Error(words.spelt(word), ": ", given->shown(), " is not in (-1, 0.5]");
  for (double& each : found) each = std::min(each * words.factor(word), 0.5);
  return found;
}

// 1/E* of the bodies: (1 - nu^2)/E of each.
void check_pair(const Words& words, const char* young_word, const char* poisson_word, const Body& body) {
  if (body.young.empty() != body.poisson.empty())
    throw Error(words.spelt(body.young.empty() ? young_word : poisson_word), " is missing, ", words.spelt(young_word), " and ",
                words.spelt(poisson_word), " go together");
  if (body.young.size() != body.poisson.size())
    throw Error(words.spelt(young_word), " and ", words.spelt(poisson_word),
                " are one number each, or two each, of the two bodies");
}

}  // namespace

void Units::see(const std::vector<Quantity>& quantities) {
  for (const Quantity& each : quantities) si = si || !each.bare;
}

void set_elasticity(const Words& words, Units& units, rc_request& request) {
  constexpr double softest = 1e2, softest_hard = 1e6;  // [Pa]: gels; solids
  rc_system& system = request.view.system;
  const std::vector<double> modulus = pressures(words, "modulus", units), hardness = pressures(words, "hardness", units);
  Body bodies[] = {{pressures(words, "E", units), ratios(words, "nu")}, {pressures(words, "E2", units), ratios(words, "nu2")}};
  const bool one = !bodies[0].young.empty() || !bodies[0].poisson.empty(),
             other = !bodies[1].young.empty() || !bodies[1].poisson.empty();
  if (!modulus.empty() && (one || other))
    throw Error("give either ", words.spelt("modulus"), " or ", words.spelt("E"), " and ", words.spelt("nu"), ", not both");
  if (modulus.empty() && !one && !other)
    throw Error("the elastic modulus is missing, give ", words.spelt("modulus"), " or ", words.spelt("E"), " and ",
                words.spelt("nu"));
  if (!modulus.empty()) {
    system.modulus = modulus.front();
  } else {
    check_pair(words, "E", "nu", bodies[0]);
    if (!one) throw Error(words.spelt("E"), " is missing, ", words.spelt("E"), " and ", words.spelt("nu"), " go together");
    check_pair(words, "E2", "nu2", bodies[1]);
    if (other && bodies[0].young.size() == 2)
      throw Error(words.spelt("E"), " has two numbers, and ", words.spelt("E2"), " is given: give the other body once");
    const auto plane = [](double young, double poisson) { return young / (1 - poisson * poisson); };
    const Body& second = other ? bodies[1] : bodies[0];
    const double first = plane(bodies[0].young.front(), bodies[0].poisson.front());
    const bool two = other || bodies[0].young.size() == 2;
    system.modulus = two ? 1 / (1 / first + 1 / plane(second.young.back(), second.poisson.back())) : first;
  }
  if (!hardness.empty()) system.hardness = hardness.front();
  if (!units.si) return;
  for (const auto& [word, body] : {std::pair{"E", &bodies[0]}, std::pair{"E2", &bodies[1]}})
    for (const double young : body->young) doubt(words, word, young, softest, request);
  if (!modulus.empty()) doubt(words, "modulus", system.modulus, softest, request);
  if (!hardness.empty()) doubt(words, "hardness", system.hardness, softest_hard, request);
}

void set_loading(const Words& words, Units& units, bool needed, rc_request& request) {
  constexpr std::pair<const char*, Dimension> loadings[] = {
      {"approach", Dimension::length}, {"load", Dimension::force}, {"pressure", Dimension::pressure}, {"area", Dimension::share}};
  std::vector<std::string> known;
  const StepTable table = step_table(words);
  for (const auto& [word, dimension] : loadings) {
    if ((find_word(word)->calls & words.call) != 0) known.push_back(words.spelt(word));
    const Given column = StepTable::as_word(word, table.targets);
    const Given* const given = table.loading == word ? &column : words.find(word);
    if (!given) continue;
    if (words.find(word) && !table.loading.empty())
      throw Error("give only one of ", words.spelt("steps"), " and ", words.spelt(word));
    if (!request.loading.empty()) throw Error("give only one of ", words.spelt(request.loading), " and ", words.spelt(word));
    request.loading = word;
    const auto quantities = words.quantities(*given, dimension, dimension == Dimension::length ? units.bare.metres : 1);
    if (dimension != Dimension::share) units.see(quantities);
    for (const Quantity& each : quantities) request.targets.push_back(each.si());
    const bool range = request.targets.size() == 2 && request.targets[0] > 0 && request.targets[0] < request.targets[1];
    if (words.call == RC_CALL_LAW && !range)
      throw Error(words.spelt(word), ": ", given->shown(),
                  " is not a range that rises from a pressure above 0, give 1MPa..500MPa");
    if (words.call == RC_CALL_SOLVE && request.targets.size() != 1)
      throw Error(words.spelt(word), " has ", request.targets.size(),
                  " values, and one step is solved here; a history solves one step for each");
    if (dimension == Dimension::share && std::ranges::max(request.targets) > 1)
      throw Error(words.spelt(word), ": ", given->shown(), " is more than the whole, give a share as 10% or 0.1");
  }
  if (words.find("closing-pressure")) {
    if (!request.loading.empty())
      throw Error("give only one of ", words.spelt(request.loading), " and ", words.spelt("closing-pressure"));
    if (request.view.system.creep_terms > 0)
      throw Error(words.spelt("closing-pressure"), " is of elastic bodies, leave their creep out");
    request.loading = "closing-pressure";
  }
  if (!request.loading.empty()) set_times(words, table, needed, request);
  if (!request.loading.empty() || !needed) return;
  if (words.call == RC_CALL_LAW) throw Error(words.spelt("pressure"), " is missing, give the range of the law as 1MPa..500MPa");
  std::string list;
  for (std::size_t k = 0; k < known.size(); ++k) list += (k == 0 ? "" : k + 1 < known.size() ? ", " : " or ") + known[k];
  throw Error("what to press with is missing, give ", list);
}

void set_flow(const Words& words, Units& units, rc_request& request) {
  constexpr std::string_view keys[] = {"viscosity", "drop", "along"}, axes[] = {"x", "y"};
  rc_problem_view& view = request.view;
  if (words.find("closing-pressure")) view.along = 1 + static_cast<std::int32_t>(words.chosen("closing-pressure"));
  const Given* const given = words.find("leak");
  if (!given) return;
  const std::string leak = words.spelt("leak");
  if (view.along != 0) throw Error("give either ", leak, " or ", words.spelt("closing-pressure"), ", not both");
  view.along = 1;
  for (const std::string_view setting : split(given->text, ',')) {
    const auto equals = std::min(setting.find('='), setting.size());
    const std::string_view key = setting.substr(0, equals), value = setting.substr(std::min(equals + 1, setting.size()));
    const std::size_t which = choice(leak, key, keys);
    if (which == 2) {
      view.along = 1 + static_cast<std::int32_t>(choice(leak + ": along", value, axes));
      continue;
    }
    const Quantity found = read_positive(join(leak, ": ", key), value, which == 0 ? Dimension::viscosity : Dimension::pressure);
    units.see({found});
    (which == 0 ? view.viscosity : view.pressure_drop) = found.si();
  }
  if (!(view.viscosity > 0 && view.pressure_drop > 0))
    throw Error(leak, ": ", given->shown(), " needs both viscosity and drop, give ", given->word->example);
}

void set_boundary(const Words& words, rc_request& request) {
  std::int32_t& boundary = request.view.system.boundary;
  const std::int32_t periodic = request.view.periodic;
  const auto assume = [&](std::int32_t code, std::int32_t severity, const std::string& text) {
    request.remarks.push_back({code, severity, "boundary", text});
  };
  if (words.find("boundary")) {
    boundary = RC_BOUNDARY_FREE + static_cast<std::int32_t>(words.chosen("boundary"));
    if (request.layered && (boundary == RC_BOUNDARY_PERIODIC_X || boundary == RC_BOUNDARY_PERIODIC_Y))
      throw Error(words.spelt("boundary"),
                  ": a layer has free or periodic edges; give free with several periods of the map, or periodic "
                  "with a margin across that nothing touches");
  } else if (words.call == RC_CALL_ANALYZE) {
    boundary = periodic == 1 ? RC_BOUNDARY_PERIODIC : RC_BOUNDARY_FREE;
  } else if (request.shape || periodic == 0) {
    boundary = RC_BOUNDARY_FREE;
    if (request.shape) {
      assume(RC_REMARK_ENDS, RC_FACT, "boundary free, as the shape ends somewhere");
    } else if (!request.format.empty()) {
      assume(RC_REMARK_ENDS, RC_ASSUMED,
             join("boundary free, the file says that the surface does not repeat; ", words.spelling.value("boundary", "periodic"),
                  " if it is a sample of a larger one"));
    }
  } else {
    boundary = RC_BOUNDARY_PERIODIC;
    if (periodic == 1) return;
    assume(RC_REMARK_BOUNDARY, RC_ASSUMED,
           join("boundary periodic, the map is taken as a sample of a larger surface; ", words.spelling.value("boundary", "free"),
                " if the body ends at its edges"));
  }
}

}  // namespace rc::request
