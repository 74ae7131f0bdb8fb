#include "press.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "checkpoint.h"
#include "files/run_folder.h"
#include "files/step_fields.h"
#include "formats/error.h"
#include "formats/numbers.h"
#include "library.h"
#include "platform/files.h"
#include "row_problem.h"
#include "solve/conclusion.h"
#include "solve/step_record.h"
#include "solve/table.h"
#include "text.h"

namespace cli {

namespace {

// Fields of a step that need the whole grid and that the library does not compute for ranks.
constexpr std::string_view unknown[] = {"corrected_area", "patches", "largest_patch", "contact_crosses", "gap_crosses"};

class Run {
 public:
  Run(const Communicator& ranks, const RankArguments& arguments) : ranks_(ranks), arguments_(arguments.solve) {
    if (arguments_.resume && !arguments_.out) throw Error("--resume needs --out, the folder of the interrupted run");
    if (arguments.checkpoint) {
      if (!arguments_.out) throw Error("--checkpoint needs --out, the folder for its files");
      const auto given = to_integer(*arguments.checkpoint);
      if (!given || *given < 1)
        throw Error("--checkpoint: ", in_quotes(*arguments.checkpoint), " is no number of iterations, give 1 or more");
      every_ = *given;
    }
    row_ = read_problem(ranks, arguments_);
    if (!row_.problem.times.empty() && (arguments_.resume || every_ > 0))
      throw Error(arguments_.resume ? "--resume" : "--checkpoint",
                  ": what creep leaves is not kept by ranks; leave it out, or give --out to roughcontact solve");
    if (every_ > 0 && row_.problem.control == "area")
      throw Error("give --checkpoint without --area: a search for a load begins anew after an interruption");
    fields_ = Fields{row_.gap.size(), row_.problem.system};
    fields_.creep.clear();  // not of ranks
    make_contact();
    if (arguments_.out) open_folder();
  }

  ExitCode solve() {
    const auto steps = row_.problem.targets.size();
    for (std::size_t number = static_cast<std::size_t>(complete_) + 1; number <= steps; ++number) solve_step(number);
    if (ranks_.first() && !arguments_.quiet && !last_.empty()) std::printf("%s\n", last_.c_str());
    return all_certified_ ? exit_certified : exit_uncertified;
  }

 private:
  void make_contact() {
    Options options;
    ranks_.together([&] {
      options = make_options(context_, 1, row_.problem.options);
      double most = 0;
      check(rc_options_get_number(options.get(), RC_OPT_MAX_ITER, &most), "");
      most_ = static_cast<std::int64_t>(most);
      if (every_ > 0)
        check(rc_options_set_number(options.get(), RC_OPT_MAX_ITER, static_cast<double>(std::min(every_, most_))), "");
    });
    rc_contact* handle = nullptr;
    check(rc_ranks_contact_create(&ranks_.exchange(), &row_.problem.system, options.get(), &handle), "");
    contact_.reset(handle);
    if (ranks_.first()) context_.report_log();
  }

  void open_folder() {
    ranks_.on_first([&] { folder_.emplace(*arguments_.out, row_.problem, row_.checksum, arguments_.resume); });
    checkpoint_.emplace(ranks_, folder_ ? &*folder_ : nullptr, row_, rc_platform::path_of(*arguments_.out));
    if (!arguments_.resume) checkpoint_->remove();
    complete_ = ranks_.of_first(folder_ ? std::int64_t(folder_->complete().size()) : 0);
    all_certified_ = ranks_.of_first(std::int64_t(folder_ && folder_->all_certified())) == 1;
    if (complete_ > 0) {
      fields_.pressure = read_step_rows(ranks_, file("pressure", static_cast<std::size_t>(complete_)), row_);
      if (!fields_.indentation.empty())
        fields_.indentation = read_step_rows(ranks_, file("indentation", static_cast<std::size_t>(complete_)), row_);
      started_ = true;
      for (std::size_t i = 0; i < fields_.indentation.size(); ++i) row_.gap[i] += fields_.indentation[i];
      if (ranks_.first())
        report(
            format("--resume: %lld of %zu steps are complete", static_cast<long long>(complete_), row_.problem.targets.size()));
    }
    const auto next = static_cast<std::size_t>(complete_) + 1;
    if (!arguments_.resume) return;
    std::vector<double> pressure;
    const auto iterations = checkpoint_->read(next, pressure);
    if (!iterations) return;
    begun_ = *iterations;
    fields_.pressure = std::move(pressure);
    started_ = true;
    if (ranks_.first())
      report(format("--resume: step %zu continues after %lld iterations", next, static_cast<long long>(begun_)));
  }

  std::string file(const char* stem, std::size_t number) const {
    return (rc_platform::path_of(*arguments_.out) / step_name(stem, number, "npy", row_.problem.targets.size())).string();
  }

  // One call of the library. The start is always given, so that it is the same where a run was resumed.
  rc_status advance(std::size_t number, bool new_gap, rc_result& result) {
    rc_step step = RC_STEP_INIT;
    step.control = row_.problem.step_control();
    step.target = row_.problem.step_target(number - 1);
    step.time = row_.problem.step_time(number - 1);
    step.undeformed_gap.data = new_gap ? row_.gap.data() : nullptr;
    step.mask.data = new_gap ? row_.problem.input.mask : nullptr;
    step.borrow = 1;
    step.warm_start = 0;
    step.p0.data = started_ ? fields_.pressure.data() : nullptr;
    result = RC_RESULT_INIT;
    result.p.data = fields_.pressure.data();
    result.gap.data = fields_.gap.data();
    const rc_status status = rc_contact_solve(contact_.get(), &step, &result);
    check(status, format("step %zu", number));
    started_ = true;
    return status;
  }

  void solve_step(std::size_t number) {
    StepRecord step{static_cast<int>(number), RC_RESULT_INIT, {}, {}};
    std::int64_t iterations = begun_, products = 0;
    double seconds = 0, setup = 0;
    begun_ = 0;
    for (bool more = true; more;) {
      const rc_status status = advance(number, !gap_given_, step.result);
      gap_given_ = true;
      iterations += step.result.iterations;
      products += step.result.products;
      seconds += step.result.seconds;
      setup += step.result.setup_seconds;
      step.message = status > 0 ? last_message() : "";
      more = every_ > 0 && status == RC_STOP_MAX_ITER && step.result.iterations > 0 && iterations < most_;
      if (more) checkpoint_->write(number, iterations, fields_.pressure);
    }
    step.result.iterations = iterations;
    step.result.products = products;
    step.result.seconds = seconds;
    step.result.setup_seconds = setup;
    if (!fields_.indentation.empty() && step.result.status == RC_OK) yield();
    all_certified_ = all_certified_ && step.good();
    print(step);
    if (arguments_.out) write(step);
  }

  // At points with the hardness the overlap is plastic, and remains.
  void yield() {
    for (std::size_t i = 0; i < fields_.pressure.size(); ++i) {
      if (fields_.pressure[i] == row_.problem.system.hardness) fields_.indentation[i] += std::max(0.0, -fields_.gap[i]);
    }
  }

  void print(const StepRecord& step) {
    last_ = conclusion(row_.problem, step);
    if (!ranks_.first()) return;
    if (step.number == static_cast<int>(complete_) + 1) {
      for (const std::string& note : row_.problem.input.notes) report(note);
      if (!arguments_.quiet) print_table_head(row_.problem);
    }
    if (!arguments_.quiet) print_table_row(row_.problem, step);
    if (!step.message.empty()) report(format("step %d: ", step.number) + step.message);
    const std::string note = remarks(row_.problem, step.result);
    if (!note.empty() && note != remarked_) report("remark: " + note);
    remarked_ = note;
  }

  void write(const StepRecord& step) {
    const auto number = static_cast<std::size_t>(step.number);
    const rc_system& system = row_.problem.system;
    ranks_.on_first([&] { folder_->begin_step(number); });
    const auto array = [&](const char* stem, const std::vector<double>& values) {
      write_rows(ranks_, rc_platform::path_of(file(stem, number)), values, system.nx, system.ny, row_.rows);
    };
    array("pressure", fields_.pressure);
    array("gap", fields_.gap);
    if (system.hardness > 0) array("indentation", fields_.indentation);
    ranks_.on_first([&] {
      std::vector<JsonEntry> values = step_fields(step, row_.problem);
      std::erase_if(values, [](const JsonEntry& field) { return std::ranges::count(unknown, field.place) > 0; });
      folder_->end_step(values);
    });
    checkpoint_->remove();
  }

  const Communicator& ranks_;
  const SolveArguments& arguments_;
  Context context_;
  RowProblem row_;
  Fields fields_{0, RC_SYSTEM_INIT};
  Contact contact_;
  std::optional<RunFolder> folder_;  // on rank 0
  std::optional<Checkpoint> checkpoint_;
  std::int64_t every_ = 0;  // iterations between checkpoints; 0: none
  std::int64_t most_ = 0;   // option max_iter
  std::int64_t complete_ = 0, begun_ = 0;
  bool all_certified_ = true, started_ = false, gap_given_ = false;
  std::string remarked_, last_;
};

}  // namespace

ExitCode press(const Communicator& ranks, const RankArguments& arguments) { return Run{ranks, arguments}.solve(); }

}  // namespace cli
