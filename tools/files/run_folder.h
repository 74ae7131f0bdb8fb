// The folder of --out as a history fills it: summary.json, steps.csv and the names of the files of every step. It knows an
// earlier run that may be resumed, and what belongs to none. The arrays of a step are written by whoever has them.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "files/earlier_run.h"
#include "files/output_folder.h"
#include "files/step_fields.h"
#include "files/summary.h"
#include "solve/problem.h"

namespace cli {

inline constexpr const char* history_name = "history.png";
inline constexpr const char* heights_name = "heights.npy";

// "pressure-3.npy", "pressure-03.npy" of a history of ten steps and more: the names sort as the steps do.
std::string step_name(const char* stem, std::size_t number, const char* extension, std::size_t steps);

class RunFolder {
 public:
  // Throws if the folder has files with names that this run would write and that no summary.json lists. resume: continues after
  // the steps that an earlier run of the same problem wrote, if there was one; their files get the names that they have
  // in this one. checksum: of the heights.
  RunFolder(const std::string& folder, const Problem& problem, const std::string& checksum, bool resume);
  // Removes the files of a step if not all of them could be written.
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  // The earlier run's complete steps, oldest first; whether all are certified; and the numbers, from 1 on, of the last two
  // certified ones, newest first.
  std::span<const EarlierStep> complete() const;
  bool all_certified() const { return all_certified_; }
  std::vector<std::size_t> certified() const;

  // From here on summary.json is of this run, and the files of steps that an earlier one did not finish are gone.
  void begin();
  // Before the files of a step are written, and after: the step is then in summary.json and steps.csv.
  void begin_step(std::size_t number);
  void end_step(std::span<const JsonEntry> fields);

  std::string step_name(const char* stem, std::size_t number, const char* extension) const {
    return cli::step_name(stem, number, extension, problem_.targets.size());
  }
  OutputFolder& files() { return folder_; }
  const OutputFolder& files() const { return folder_; }

 private:
  void remove_unfinished(const std::vector<std::string>& present);
  void refuse_foreign(const std::vector<std::string>& present) const;
  void take_up(const EarlierRun& now, const std::vector<std::string>& present);
  void remove_steps(std::size_t first, std::size_t last);
  void add(std::span<const JsonEntry> step);

  OutputFolder folder_;
  const Problem& problem_;
  Summary summary_;
  StepTable table_;
  std::optional<EarlierRun> earlier_;
  std::size_t complete_ = 0;
  bool all_certified_ = true, begun_ = false;
  std::size_t unfinished_ = 0;  // the step whose files are being written; 0: none
};

}  // namespace cli
