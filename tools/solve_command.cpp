#include "solve_command.h"

#include <roughcontact/history.h>

#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "conclusion.h"
#include "cores.h"
#include "error.h"
#include "interrupt.h"
#include "library.h"
#include "platform/terminal.h"
#include "progress_bar.h"
#include "step_files.h"
#include "step_record.h"
#include "step_writers.h"
#include "table.h"
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
  check(rc_options_get_real(options.get(), RC_OPT_TOL, &tol), "--tol");
  return tol;
}

int32_t on_progress(const rc_progress* progress, void* bar) {
  static_cast<ProgressBar*>(bar)->update(*progress);
  return 0;
}

StepRecord solve_step(rc_contact* contact, const Problem& problem, int number, bool first, const std::vector<double>& gap,
                      Fields& fields) {
  rc_step step = RC_STEP_INIT;
  step.control = problem.step_control();
  step.target = problem.step_target(static_cast<std::size_t>(number - 1));
  step.undeformed_gap = first ? gap.data() : nullptr;
  step.mask = first && !problem.input.mask.empty() ? problem.input.mask.data() : nullptr;
  step.borrow = 1;

  StepRecord record{number, RC_RESULT_INIT, RC_ACCURACY_INIT, {}, {}};
  record.result.p = fields.pressure.data();
  record.result.gap = fields.gap.data();
  const rc_status status = rc_contact_solve(contact, &step, &record.result);
  if (status > 0) record.message = last_message();
  check(status, format("step %d", number));
  check(rc_contact_accuracy(contact, &record.accuracy), "");
  if (!fields.indentation.empty()) check(rc_contact_indentation(contact, fields.indentation.data()), "");
  record.measures = measure(problem, fields);
  return record;
}

// Restores the contact's state at the end of the earlier run.
void restore(rc_contact* contact, const Problem& problem, const std::vector<double>& gap, const StepFiles& files) {
  const std::vector<CertifiedStep> certified = files.certified();
  rc_state state = RC_STATE_INIT;
  state.undeformed_gap = gap.data();
  state.mask = problem.input.mask.empty() ? nullptr : problem.input.mask.data();
  if (!certified.empty()) {
    state.p = certified[0].pressure.data();
    state.approach = certified[0].approach;
    state.load = certified[0].load;
  }
  if (certified.size() > 1) {
    state.p_before = certified[1].pressure.data();
    state.approach_before = certified[1].approach;
    state.load_before = certified[1].load;
  }
  const std::vector<double> indentation = files.indentation();
  if (!indentation.empty()) state.indentation = indentation.data();
  check(rc_contact_restore(contact, &state), "--resume");
  report(format("--resume: %d of %zu steps are finished", files.finished(), problem.targets.size()));
}

// What the library finds doubtful, with the option that helps.
std::string remarks(const StepRecord& step) {
  constexpr std::string_view doubt = "level them";
  std::string text = step.result.note;
  if (const auto place = text.find(doubt); place != std::string::npos) text.insert(place + doubt.size(), " with --remove plane");
  return text;
}

void report_choice(rc_contact* contact) {
  const char* text = nullptr;
  check(rc_contact_explain(contact, &text), "--explain");
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) report(line);
}

void report_step(const StepRecord& step, std::size_t steps) {
  const rc_result& r = step.result;
  std::string line = format("step %d/%zu: %s after %lld iterations, %.2f s", step.number, steps, rc_status_name(r.status),
                            static_cast<long long>(r.iterations), r.setup_seconds + r.seconds);
  if (!step.message.empty()) line += ": " + step.message;
  report(line);
}

}  // namespace

ExitCode run_solve(const SolveArguments& arguments) {
  if (arguments.resume && !arguments.out) throw Error("--resume goes on in the folder of --out, which is missing");
  if (arguments.write && !arguments.out) throw Error("--write puts its files into the folder of --out, which is missing");
  StepWriters writers;
  if (arguments.write) writers = find_step_writers(*arguments.write);
  const Problem problem = make_problem(arguments);
  const int steps = static_cast<int>(problem.targets.size());
  std::vector<double> gap = problem.input.surface.heights;
  check(rc_gap_from_heights(static_cast<std::int64_t>(gap.size()), gap.data(), nullptr, gap.data()), "");
  Fields fields{gap.size(), problem.system.hardness > 0};

  Context context;
  const Options options = make_options(context, usable_cores(), problem.options);
  ProgressBar bar{!arguments.quiet && rc_platform::is_terminal(stderr), tolerance(options), problem.targets.size()};
  const Contact contact = make_contact(problem, options);
  check(rc_contact_on_progress(contact.get(), on_progress, &bar, 1), "");
  const Interrupt interrupt{contact.get()};
  std::optional<StepFiles> files;
  if (arguments.out) files.emplace(*arguments.out, problem, arguments.resume, std::move(writers));
  const int finished = files ? files->finished() : 0;
  if (finished > 0) restore(contact.get(), problem, gap, *files);

  std::string remarked, last;
  ExitCode code = files && !files->all_certified() ? exit_uncertified : exit_certified;
  for (int number = finished + 1; number <= steps && !interrupt.requested(); ++number) {
    const bool first = number == finished + 1;
    bar.begin(number);
    const StepRecord step = solve_step(contact.get(), problem, number, first, gap, fields);
    bar.clear();

    context.report_log(arguments.explain ? RC_LOG_INFO : RC_LOG_WARNING);
    for (const std::string& note : problem.input.notes) {
      if (first) report(note);
    }
    if (!step.good()) code = exit_uncertified;
    if (!arguments.quiet && first) print_table_head(problem);
    if (!arguments.quiet) print_table_row(problem, step);
    if (!step.good() || (!arguments.quiet && !bar.enabled())) report_step(step, problem.targets.size());
    if (arguments.explain) report_choice(contact.get());
    const std::string said = remarks(step);
    if (!said.empty() && said != remarked) report("remark: " + said);
    remarked = said;
    if (files) files->write(step, fields);
    last = conclusion(problem, step);
    if (step.result.status == RC_STOP_CANCELLED) return exit_cancelled;
  }
  if (files && !interrupt.requested()) files->write_history();
  if (!arguments.quiet && !last.empty()) std::printf("%s\n", last.c_str());
  return interrupt.requested() ? exit_cancelled : code;
}

}  // namespace cli
