#include "step_files.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <utility>

#include "error.h"
#include "npy_writer.h"
#include "picture.h"
#include "platform/files.h"
#include "step_fields.h"
#include "surface.h"
#include "text.h"
#include "whole_file.h"

namespace cli {

namespace {

constexpr const char* summary_name = "summary.json";
constexpr const char* history_name = "history.png";
constexpr const char* table_name = "steps.csv";

// Whether a file of this name is of the whole history.
bool of_all_steps(std::string_view name) { return name == summary_name || name == history_name || name == table_name; }

std::string step_name(const char* stem, std::size_t number, const char* extension) {
  return format("%s-%zu.%s", stem, number, extension);
}

std::vector<std::string> step_names(std::size_t number) {
  std::vector<std::string> names = {step_name("pressure", number, "npy"), step_name("gap", number, "npy"),
                                    step_name("indentation", number, "npy"), step_name("contact", number, "png")};
  for (const char* extension : step_extensions) names.push_back(step_name("step", number, extension));
  return names;
}

HistoryPoint history_point(const EarlierStep& step) {
  const auto number = [&step](std::string_view field) {
    for (const auto& [place, value] : step.fields) {
      if (place.ends_with(field) && value.is_number()) return value.get<double>();
    }
    return std::numeric_limits<double>::quiet_NaN();
  };
  return {step.load, number("/area_fraction"), number("/corrected_area"), number("/mean_gap"), number("/stiffness")};
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

StepFiles::StepFiles(const std::string& folder, const Problem& problem, bool resume, StepWriters writers)
    : folder_(rc_platform::path_of(folder)),
      writers_(std::move(writers)),
      problem_(problem),
      summary_(problem),
      earlier_(read_earlier_run(folder_.read(summary_name))) {
  const std::vector<std::string> present = folder_.names();
  remove_unfinished(present);
  refuse_foreign(present);
  if (resume && earlier_) take_up(read_earlier_run(summary_.text()).value());
}

StepFiles::~StepFiles() {
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
void StepFiles::remove_unfinished(const std::vector<std::string>& present) {
  for (const std::string& name : present) {
    const std::string target{target_of_temporary(name)};
    if (of_all_steps(target) || step_of(target) > 0) folder_.remove(name);
  }
}

void StepFiles::refuse_foreign(const std::vector<std::string>& present) const {
  const std::size_t own = earlier_ ? earlier_->own_steps() : 0;
  for (const std::string& name : present) {
    const std::size_t step = step_of(name);
    if (of_all_steps(name) ? earlier_.has_value() : step <= own || step > problem_.targets.size()) continue;
    throw Error("--out: " + in_quotes(folder_.path(name).string()) +
                " exists, but belongs to no earlier run in summary.json: move it away, or give another folder");
  }
}

// A step that was interrupted is solved again.
void StepFiles::take_up(const EarlierRun& now) {
  std::vector<EarlierStep>& steps = earlier_->steps;
  if (!steps.empty() && steps.back().status == "RC_STOP_CANCELLED") steps.pop_back();
  check_continues(*earlier_, now, steps.size(), in_quotes(folder_.path(summary_name).string()));
  for (const EarlierStep& step : steps) {
    add(step.fields);
    history_.push_back(history_point(step));
    all_certified_ = all_certified_ && step.certified();
  }
  finished_ = static_cast<int>(steps.size());
}

std::vector<CertifiedStep> StepFiles::certified() const {
  std::vector<CertifiedStep> found;
  for (auto number = static_cast<std::size_t>(finished_); number > 0 && found.size() < 2; --number) {
    const EarlierStep& step = earlier_->steps[number - 1];
    if (!step.certified()) continue;
    found.push_back({values("pressure", number), step.approach, step.load});
  }
  return found;
}

std::vector<double> StepFiles::indentation() const {
  if (!(problem_.system.hardness > 0) || finished_ == 0) return {};
  return values("indentation", static_cast<std::size_t>(finished_));
}

std::vector<double> StepFiles::values(const char* stem, std::size_t number) const {
  const std::string name = step_name(stem, number, "npy");
  const Surface read = read_surface(folder_.path(name), 1, "npy");
  if (read.nx != problem_.system.nx || read.ny != problem_.system.ny)
    throw Error(format("--resume: %s has %lld x %lld points, the surface has %lld x %lld", name.c_str(),
                       static_cast<long long>(read.nx), static_cast<long long>(read.ny),
                       static_cast<long long>(problem_.system.nx), static_cast<long long>(problem_.system.ny)));
  return read.heights;
}

// Called before the first file of this run is written. At every moment summary.json lists only files that exist, and shows to
// which run the others belong.
void StepFiles::begin() {
  begun_ = true;
  const std::size_t kept = static_cast<std::size_t>(finished_), own = earlier_ ? earlier_->own_steps() : 0;
  write_whole_file(folder_.path(summary_name), summary_.text(own > kept ? own : 0));
  if (own > 0) folder_.remove(history_name);
  if (own > 0) folder_.remove(table_name);
  for (std::size_t k = kept + 1; k <= own; ++k) {
    for (const std::string& name : step_names(k)) folder_.remove(name);
  }
}

void StepFiles::add(std::span<const JsonEntry> step) {
  summary_.add(step);
  table_.add(step);
}

void StepFiles::write(const StepRecord& step, const Fields& fields) {
  const auto number = unfinished_ = static_cast<std::size_t>(step.number);
  if (!begun_) begin();
  const auto array = [this](const std::vector<double>& values) {
    return [this, &values](std::FILE* file) {
      write_npy(file, values, problem_.system.nx, problem_.system.ny);
      return true;
    };
  };
  folder_.write(step_name("pressure", number, "npy"), array(fields.pressure));
  folder_.write(step_name("gap", number, "npy"), array(fields.gap));
  if (!fields.indentation.empty()) folder_.write(step_name("indentation", number, "npy"), array(fields.indentation));
  const std::vector<JsonEntry> values = step_fields(step, problem_.system.hardness > 0);
  for (const NamedWriter& writer : writers_) {
    folder_.write(step_name("step", number, writer.extension), [&](std::FILE* file) {
      writer.write(make_image(problem_, values, fields), file);
      return true;
    });
  }
  if (can_draw_) {
    draw(step_name("contact", number, "png"), [&](std::FILE* file) {
      return draw_picture({problem_.input.surface, fields.pressure, step, problem_.targets.size()}, file);
    });
  }
  history_.push_back(
      {step.result.load, step.area_fraction(), step.measures.corrected_area, step.measures.mean_gap, step.result.stiffness});

  add(values);
  write_whole_file(folder_.path(table_name), table_.text());
  write_whole_file(folder_.path(summary_name), summary_.text());
  unfinished_ = 0;
}

void StepFiles::write_history() {
  if (history_.size() < 2 || !can_draw_) return;
  draw(history_name, [this](std::FILE* file) { return draw_history(problem_, history_, file); });
}

void StepFiles::draw(const std::string& name, const std::function<Gnuplot(std::FILE*)>& picture) {
  folder_.write(name, [&](std::FILE* file) {
    const Gnuplot outcome = picture(file);
    can_draw_ = !outcome.missing;
    if (outcome.missing) {
      if (name != history_name) report("gnuplot not found: contact-K.png not drawn");  // else told before
    } else if (!outcome.drawn) {
      report(name + " not drawn, gnuplot failed: " + outcome.message);
    }
    return outcome.drawn;
  });
}

}  // namespace cli
