// The files of `roughcontact solve --out`: those of every step, summary.json and steps.csv. It also reads those of an earlier run
// to resume.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "files/run_folder.h"
#include "files/step_writers.h"
#include "pictures/history.h"
#include "solve/contact_measures.h"
#include "solve/problem.h"
#include "solve/step_record.h"
#include "solve/step_solver.h"

namespace cli {

class StepFiles {
 public:
  struct Choice {
    bool resume = false;  // continue after the steps that an earlier run of the same problem wrote, if there was one
    bool maps = true;     // write the fields and the picture of each step
    bool pictures = true;
    StepWriters writers;  // of more files of each step
  };

  // Throws if the folder has files with names that this run would write and that no summary.json lists.
  StepFiles(const std::string& folder, const Problem& problem, Choice choice);

  // The earlier run's number of complete steps, whether all are certified, and the last two certified ones, newest first.
  int complete() const { return static_cast<int>(run_.complete().size()); }
  bool all_certified() const { return run_.all_certified(); }
  std::vector<CertifiedStep> certified() const;
  // After the last complete step; empty without a hardness.
  std::vector<double> indentation() const;
  // The same of creep, empty without it.
  Left left() const;

  void write(const StepRecord& step, const Fields& fields);
  // Draws all steps so far, if there are two or more.
  void write_history();

 private:
  std::vector<double> values(const char* stem, std::size_t number, std::int64_t maps = 1) const;
  void write_maps(const StepRecord& step, const Fields& fields, const std::vector<JsonEntry>& values);
  std::string draw(const std::string& name, const std::function<Gnuplot(std::FILE*)>& picture);

  RunFolder run_;
  const Problem& problem_;
  bool maps_;
  StepWriters writers_;
  bool can_draw_, heights_written_ = false;
  std::vector<HistoryPoint> history_;
};

}  // namespace cli
