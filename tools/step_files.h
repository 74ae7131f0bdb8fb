// The files of `roughcontact solve --out`: those of every step, summary.json and steps.csv. It also reads those of an earlier run
// to resume.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "contact_measures.h"
#include "earlier_run.h"
#include "history_picture.h"
#include "output_folder.h"
#include "problem.h"
#include "step_record.h"
#include "step_table.h"
#include "step_writers.h"
#include "summary.h"

namespace cli {

// A certified step of an earlier run.
struct CertifiedStep {
  std::vector<double> pressure;
  double approach = 0, load = 0;
};

class StepFiles {
 public:
  // Throws if the folder has files with names that this run would write and that no summary.json lists. resume: continues after
  // the steps that an earlier run of the same problem has finished, if there was one. writers: of more files of each step.
  StepFiles(const std::string& folder, const Problem& problem, bool resume, StepWriters writers);
  // Removes the files of a step if not all of them could be written.
  ~StepFiles();
  StepFiles(const StepFiles&) = delete;
  StepFiles& operator=(const StepFiles&) = delete;

  // Of the earlier run: the number of finished steps, whether all are certified, and the last two certified ones, newest first.
  int finished() const { return finished_; }
  bool all_certified() const { return all_certified_; }
  std::vector<CertifiedStep> certified() const;
  // After the last finished step; empty without a hardness.
  std::vector<double> indentation() const;

  void write(const StepRecord& step, const Fields& fields);
  // Draws all steps so far, where there are two or more.
  void write_history();

 private:
  std::vector<double> values(const char* stem, std::size_t number) const;
  void remove_unfinished(const std::vector<std::string>& present);
  void refuse_foreign(const std::vector<std::string>& present) const;
  void take_up(const EarlierRun& now);
  void begin();
  void add(std::span<const JsonEntry> step);
  void draw(const std::string& name, const std::function<Gnuplot(std::FILE*)>& picture);

  OutputFolder folder_;
  StepWriters writers_;
  const Problem& problem_;
  Summary summary_;
  StepTable table_;
  std::optional<EarlierRun> earlier_;
  int finished_ = 0;
  bool all_certified_ = true, begun_ = false, can_draw_ = true;
  std::vector<HistoryPoint> history_;
  std::size_t unfinished_ = 0;  // the step whose files are being written; 0: none
};

}  // namespace cli
