#include "study.h"

#include <algorithm>
#include <cstring>

#include "support/surfaces.h"

namespace batch {

using namespace pairs;

namespace {

std::int32_t see(std::int64_t contact, std::int64_t step, const rc_result* result, void* user) {
  return static_cast<const Study*>(user)->ends(contact, step, *result);
}

template <class Values> Values part_of(const Values& all, std::int64_t i, std::size_t size) {
  const auto begin = all.begin() + i * static_cast<std::ptrdiff_t>(size);
  return all.empty() ? Values() : Values(begin, begin + static_cast<std::ptrdiff_t>(size));
}

}  // namespace

void Outcome::append(const Outcome& more) {
  status = more.status;
  written = std::max<std::int64_t>(written, 0) + more.written;
  certified = std::max<std::int64_t>(certified, 0) + more.certified;
  first = more.first;
  const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  for (const auto values :
       {&Outcome::load, &Outcome::approach, &Outcome::contact_area, &Outcome::stiffness, &Outcome::certificate, &Outcome::p})
    add(this->*values, more.*values);
  for (const auto counts : {&Outcome::iterations, &Outcome::products}) add(this->*counts, more.*counts);
  add(statuses, more.statuses);
}

Study Study::alone(std::int64_t i) const {
  Study result = *this;
  result.n = 1;
  result.gaps = part_of(gaps, i, points());
  result.masks = part_of(masks, i, points());
  result.targets = part_of(targets, i, static_cast<std::size_t>(steps));
  return result;
}

Outcome Study::solve(int threads, const std::function<void(rc_batch&)>& change) const {
  Outcome outcome;
  Settings all = settings;
  all.emplace_back(RC_OPT_THREADS, std::to_string(threads));
  const Options options = make_options(pair, problem.kernel, all);
  const auto slots = static_cast<std::size_t>(n * steps);
  for (Field* each : {&outcome.load, &outcome.approach, &outcome.contact_area, &outcome.stiffness, &outcome.certificate})
    each->assign(slots, blank);
  outcome.statuses.assign(slots, -7);
  outcome.iterations.assign(slots, -7);
  outcome.products.assign(slots, -7);
  outcome.p.assign(static_cast<std::size_t>(n) * points(), blank);

  rc_batch b = RC_BATCH_INIT;
  b.control = problem.control;
  b.warm_start = warm;
  b.n = n;
  b.steps = steps;
  b.targets = RC_IN(targets.data());
  b.undeformed_gap = RC_IN(gaps.data());
  b.mask = RC_IN(masks.empty() ? nullptr : masks.data());
  b.p0 = RC_IN(p0.empty() ? nullptr : p0.data());
  b.p = RC_OUT(outcome.p.data());
  b.columns.load = RC_OUT(outcome.load.data());
  b.columns.approach = RC_OUT(outcome.approach.data());
  b.columns.contact_area = RC_OUT(outcome.contact_area.data());
  b.columns.stiffness = RC_OUT(with_stiffness ? outcome.stiffness.data() : nullptr);
  b.columns.certificate = RC_OUT(outcome.certificate.data());
  b.columns.status = RC_OUT(outcome.statuses.data());
  b.columns.iterations = RC_OUT(outcome.iterations.data());
  b.columns.products = RC_OUT(outcome.products.data());
  if (ends) {
    b.fn = see;
    b.user = const_cast<Study*>(this);
  }
  if (change) change(b);
  outcome.status = rc_batch_solve(&problem.system, options.get(), &b);
  outcome.message = rc_last_error();
  outcome.written = b.written;
  outcome.certified = b.certified;
  outcome.first = b.first;
  return outcome;
}

Study rough_study(std::int64_t n, std::int64_t steps, std::int32_t control, std::int32_t boundary, std::int64_t nx,
                  std::int64_t ny) {
  Study study;
  study.problem = rough_problem(nx, ny, boundary, 0.5, 0.75);
  study.problem.control = control;
  study.n = n;
  study.steps = steps;
  for (std::int64_t i = 0; i < n; ++i) {
    Field heights = rough_heights(nx, ny, static_cast<unsigned>(100 + i));
    double deepest = 0;
    for (double& value : heights) deepest = std::max(deepest, value = -value);
    study.gaps.insert(study.gaps.end(), heights.begin(), heights.end());
    // Up, and down at the end; later surfaces are pressed less, so that what served the one before is too large.
    for (std::int64_t k = 0; k < steps; ++k) {
      const double share = (k + 1 < steps ? 0.1 + 0.25 * static_cast<double>(k + 1) / static_cast<double>(steps) : 0.15) /
                           (1 + 0.3 * static_cast<double>(i % 3));
      study.targets.push_back(control == RC_CONTROL_LOAD ? 20 * share : deepest * share);
    }
  }
  return study;
}

void check_same(const Outcome& a, const Outcome& b) {
  const auto same = [](const auto& x, const auto& y, const char* what) {
    check(x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof x[0]) == 0, std::string(what) + " differs");
  };
  same(a.load, b.load, "load");
  same(a.approach, b.approach, "approach");
  same(a.contact_area, b.contact_area, "contact area");
  same(a.stiffness, b.stiffness, "stiffness");
  same(a.certificate, b.certificate, "certificate");
  same(a.p, b.p, "p");
  same(a.statuses, b.statuses, "status");
  same(a.iterations, b.iterations, "iterations");
  same(a.products, b.products, "products");
  check(a.message == b.message, "messages differ: " + a.message + " / " + b.message);
  check_outcome(b, a.status, a.written, a.certified, a.first);
}

void check_outcome(const Outcome& outcome, rc_status status, std::int64_t written, std::int64_t certified, std::int64_t first) {
  check(outcome.status == status,
        std::string(rc_status_name(outcome.status)) + " instead of " + rc_status_name(status) + ": " + outcome.message);
  check(outcome.message.empty() == (status == RC_OK), "message: " + outcome.message);
  check_equal(outcome.written, written, "written");
  check_equal(outcome.certified, certified, "certified");
  check_equal(outcome.first, first, "first");
}

}  // namespace batch
