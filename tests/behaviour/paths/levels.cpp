// Coarse solutions that a multilevel solver leaves behind.
#include <roughcontact/history.h>

#include <algorithm>

#include "history.h"
#include "path_tests.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace paths {

namespace {

using namespace pairs;

rc_level level_of(const Contact& contact, std::int64_t i, double* p = nullptr) {
  rc_level level = RC_LEVEL_INIT;
  level.p = RC_OUT(p);
  check(rc_contact_level(contact.handle(), i, &level) == RC_OK, rc_last_error());
  check(level.p.data == p, "level.p was changed");
  return level;
}

void check_levels(const Contact& contact, const Problem& problem, std::int64_t count) {
  check_equal(count, 2, "levels");
  std::int64_t points = 0;
  for (std::int64_t i = 0; i < count; ++i) {
    const rc_level level = level_of(contact, i);
    check(level.nx * level.ny > points, "the coarsest must come first");
    points = level.nx * level.ny;
    Field p(static_cast<std::size_t>(points), blank);
    const rc_level again = level_of(contact, i, p.data());
    check_equal(again.contacts, std::count_if(p.begin(), p.end(), [](double each) { return each > 0; }), "contacts");
    check_near(sum(p) * level.hx * level.hy, level.load, 1e-12 * level.load, "load of a level");
    check_near(level.hx * static_cast<double>(level.nx), problem.system.hx * static_cast<double>(problem.system.nx), 1e-12,
               "width of a level");
    check(level.status == RC_OK && level.contacts > 0 && level.contacts <= level.candidates, "status and counts of a level");
  }
  rc_level level = RC_LEVEL_INIT;
  check(rc_contact_level(contact.handle(), count, &level) == RC_ERR_ARGUMENT, "a level beyond the last");
}

void coarse_solutions_are_kept_until_the_next_step() {
  const Problem problem = rough_problem(64, 64, RC_BOUNDARY_FREE, 0.5, 0.5);
  const Contact contact(problem, {"cmr", "auto"}, {{"cmr.levels", "3"}});
  const Answer answer = contact.solve(problem);
  pairs::check_status(answer, RC_OK);
  check_levels(contact, problem, answer.result.levels);

  Request request;
  request.targets = {0.5 * problem.target, 0.9 * problem.target};
  const History path = followed(contact, problem, request);
  check_levels(contact, problem, path.seen.back().result.levels);

  request.targets = {0};
  check_equal(followed(contact, problem, request).seen.back().result.levels, 0, "levels of a step without contact");
  rc_level level = RC_LEVEL_INIT;
  check(rc_contact_level(contact.handle(), 0, &level) == RC_ERR_ARGUMENT, "a level of the step before");
}

}  // namespace

std::vector<Test> level_tests() {
  return {{"coarse_solutions_are_kept_until_the_next_step", coarse_solutions_are_kept_until_the_next_step}};
}

}  // namespace paths
