#include "cascade.h"

#include <cmath>
#include <cstdio>

namespace failures {

namespace {

constexpr double same_load = 1e-7, same_pressure = 1e-5;
constexpr long long most_rounds = 3;
const Pair whole{"polonsky-keer", "fft"}, cascade{"cmr", "fft"};

long long rounds_of(const std::string& note) {
  long long rounds = 0;
  const auto at = note.find("after ");
  check(note.starts_with("cmr: ") && at != std::string::npos && std::sscanf(note.c_str() + at, "after %lld round", &rounds) == 1,
        "no rounds in the note \"" + note + "\"");
  return rounds;
}

}  // namespace

Cascade check_cascade(const Problem& problem, const std::string& filter) {
  const Settings settings = {{"tol", "1e-8"},     {"cmr.inner", "polonsky-keer"}, {"cmr.area", "side"}, {"cmr.radius", "1.5"},
                             {"cmr.levels", "3"}, {"cmr.filter", filter}};
  Settings as_published = settings;
  as_published.push_back({"cmr.certified", "0"});
  Cascade result;
  result.full = solved(problem, whole, {{"tol", "1e-8"}});
  result.plain = solve(problem, cascade, as_published);
  result.certified = solved(problem, cascade, settings);
  const double load = result.full.result.load;
  result.plain_error = result.plain.result.load / load - 1;
  result.rounds = rounds_of(result.certified.result.note);

  check_near(result.certified.result.load, load, same_load * load, filter + ": load");
  check_near(result.certified.p, result.full.p, same_pressure, filter + ": p");
  check(result.rounds <= most_rounds, filter + ": " + std::to_string(result.rounds) + " rounds");
  const double off = difference(result.plain.p, result.full.p);
  if (off > same_pressure)
    check_status(result.plain, RC_UNCERTIFIED, filter + ", as published, pressures off by " + text(off));
  else
    check(result.plain.status == RC_OK || result.plain.status == RC_UNCERTIFIED, result.plain.message);
  report(filter + ": load as published off by " + text(100 * result.plain_error) + " %, certified in " +
         std::to_string(result.rounds) + " rounds");
  return result;
}

}  // namespace failures
