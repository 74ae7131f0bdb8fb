// The exported functions of budget.h.
#include "abi/sized_struct.h"
#include "core/error.h"
#include "request/budget/budget.h"
#include "request/guard.h"

namespace rc::request {

namespace {

std::unique_ptr<rc_budget> made_budget(const rc_request_spec& spec, const rc_budget_spec& given) {
  if (!given.sources) fail(RC_ERR_ARGUMENT, "rc_budget_spec.sources is null");
  if (given.value && !given.value_name) fail(RC_ERR_ARGUMENT, "rc_budget_spec.value_name is null");
  if (spec.call != RC_CALL_SOLVE && spec.call != RC_CALL_HISTORY)
    fail(RC_ERR_ARGUMENT, "rc_request_spec.call = ", spec.call,
         " presses no single surface; give RC_CALL_SOLVE or RC_CALL_HISTORY");
  if (spec.system) fail(RC_ERR_ARGUMENT, "a budget changes words, and a system is given; give modulus, or E and nu");
  const auto base = made(spec, {});
  if (!base->view.heights || base->view.maps != 1) fail(RC_ERR_ARGUMENT, "a budget is of one surface");
  if (base->view.system.creep_terms > 0) fail(RC_ERR_ARGUMENT, "a budget is of elastic bodies, leave their creep out");
  if (base->targets.empty()) fail(RC_ERR_ARGUMENT, "a budget is of a step, give approach, load, pressure or area");
  auto budget = std::make_unique<rc_budget>();
  budget->sources = read_sources(given.sources, spec, *base);
  const bool si = base->view.si == 1;
  budget->names = quantity_names(si, {given.value_name ? given.value_name : "", given.value_unit ? given.value_unit : ""});
  budget->rows = rows_of(spec, given, *base, budget->sources, budget->value);
  for (std::size_t q = 0; q < (given.value ? of::count : of::further); ++q)
    budget->combined.push_back(combine(q, budget->names[q], budget->value[q], budget->rows, budget->sources));
  return budget;
}

void check_index(std::int64_t index, std::int64_t count, const char* name) {
  if (index < 0 || index >= count) fail(RC_ERR_ARGUMENT, name, " = ", index, " is not in 0 .. ", count - 1);
}

}  // namespace

}  // namespace rc::request

using namespace rc;           // NOLINT: this file is the bridge
using namespace rc::request;  // NOLINT

rc_status rc_budget_create(const rc_request_spec* request, const rc_budget_spec* spec, rc_budget** out) {
  rc_status stopped = RC_OK;
  const rc_status status = rc::request::guard([&] {
    const rc_request_spec defaults = RC_REQUEST_SPEC_INIT;
    const rc_budget_spec blank = RC_BUDGET_SPEC_INIT;
    const rc_request_spec words = read(request, "rc_request_spec", defaults);
    const rc_budget_spec given = read(spec, "rc_budget_spec", blank);
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    try {
      *out = made_budget(words, given).release();
    } catch (const Stopped& stop) {
      stopped = stop.status;
    }
  });
  return status == RC_OK ? stopped : status;
}

void rc_budget_destroy(rc_budget* budget) { delete budget; }

int64_t rc_budget_quantity_count(const rc_budget* budget) { return budget ? std::ssize(budget->combined) : 0; }
int64_t rc_budget_source_count(const rc_budget* budget) { return budget ? std::ssize(budget->rows) : 0; }

rc_status rc_budget_get_quantity(const rc_budget* budget, int64_t index, rc_budget_quantity* out) {
  return rc::request::guard([&] {
    if (!budget) fail(RC_ERR_ARGUMENT, "budget is null");
    check_size(out, "rc_budget_quantity");
    check_index(index, rc_budget_quantity_count(budget), "index");
    const auto q = static_cast<std::size_t>(index);
    const Combined& found = budget->combined[q];
    rc_budget_quantity quantity = RC_BUDGET_QUANTITY_INIT;
    quantity.name = budget->names[q].name.c_str();
    quantity.unit = budget->names[q].unit.c_str();
    quantity.sentence = found.sentence.c_str();
    quantity.value = budget->value[q];
    quantity.standard = found.standard;
    quantity.freedom = found.freedom;
    quantity.coverage = found.coverage;
    quantity.dominant = found.dominant;
    write(out, quantity);
  });
}

rc_status rc_budget_get_contribution(const rc_budget* budget, int64_t quantity, int64_t source, rc_budget_contribution* out) {
  return rc::request::guard([&] {
    if (!budget) fail(RC_ERR_ARGUMENT, "budget is null");
    check_size(out, "rc_budget_contribution");
    check_index(quantity, rc_budget_quantity_count(budget), "quantity");
    check_index(source, rc_budget_source_count(budget), "source");
    const auto q = static_cast<std::size_t>(quantity), k = static_cast<std::size_t>(source);
    const Contribution& found = budget->rows[k][q];
    const Source& given = budget->sources.all[k];
    const double all = budget->combined[q].standard;
    rc_budget_contribution contribution = RC_BUDGET_CONTRIBUTION_INIT;
    contribution.source = given.name.c_str();
    contribution.given = given.given.c_str();
    contribution.standard = found.standard;
    contribution.shift = found.shift;
    contribution.first_order = found.first_order;
    contribution.sampled = found.sampled;
    contribution.share = all > 0 ? found.variance() / (all * all) : 0;
    contribution.solves = solves_of(given, budget->sources.samples);
    write(out, contribution);
  });
}
