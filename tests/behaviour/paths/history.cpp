#include "history.h"

#include <roughcontact/history.h>

#include <exception>

namespace paths {

using namespace pairs;

namespace {

struct Watcher {
  History& history;
  const Request& request;
  std::size_t points;
};

std::int32_t watch(std::int64_t step, const rc_result* result, void* user) {
  Watcher& watcher = *static_cast<Watcher*>(user);
  const double *const p = static_cast<const double*>(result->p.data), *const gap = static_cast<const double*>(result->gap.data);
  Seen seen{*result, Field(p, p + watcher.points), Field(gap, gap + watcher.points)};
  seen.result.p.data = seen.result.gap.data = nullptr;
  watcher.history.seen.push_back(std::move(seen));
  return watcher.request.ends(step);
}

Field slice(const Field& values, std::size_t from, std::size_t count) {
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(from);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

}  // namespace

History follow(const Contact& contact, const Problem& problem, const Request& request) {
  History history;
  const std::size_t n = request.targets.size();
  for (Field* each : {&history.load, &history.approach, &history.contact_area, &history.stiffness, &history.certificate})
    each->assign(n, blank);
  history.products.assign(n, -1);
  Watcher watcher{history, request, problem.points()};

  rc_history path = RC_HISTORY_INIT;
  path.control = request.control;
  path.warm_start = request.warm_start;
  path.n = static_cast<std::int64_t>(n);
  path.targets = RC_IN(request.targets.data());
  path.undeformed_gap = RC_IN(request.with_gap ? problem.gap.data() : nullptr);
  path.mask = RC_IN(request.with_gap && !problem.mask.empty() ? problem.mask.data() : nullptr);
  path.columns.load = RC_OUT(history.load.data());
  path.columns.approach = RC_OUT(history.approach.data());
  path.columns.contact_area = RC_OUT(history.contact_area.data());
  path.columns.stiffness = RC_OUT(request.with_stiffness ? history.stiffness.data() : nullptr);
  path.columns.certificate = RC_OUT(history.certificate.data());
  path.columns.products = RC_OUT(history.products.data());
  path.fn = watch;
  path.user = &watcher;
  path.completed = -1;
  history.status = rc_contact_solve_history(contact.handle(), &path);
  history.message = rc_last_error();
  history.completed = path.completed;
  return history;
}

History followed(const Contact& contact, const Problem& problem, const Request& request) {
  History history = follow(contact, problem, request);
  check_status(history, RC_OK, static_cast<std::int64_t>(request.targets.size()));
  return history;
}

// A step counts as completed exactly where its outputs are written and fn saw it.
void check_status(const History& history, rc_status expected, std::int64_t completed) {
  check(history.status == expected,
        std::string(rc_status_name(history.status)) + " instead of " + rc_status_name(expected) + "; " + history.message);
  check_equal(history.completed, completed, "completed steps");
  check_equal(static_cast<std::int64_t>(history.seen.size()), completed, "steps that fn saw");
  for (std::size_t i = 0; i < history.load.size(); ++i) {
    const bool written = static_cast<std::int64_t>(i) < completed;
    check((history.load[i] != blank) == written && (history.products[i] >= 0) == written,
          "output " + std::to_string(i) + " is " + (written ? "not written" : "written"));
  }
}

void check_same(const History& part, const History& whole, std::size_t from, std::size_t steps) {
  const auto compare = [&](const Field& a, const Field& b, const char* what) {
    pairs::check_same(slice(a, 0, steps), slice(b, from, steps), what);
  };
  compare(part.load, whole.load, "load");
  compare(part.approach, whole.approach, "approach");
  compare(part.contact_area, whole.contact_area, "contact area");
  compare(part.stiffness, whole.stiffness, "stiffness");
  compare(part.certificate, whole.certificate, "certificate");
  for (std::size_t i = 0; i < steps; ++i) {
    check_equal(part.products[i], whole.products[from + i], "products");
    pairs::check_same(part.seen[i].p, whole.seen[from + i].p, "p");
    pairs::check_same(part.seen[i].gap, whole.seen[from + i].gap, "gap");
  }
}

}  // namespace paths
