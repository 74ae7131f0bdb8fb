#include "solve/solve_command.h"

#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "files/step_files.h"
#include "files/step_writers.h"
#include "formats/error.h"
#include "library.h"
#include "platform/terminal.h"
#include "solve/budget.h"
#include "solve/conclusion.h"
#include "solve/interrupt.h"
#include "solve/leak.h"
#include "solve/progress_bar.h"
#include "solve/step_record.h"
#include "solve/step_solver.h"
#include "solve/table.h"
#include "text.h"

namespace cli {

namespace {

Contact make_contact(const Problem& problem, const Options& options) {
  rc_contact* handle = nullptr;
  check(rc_contact_create(&problem.system, options.get(), &handle), "");
  return Contact{handle};
}

double tolerance(const Options& options) {
  double tol = 0;
  check(rc_options_get_number(options.get(), RC_OPT_TOL, &tol), "--tol");
  return tol;
}

int32_t on_progress(const rc_progress* progress, void* bar) {
  static_cast<ProgressBar*>(bar)->update(*progress);
  return 0;
}

void report_choice(rc_contact* contact) {
  const char* text = nullptr;
  check(rc_contact_explain(contact, &text), "--explain");
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) report(line);
}

void report_uncertified(const Problem& problem, const StepRecord& step) {
  const auto number = static_cast<std::size_t>(step.number - 1);
  report(
      format("step %d of %zu is not certified (%s): ", step.number, problem.targets.size(), rc_status_name(step.result.status)) +
      asked(problem, number) + " asked, " + reached(problem, step) + " reached; " + step.message);
}

void check_output(const SolveArguments& arguments) {
  const std::pair<bool, const char*> uses[] = {{arguments.resume, "--resume needs --out, the folder of the interrupted run"},
                                               {arguments.write.has_value(), "--write needs --out, the folder for its files"},
                                               {arguments.no_maps, "--no-maps needs --out, the folder that it keeps small"},
                                               {arguments.no_pictures, "--no-pictures needs --out, the folder for all else"}};
  for (const auto& [used, what] : uses) {
    if (used && !arguments.out) throw Error(what);
  }
  if (!arguments.no_maps) return;
  if (arguments.write) throw Error("give either --write or --no-maps, not both");
  if (arguments.resume) throw Error("--resume needs the pressures in the folder of --out, which --no-maps leaves out");
}

}  // namespace

ExitCode run_solve(const SolveArguments& arguments) {
  check_output(arguments);
  StepWriters writers;
  if (arguments.write) writers = find_step_writers(*arguments.write);
  Problem problem = make_problem(arguments, RC_CALL_HISTORY);
  const bool closing = problem.control == "closing-pressure";
  if (closing && arguments.budget) throw Error("--budget is of a step, and --closing-pressure has none");
  if (!problem.times.empty() && arguments.budget) throw Error("--budget is of elastic bodies, leave their creep out");
  if (closing && arguments.out) throw Error("--closing-pressure has no steps, whose folder --out is");
  const int steps = static_cast<int>(problem.targets.size());
  Fields fields{problem.input.surface.heights.size(), problem.system};

  Context context;
  const Options options = make_options(context, default_threads(problem.system.nx * problem.system.ny), problem.options);
  if (closing) {
    for (const std::string& note : problem.input.notes) report(note);
    return search_closing_pressure(problem, options.get()) ? exit_certified : exit_uncertified;
  }
  ProgressBar bar{!arguments.quiet && rc_platform::is_terminal(stderr), tolerance(options), problem.targets.size()};
  const Contact contact = make_contact(problem, options);
  check(rc_contact_on_progress(contact.get(), on_progress, &bar, 1), "");
  const Interrupt interrupt{contact.get()};
  if (arguments.budget) {
    problem.budget_sources = *arguments.budget;
    problem.budget = make_budget(arguments, problem, options.get());
    if (!problem.budget) return exit_cancelled;
  }
  std::optional<StepFiles> files;
  if (arguments.out)
    files.emplace(*arguments.out, problem,
                  StepFiles::Choice{arguments.resume, !arguments.no_maps, !arguments.no_pictures, std::move(writers)});
  const int complete = files ? files->complete() : 0;
  StepSolver solver{contact.get(), problem};
  if (complete > 0) {
    solver.restore(files->certified(), files->indentation(), files->left());
    report(format("--resume: %d of %d steps are complete", complete, steps));
  }

  std::string remarked, last, smooth;
  ExitCode code = files && !files->all_certified() ? exit_uncertified : exit_certified;
  for (int number = complete + 1; number <= steps && !interrupt.requested(); ++number) {
    const bool first = number == complete + 1;
    bar.begin(number);
    StepRecord step = solver.solve(number, fields);
    bar.clear();
    if (problem.view.viscosity > 0 && step.result.status != RC_STOP_CANCELLED) {
      step.leak = leak_of(problem, problem.system, problem.input.mask, options.get(), step.result);
      if (!step.leak) return exit_cancelled;
    }

    context.report_log(arguments.explain ? RC_LOG_INFO : RC_LOG_WARNING);
    for (const std::string& note : problem.input.notes) {
      if (first) report(note);
    }
    if (!step.good()) code = exit_uncertified;
    if (!arguments.quiet && first) print_table_head(problem);
    if (!arguments.quiet) print_table_row(problem, step);
    if (!step.good()) report_uncertified(problem, step);
    if (arguments.explain) report_choice(contact.get());
    const std::string said = remarks(problem, step.result);
    if (!said.empty() && said != remarked) report("remark: " + said);
    remarked = said;
    if (files) files->write(step, fields);
    last = conclusion(problem, step);
    smooth = smooth_line(problem, step.result);
    if (step.result.status == RC_STOP_CANCELLED) return exit_cancelled;
  }
  if (files && !interrupt.requested()) files->write_history();
  for (const std::string& line : {last, smooth})
    if (!arguments.quiet && !line.empty()) std::printf("%s\n", line.c_str());
  if (problem.budget && !arguments.quiet && !interrupt.requested()) print_budget(*problem.budget);
  return interrupt.requested() ? exit_cancelled : code;
}

}  // namespace cli
