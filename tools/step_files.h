// What `roughcontact solve --out` writes: the files of every step and summary.json, and what it takes up again of an earlier run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "earlier_run.h"
#include "output_folder.h"
#include "problem.h"
#include "step_record.h"
#include "summary.h"

namespace cli {

// Pressures and deformed gaps of a step.
struct Fields {
  explicit Fields(std::size_t points) : pressure(points), gap(points) {}
  std::vector<double> pressure, gap;
};

// A certified step of an earlier run.
struct CertifiedStep {
  std::vector<double> pressure;
  double approach = 0, load = 0;
};

class StepFiles {
 public:
  // Throws where the folder holds files with the names of this run's that no summary.json lists. `resume`: goes on after the
  // steps that an earlier run of the same problem has finished, if there was one.
  StepFiles(const std::string& folder, const Problem& problem, bool resume);
  // A step whose files could not all be written leaves none.
  ~StepFiles();
  StepFiles(const StepFiles&) = delete;
  StepFiles& operator=(const StepFiles&) = delete;

  // Of the earlier run: how many steps are done, whether all of them are certified, the last two that are (the newest first).
  int finished() const { return finished_; }
  bool all_certified() const { return all_certified_; }
  std::vector<CertifiedStep> certified() const;

  void write(const StepRecord& step, const Fields& fields);

 private:
  void remove_unfinished(const std::vector<std::string>& present);
  void refuse_foreign(const std::vector<std::string>& present) const;
  void take_up(const EarlierRun& now);
  void begin();
  void write_summary(const std::string& text);
  void draw(const StepRecord& step, const Fields& fields);

  OutputFolder folder_;
  const Problem& problem_;
  Summary summary_;
  std::optional<EarlierRun> earlier_;
  int finished_ = 0;
  bool all_certified_ = true, begun_ = false, can_draw_ = true;
  std::size_t unfinished_ = 0;  // the step whose files are being written; 0: none
};

}  // namespace cli
