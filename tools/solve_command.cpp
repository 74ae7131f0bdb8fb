#include "solve_command.h"

#include <unistd.h>

#include <optional>

#include "interrupt.h"
#include "library.h"
#include "npy_writer.h"
#include "output_folder.h"
#include "picture.h"
#include "progress_bar.h"
#include "step_record.h"
#include "summary.h"
#include "table.h"
#include "text.h"

namespace cli {

namespace {

Options make_options(const Context& context, const Problem& problem) {
  rc_options* handle = nullptr;
  check(rc_options_create(context.get(), &handle), "");
  Options options{handle};
  for (const auto& [key, text] : problem.options) check(rc_options_parse(handle, key.c_str(), text.c_str()), "");
  return options;
}

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

// Pressures and deformed gaps of the current step.
struct Fields {
  explicit Fields(std::size_t points) : pressure(points), gap(points) {}
  std::vector<double> pressure, gap;
};

class StepFiles {
 public:
  StepFiles(const std::string& folder, const Problem& problem) : folder_(folder), problem_(problem), summary_(problem) {}

  void write(const StepRecord& step, const Fields& fields) {
    if (step.number == 1) remove_previous();
    const auto array = [this](const std::vector<double>& values) {
      return [this, &values](std::FILE* file) {
        write_npy(file, values, problem_.system.nx, problem_.system.ny);
        return true;
      };
    };
    folder_.write(name("pressure", step.number, "npy"), array(fields.pressure));
    folder_.write(name("gap", step.number, "npy"), array(fields.gap));
    if (can_draw_) draw(step, fields);

    summary_.add(step);
    const std::string text = summary_.text();
    folder_.write("summary.json", [&](std::FILE* file) { return std::fwrite(text.data(), 1, text.size(), file) == text.size(); });
  }

 private:
  static std::string name(const char* stem, int number, const char* extension) {
    return format("%s-%d.%s", stem, number, extension);
  }

  // An earlier run may have had more steps than this one; its files must not be taken for this one's.
  void remove_previous() {
    const int count = Summary::step_count(folder_.read("summary.json"));
    folder_.remove("summary.json");
    for (int k = 1; k <= count; ++k) {
      folder_.remove(name("pressure", k, "npy"));
      folder_.remove(name("gap", k, "npy"));
      folder_.remove(name("contact", k, "png"));
    }
  }

  void draw(const StepRecord& step, const Fields& fields) {
    const std::string picture = name("contact", step.number, "png");
    folder_.write(picture, [&](std::FILE* file) {
      const Gnuplot outcome = draw_picture({problem_.input.surface, fields.pressure, step, problem_.targets.size()}, file);
      can_draw_ = !outcome.missing;
      if (outcome.missing) {
        report("gnuplot not found: contact-K.png not drawn");
      } else if (!outcome.drawn) {
        report(picture + " not drawn, gnuplot failed: " + outcome.message);
      }
      return outcome.drawn;
    });
  }

  OutputFolder folder_;
  const Problem& problem_;
  Summary summary_;
  bool can_draw_ = true;
};

int32_t on_progress(const rc_progress* progress, void* bar) {
  static_cast<ProgressBar*>(bar)->update(*progress);
  return 0;
}

StepRecord solve_step(rc_contact* contact, const Problem& problem, int number, const std::vector<double>& gap, Fields& fields) {
  rc_step step = RC_STEP_INIT;
  step.control = problem.step_control();
  step.target = problem.step_target(static_cast<std::size_t>(number - 1));
  step.gap = number == 1 ? gap.data() : nullptr;
  step.mask = number == 1 && !problem.input.mask.empty() ? problem.input.mask.data() : nullptr;
  step.borrow = 1;

  StepRecord record{number, {}, {}};
  rc_result_init(&record.result);
  record.result.p = fields.pressure.data();
  record.result.gap = fields.gap.data();
  const rc_status status = rc_contact_solve(contact, &step, &record.result);
  if (status > 0) record.message = last_message();
  check(status, format("step %d", number));
  return record;
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
  const Problem problem = make_problem(arguments);
  const std::size_t steps = problem.targets.size();
  const std::vector<double> gap = gap_below_highest_point(problem.input.surface);
  Fields fields{gap.size()};

  Context context;
  const Options options = make_options(context, problem);
  ProgressBar bar{!arguments.quiet && isatty(STDERR_FILENO) == 1, tolerance(options), steps};
  const Contact contact = make_contact(problem, options);
  check(rc_contact_on_progress(contact.get(), on_progress, &bar, 1), "");
  const Interrupt interrupt{contact.get()};
  std::optional<StepFiles> files;
  if (arguments.out) files.emplace(*arguments.out, problem);

  ExitCode code = exit_certified;
  for (int number = 1; number <= static_cast<int>(steps) && !interrupt.requested(); ++number) {
    bar.begin(number);
    const StepRecord step = solve_step(contact.get(), problem, number, gap, fields);
    bar.clear();

    context.report_warnings();
    for (const std::string& note : problem.input.notes) {
      if (number == 1) report(note);
    }
    const bool good = step.result.status == RC_OK || step.result.status == RC_WITHIN_GOAL;
    if (!good) code = exit_uncertified;
    if (!arguments.quiet && number == 1) print_table_head(problem);
    if (!arguments.quiet) print_table_row(step);
    if (!good || (!arguments.quiet && !bar.enabled())) report_step(step, steps);
    if (files) files->write(step, fields);
    if (step.result.status == RC_STOP_CANCELLED) return exit_cancelled;
  }
  return interrupt.requested() ? exit_cancelled : code;
}

}  // namespace cli
