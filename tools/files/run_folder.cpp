#include "files/run_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>

#include "files/outputs.h"
#include "files/step_writers.h"
#include "formats/error.h"
#include "platform/output.h"
#include "text.h"

namespace cli {

std::string step_name(const char* stem, std::size_t number, const char* extension, std::size_t steps) {
  return format("%s-%0*zu.%s", stem, static_cast<int>(std::to_string(steps).size()), number, extension);
}

namespace {

constexpr const char* summary_name = "summary.json";
constexpr const char* table_name = "steps.csv";

// Whether a file of this name is of the whole history.
bool of_all_steps(std::string_view name) {
  return name == summary_name || name == history_name || name == table_name || name == heights_name;
}

// The name of a step's file in its parts: "pressure-03.npy".
struct StepName {
  std::string stem;
  std::size_t number;  // 0: it is not of a step
  std::string extension;
};

StepName parts_of(const std::string& name) {
  constexpr std::pair<std::string_view, std::string_view> maps[] = {
      {"pressure", "npy"}, {"gap", "npy"}, {"indentation", "npy"}, {"creep", "npy"}, {"contact", "png"}};
  const auto dash = name.find('-'), dot = name.find('.');
  if (dash == std::string::npos || dot == std::string::npos || dot < dash + 2) return {};
  const std::string digits = name.substr(dash + 1, dot - dash - 1);
  if (digits.size() > 9 || digits.find_first_not_of("0123456789") != std::string::npos) return {};
  const StepName parts{name.substr(0, dash), std::strtoul(digits.c_str(), nullptr, 10), name.substr(dot + 1)};
  const bool map = std::ranges::count(maps, std::pair<std::string_view, std::string_view>{parts.stem, parts.extension}) > 0;
  const bool written = parts.stem == "step" && std::ranges::count(step_extensions, parts.extension) > 0;
  return map || written ? parts : StepName{};
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
  if (resume && earlier_) take_up(read_earlier_run(summary_.text()).value(), present);
}

RunFolder::~RunFolder() {
  if (unfinished_ == 0) return;
  try {
    const auto earlier = read_earlier_run(folder_.read(summary_name));
    if (!earlier || earlier->steps.size() >= unfinished_) return;
    remove_steps(unfinished_, unfinished_);
    if (!earlier->steps.empty()) return;
    folder_.remove(heights_name);
    folder_.remove(table_name);
    folder_.remove(summary_name);
  } catch (...) {
    return;  // the next run tidies up
  }
}

// Removes the temporary files of a run that was killed.
void RunFolder::remove_unfinished(const std::vector<std::string>& present) {
  for (const std::string& name : present) {
    const std::string target{rc_platform::target_of_temporary(name)};
    if (of_all_steps(target) || parts_of(target).number > 0) folder_.remove(name);
  }
}

void RunFolder::refuse_foreign(const std::vector<std::string>& present) const {
  const std::size_t own = earlier_ ? earlier_->own_steps() : 0;
  for (const std::string& name : present) {
    const std::size_t step = parts_of(name).number;
    if (of_all_steps(name) || step > 0) folder_.refuse_special(name);
    if (of_all_steps(name) ? earlier_.has_value() : step <= own || step > problem_.targets.size()) continue;
    throw Error("--out: ", in_quotes(folder_.path(name).string()),
                " exists, but belongs to no earlier run in summary.json: move it away, or give another folder");
  }
}

// A step that was interrupted is solved again.
void RunFolder::take_up(const EarlierRun& now, const std::vector<std::string>& present) {
  std::vector<EarlierStep>& steps = earlier_->steps;
  if (!steps.empty() && steps.back().status == "RC_STOP_CANCELLED") steps.pop_back();
  check_continues(*earlier_, now, steps.size(), in_quotes(folder_.path(summary_name).string()));
  for (const EarlierStep& step : steps) {
    add(step.fields);
    all_certified_ = all_certified_ && step.certified();
  }
  complete_ = steps.size();
  for (const std::string& name : present) {
    const StepName parts = parts_of(name);
    if (parts.number == 0 || parts.number > complete_) continue;
    const std::string here = step_name(parts.stem.c_str(), parts.number, parts.extension.c_str());
    if (here != name && !rc_platform::rename_over(folder_.path(name), folder_.path(here)))
      throw Error("--resume: cannot rename ", in_quotes(folder_.path(name).string()), " to ", here, ": ", std::strerror(errno));
  }
}

void RunFolder::remove_steps(std::size_t first, std::size_t last) {
  if (last < first) return;
  for (const std::string& name : folder_.names()) {
    const std::size_t number = parts_of(name).number;
    if (number >= first && number <= last) folder_.remove(name);
  }
}

std::span<const EarlierStep> RunFolder::complete() const {
  return complete_ > 0 ? std::span<const EarlierStep>(earlier_->steps).first(complete_) : std::span<const EarlierStep>();
}

std::vector<std::size_t> RunFolder::certified() const {
  std::vector<std::size_t> found;
  for (std::size_t number = complete_; number > 0 && found.size() < 2; --number) {
    if (earlier_->steps[number - 1].certified()) found.push_back(number);
  }
  return found;
}

// At every moment summary.json lists only files that exist, and shows to
// which run the others belong.
void RunFolder::begin() {
  if (begun_) return;
  begun_ = true;
  const std::size_t kept = complete_, own = earlier_ ? earlier_->own_steps() : 0;
  write_output(folder_.path(summary_name), summary_.text(own > kept ? own : 0));
  if (own > 0) folder_.remove(history_name);
  if (own > 0) folder_.remove(table_name);
  if (own > 0 && kept == 0) folder_.remove(heights_name);
  remove_steps(kept + 1, own);
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
  write_output(folder_.path(table_name), table_.text());
  write_output(folder_.path(summary_name), summary_.text());
  unfinished_ = 0;
}

}  // namespace cli
