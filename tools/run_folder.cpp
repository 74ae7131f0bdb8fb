#include "run_folder.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "error.h"
#include "platform/files.h"
#include "step_writers.h"
#include "text.h"
#include "whole_file.h"

namespace cli {

std::string step_name(const char* stem, std::size_t number, const char* extension) {
  return format("%s-%zu.%s", stem, number, extension);
}

namespace {

constexpr const char* summary_name = "summary.json";
constexpr const char* table_name = "steps.csv";

// Whether a file of this name is of the whole history.
bool of_all_steps(std::string_view name) { return name == summary_name || name == history_name || name == table_name; }

std::vector<std::string> step_names(std::size_t number) {
  std::vector<std::string> names = {step_name("pressure", number, "npy"), step_name("gap", number, "npy"),
                                    step_name("indentation", number, "npy"), step_name("contact", number, "png")};
  for (const char* extension : step_extensions) names.push_back(step_name("step", number, extension));
  return names;
}

// The number of the step that a file of this name belongs to; 0: of none.
std::size_t step_of(const std::string& name) {
  const auto dash = name.find('-');
  if (dash == std::string::npos) return 0;
  const std::size_t number = std::strtoull(name.c_str() + dash + 1, nullptr, 10);
  const auto names = step_names(number);
  return std::find(names.begin(), names.end(), name) != names.end() ? number : 0;
}

}  // namespace

RunFolder::RunFolder(const std::string& folder, const Problem& problem, const std::string& checksum, bool resume)
    : folder_(rc_platform::path_of(folder)),
      problem_(problem),
      summary_(problem, checksum),
      earlier_(read_earlier_run(folder_.read(summary_name))) {
  const std::vector<std::string> present = folder_.names();
  remove_unfinished(present);
  refuse_foreign(present);
  if (resume && earlier_) take_up(read_earlier_run(summary_.text()).value());
}

RunFolder::~RunFolder() {
  if (unfinished_ == 0) return;
  try {
    const auto told = read_earlier_run(folder_.read(summary_name));
    if (!told || told->steps.size() >= unfinished_) return;
    for (const std::string& name : step_names(unfinished_)) folder_.remove(name);
    if (!told->steps.empty()) return;
    folder_.remove(table_name);
    folder_.remove(summary_name);
  } catch (...) {
    return;  // the next run tidies up
  }
}

// Removes the temporary files of a run that was killed.
void RunFolder::remove_unfinished(const std::vector<std::string>& present) {
  for (const std::string& name : present) {
    const std::string target{target_of_temporary(name)};
    if (of_all_steps(target) || step_of(target) > 0) folder_.remove(name);
  }
}

void RunFolder::refuse_foreign(const std::vector<std::string>& present) const {
  const std::size_t own = earlier_ ? earlier_->own_steps() : 0;
  for (const std::string& name : present) {
    const std::size_t step = step_of(name);
    if (of_all_steps(name) ? earlier_.has_value() : step <= own || step > problem_.targets.size()) continue;
    throw Error("--out: " + in_quotes(folder_.path(name).string()) +
                " exists, but belongs to no earlier run in summary.json: move it away, or give another folder");
  }
}

// A step that was interrupted is solved again.
void RunFolder::take_up(const EarlierRun& now) {
  std::vector<EarlierStep>& steps = earlier_->steps;
  if (!steps.empty() && steps.back().status == "RC_STOP_CANCELLED") steps.pop_back();
  check_continues(*earlier_, now, steps.size(), in_quotes(folder_.path(summary_name).string()));
  for (const EarlierStep& step : steps) {
    add(step.fields);
    all_certified_ = all_certified_ && step.certified();
  }
  finished_ = steps.size();
}

std::span<const EarlierStep> RunFolder::finished() const {
  return finished_ > 0 ? std::span<const EarlierStep>(earlier_->steps).first(finished_) : std::span<const EarlierStep>();
}

std::vector<std::size_t> RunFolder::certified() const {
  std::vector<std::size_t> found;
  for (std::size_t number = finished_; number > 0 && found.size() < 2; --number) {
    if (earlier_->steps[number - 1].certified()) found.push_back(number);
  }
  return found;
}

// At every moment summary.json lists only files that exist, and shows to
// which run the others belong.
void RunFolder::begin() {
  if (begun_) return;
  begun_ = true;
  const std::size_t kept = finished_, own = earlier_ ? earlier_->own_steps() : 0;
  write_whole_file(folder_.path(summary_name), summary_.text(own > kept ? own : 0));
  if (own > 0) folder_.remove(history_name);
  if (own > 0) folder_.remove(table_name);
  for (std::size_t k = kept + 1; k <= own; ++k) {
    for (const std::string& name : step_names(k)) folder_.remove(name);
  }
}

void RunFolder::add(std::span<const JsonEntry> step) {
  summary_.add(step);
  table_.add(step);
}

void RunFolder::begin_step(std::size_t number) {
  unfinished_ = number;
  begin();
}

void RunFolder::end_step(std::span<const JsonEntry> fields) {
  add(fields);
  write_whole_file(folder_.path(table_name), table_.text());
  write_whole_file(folder_.path(summary_name), summary_.text());
  unfinished_ = 0;
}

}  // namespace cli
