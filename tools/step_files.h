// The files of `roughcontact solve --out`: those of every step, summary.json and steps.csv. It also reads those of an earlier run
// to resume.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "contact_measures.h"
#include "history_picture.h"
#include "problem.h"
#include "run_folder.h"
#include "step_record.h"
#include "step_writers.h"

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

  // Of the earlier run: the number of finished steps, whether all are certified, and the last two certified ones, newest first.
  int finished() const { return static_cast<int>(run_.finished().size()); }
  bool all_certified() const { return run_.all_certified(); }
  std::vector<CertifiedStep> certified() const;
  // After the last finished step; empty without a hardness.
  std::vector<double> indentation() const;

  void write(const StepRecord& step, const Fields& fields);
  // Draws all steps so far, where there are two or more.
  void write_history();

 private:
  std::vector<double> values(const char* stem, std::size_t number) const;
  void draw(const std::string& name, const std::function<Gnuplot(std::FILE*)>& picture);

  RunFolder run_;
  StepWriters writers_;
  const Problem& problem_;
  bool can_draw_ = true;
  std::vector<HistoryPoint> history_;
};

}  // namespace cli
