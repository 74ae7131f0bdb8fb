#include "files/step_files.h"

#include <future>
#include <limits>
#include <string_view>
#include <utility>

#include "core/text.h"
#include "files/array_files.h"
#include "files/step_fields.h"
#include "formats/error.h"
#include "formats/surface.h"
#include "pictures/contact.h"
#include "platform/files.h"
#include "text.h"

namespace cli {

namespace {

HistoryPoint history_point(const EarlierStep& step) {
  const auto number = [&step](std::string_view field) {
    for (const auto& [place, value] : step.fields) {
      if (place.ends_with(field)) return number_in(value, std::numeric_limits<double>::quiet_NaN());
    }
    return std::numeric_limits<double>::quiet_NaN();
  };
  return {step.load,           step.approach,        number("/area_fraction"), number("/corrected_area"),
          number("/mean_gap"), number("/stiffness"), number("/time")};
}

void tell(const std::string& fault) {
  if (!fault.empty()) report(fault);
}

std::string checksum_of(const Problem& problem) {
  Checksum sum;
  sum.add(problem.input.surface.heights);
  return sum.text();
}

// As pressed, NaN where a point is excluded.
std::vector<double> heights_of(const Problem& problem) {
  const auto& [surface, mask] = std::pair(problem.input.surface.heights, problem.input.mask);
  std::vector<double> heights(surface.begin(), surface.end());
  for (std::size_t i = 0; mask && i < heights.size(); ++i)
    if (mask[i] == 0) heights[i] = std::numeric_limits<double>::quiet_NaN();
  return heights;
}

}  // namespace

StepFiles::StepFiles(const std::string& folder, const Problem& problem, Choice choice)
    : run_(folder, problem, checksum_of(problem), choice.resume),
      problem_(problem),
      maps_(choice.maps),
      writers_(std::move(choice.writers)),
      can_draw_(choice.pictures) {
  for (const EarlierStep& step : run_.complete()) history_.push_back(history_point(step));
}

std::vector<CertifiedStep> StepFiles::certified() const {
  std::vector<CertifiedStep> found;
  for (const std::size_t number : run_.certified()) {
    const EarlierStep& step = run_.complete()[number - 1];
    found.push_back({values("pressure", number), step.approach, step.load});
  }
  return found;
}

std::vector<double> StepFiles::indentation() const {
  if (!(problem_.system.hardness > 0) || run_.complete().empty()) return {};
  return values("indentation", run_.complete().size());
}

Left StepFiles::left() const {
  Left found;
  if (problem_.system.creep_terms == 0 || run_.complete().empty()) return found;
  found.creep = values("creep", run_.complete().size(), problem_.system.creep_terms + 1);
  const std::vector<std::size_t> certified = run_.certified();
  found.time = certified.empty() ? std::numeric_limits<double>::quiet_NaN() : problem_.times[certified.front() - 1];
  return found;
}

std::vector<double> StepFiles::values(const char* stem, std::size_t number, std::int64_t maps) const {
  const std::string name = run_.step_name(stem, number, "npy");
  const Surface read = read_surface(run_.files().path(name), {}, "npy");
  if (read.nx != problem_.system.nx || read.ny != maps * problem_.system.ny)
    throw Error("--resume: ", name, " has ", read.nx, " x ", read.ny, " points, the surface has ", problem_.system.nx, " x ",
                problem_.system.ny, maps > 1 ? rc::join(", and ", maps, " maps are needed") : "");
  return read.heights;
}

void StepFiles::write_maps(const StepRecord& step, const Fields& fields, const std::vector<JsonEntry>& values) {
  const auto name = [&](const char* stem, const char* extension) {
    return run_.step_name(stem, static_cast<std::size_t>(step.number), extension);
  };
  const auto array_file = [&](const std::string& file_name, const std::vector<double>& field) {
    run_.files().write(file_name, [&](std::FILE* file) {
      write_npy(file, field, problem_.system.nx, static_cast<std::int64_t>(field.size()) / problem_.system.nx);
      return true;
    });
  };
  const auto array = [&](const char* stem, const std::vector<double>& field) { array_file(name(stem, "npy"), field); };
  if (!heights_written_) array_file(heights_name, heights_of(problem_));
  heights_written_ = true;
  // The picture is drawn while the arrays are written.
  std::future<std::string> drawn;
  if (can_draw_)
    drawn = std::async(std::launch::async, [&] {
      return draw(name("contact", "png"), [&](std::FILE* file) {
        return draw_picture({problem_.input.surface, fields.pressure, step, problem_.targets.size()}, file);
      });
    });
  array("pressure", fields.pressure);
  array("gap", fields.gap);
  if (!fields.indentation.empty()) array("indentation", fields.indentation);
  if (!fields.creep.empty()) array("creep", fields.creep);
  for (const NamedWriter& writer : writers_) {
    run_.files().write(name("step", writer.extension), [&](std::FILE* file) {
      writer.write(make_image(problem_, values, fields), file);
      return true;
    });
  }
  if (drawn.valid()) tell(drawn.get());
}

void StepFiles::write(const StepRecord& step, const Fields& fields) {
  run_.begin_step(static_cast<std::size_t>(step.number));
  const std::vector<JsonEntry> values = step_fields(step, problem_);
  if (maps_) write_maps(step, fields, values);
  history_.push_back({step.result.load, step.result.approach, step.result.area_fraction, step.measures.corrected_area,
                      step.result.mean_gap, step.result.stiffness,
                      problem_.step_time(static_cast<std::size_t>(step.number - 1))});
  run_.end_step(values);
  // Only the last one is needed to go on, and it has a map for each term.
  if (!fields.creep.empty() && step.number > 1)
    run_.files().remove(run_.step_name("creep", static_cast<std::size_t>(step.number - 1), "npy"));
}

void StepFiles::write_history() {
  if (history_.size() < 2 || !can_draw_) return;
  tell(draw(history_name, [this](std::FILE* file) { return draw_history(problem_, history_, file); }));
}

// Returns what is to be reported of a picture that could not be drawn.
std::string StepFiles::draw(const std::string& name, const std::function<Gnuplot(std::FILE*)>& picture) {
  std::string fault;
  run_.files().write(name, [&](std::FILE* file) {
    const Gnuplot outcome = picture(file);
    can_draw_ = !outcome.missing;
    if (outcome.missing) {
      if (name != history_name) fault = "gnuplot not found: contact-K.png not drawn";  // else reported before
    } else if (!outcome.drawn) {
      fault = name + " not drawn, gnuplot failed: " + outcome.message;
    }
    return outcome.drawn;
  });
  return fault;
}

}  // namespace cli
