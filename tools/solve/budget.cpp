#include "solve/budget.h"

#include <atomic>
#include <cstdio>

#include "formats/error.h"
#include "platform/terminal.h"
#include "solve/interrupt.h"
#include "solve/leak.h"

namespace cli {

namespace {

void check_budget(rc_status status) {
  if (status < 0) throw Error("--budget: ", rc_request_last_error());
}

struct Watch {
  const Problem& problem;
  const rc_options* options;
  std::int64_t shown;      // the solve that the terminal shows; -1: it shows nothing
  std::string fault = "";  // of the leak
};

std::int32_t on_budget(std::int64_t ended, std::int64_t all, void* user) {
  auto& before = static_cast<Watch*>(user)->shown;
  if (before >= 0 && before != ended + 1) {
    std::fprintf(stderr, "\rbudget: solve %lld of %lld", static_cast<long long>(ended + 1), static_cast<long long>(all));
    before = ended + 1;
  }
  return std::atomic_ref(*const_cast<std::int32_t*>(stop_flag())).load();
}

std::int32_t leak_of_solve(const rc_system* system, const rc_result* result, const std::uint8_t* mask, void* user, double* value,
                           double* lower, double* upper) {
  auto& watch = *static_cast<Watch*>(user);
  try {
    const auto leak = leak_of(watch.problem, *system, mask, watch.options, *result);
    if (!leak) return 1;
    *value = leak->flow;
    *lower = leak->lower;
    *upper = leak->upper;
    return 0;
  } catch (const std::exception& error) {
    watch.fault = error.what();
    return 1;
  }
}

rc_budget_quantity quantity_of(const rc_budget& budget, std::int64_t k) {
  rc_budget_quantity found = RC_BUDGET_QUANTITY_INIT;
  check_budget(rc_budget_get_quantity(&budget, k, &found));
  return found;
}

rc_budget_contribution contribution_of(const rc_budget& budget, std::int64_t quantity, std::int64_t source) {
  rc_budget_contribution found = RC_BUDGET_CONTRIBUTION_INIT;
  check_budget(rc_budget_get_contribution(&budget, quantity, source, &found));
  return found;
}

}  // namespace

Budget make_budget(const SolveArguments& arguments, const Problem& problem, const rc_options* options) {
  const std::vector<rc_given> words = arguments.words.of_request();
  rc_request_spec request = RC_REQUEST_SPEC_INIT;
  request.call = RC_CALL_HISTORY;
  request.spelling = RC_SPELLING_OPTION;
  request.words = words.data();
  request.n_words = std::ssize(words);
  Watch watch{problem, options, !arguments.quiet && rc_platform::is_terminal(stderr) ? 0 : -1};
  rc_budget_spec spec = RC_BUDGET_SPEC_INIT;
  spec.sources = arguments.budget->c_str();
  spec.options = options;
  spec.progress = on_budget;
  spec.user = &watch;
  if (problem.view.viscosity > 0) {
    spec.value = leak_of_solve;
    spec.value_name = "leak";
    spec.value_unit = "m^3/s";
  }
  rc_budget* budget = nullptr;
  const rc_status status = rc_budget_create(&request, &spec, &budget);
  if (watch.shown > 0) std::fputs("\r\033[K", stderr);
  if (!watch.fault.empty()) throw Error(watch.fault);
  if (status == RC_ERR_EXTERNAL) return nullptr;  // a signal ended the leak
  check_budget(status);
  return {budget, Destroy<rc_budget_destroy>{}};
}

void print_budget(const rc_budget& budget) {
  std::printf("budget of the last step:\n");
  for (std::int64_t k = 0; k < rc_budget_quantity_count(&budget); ++k) std::printf("  %s\n", quantity_of(budget, k).sentence);
}

void add_budget(const rc_budget& budget, const std::string& sources, JsonText& document) {
  document.begin("budget");
  document.add("sources", sources);
  for (std::int64_t k = 0; k < rc_budget_quantity_count(&budget); ++k) {
    const rc_budget_quantity quantity = quantity_of(budget, k);
    document.begin(quantity.name);
    document.add({{"unit", quantity.unit},
                  {"value", quantity.value},
                  {"standard", quantity.standard},
                  {"coverage", quantity.coverage},
                  {"freedom", quantity.freedom},
                  {"sentence", quantity.sentence}});
    document.begin("contributions");
    for (std::int64_t j = 0; j < rc_budget_source_count(&budget); ++j) {
      const rc_budget_contribution part = contribution_of(budget, k, j);
      document.begin(part.source);
      document.add({{"given", part.given},
                    {"standard", part.standard},
                    {"shift", part.shift},
                    {"first_order", part.first_order},
                    {"sampled", part.sampled},
                    {"share", part.share},
                    {"solves", part.solves}});
      document.end();
    }
    document.end();
    document.end();
  }
  document.end();
}

}  // namespace cli
