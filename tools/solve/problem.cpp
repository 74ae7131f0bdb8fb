#include "solve/problem.h"

#include "formats/error.h"
#include "text.h"

namespace cli {

namespace {

void set_options(const SolveArguments& arguments, Problem& problem) {
  if (arguments.out) problem.options.emplace_back(RC_OPT_RESUMABLE, "1");
  const rc_request* const request = problem.input.request.get();
  for (std::int64_t k = 0; k < rc_request_option_count(request); ++k) {
    const char *key = nullptr, *text = nullptr;
    if (rc_request_option(request, k, &key, &text) != RC_OK) throw Error(rc_request_last_error());
    problem.options.emplace_back(key, text);
  }
  for (const std::string& assignment : arguments.set) {
    const auto equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) throw Error("--set: ", in_quotes(assignment), " has not the form key=value");
    problem.options.emplace_back(assignment.substr(0, equals), assignment.substr(equals + 1));
  }
}

}  // namespace

std::string name_of_boundary(std::int32_t boundary) {
  return std::string(names_in(find_word("boundary")->choices)[static_cast<std::size_t>(boundary - RC_BOUNDARY_FREE)]);
}

int32_t Problem::step_control() const {
  if (control == "approach") return RC_CONTROL_APPROACH;
  if (control == "load") return RC_CONTROL_LOAD;
  return control == "area" ? RC_CONTROL_AREA : RC_CONTROL_PRESSURE;
}

double Problem::step_target(std::size_t step) const {
  if (control != "area") return targets[step];
  return targets[step] * static_cast<double>(system.nx) * static_cast<double>(system.ny) * system.hx * system.hy;
}

Problem make_problem(const SolveArguments& arguments, std::int32_t call, const rc_map* maps, std::int64_t n_maps) {
  Problem problem;
  if (call != RC_CALL_ROWS) problem.options.emplace_back(RC_OPT_STIFFNESS, "1");
  problem.input = input_of(arguments.words, make_request(arguments.words, call, maps, n_maps));
  set_options(arguments, problem);
  const rc_problem_view& view = problem.view = problem_of(problem.input.request);
  problem.system = view.system;
  problem.control = view.loading;
  problem.targets.assign(view.targets, view.targets + view.n);
  problem.times.assign(view.times, view.times + view.n_times);
  return problem;
}

}  // namespace cli
