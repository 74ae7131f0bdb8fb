// What the comparison of speed with accuracy hands on: scenes for other codes, and its rows as a table.
#pragma once

#include <string>
#include <utility>

#include "child.h"
#include "pareto_truth.h"

namespace bench {

// Gaps and certified pressures as .npy, named in a file scenes.json, in one folder.
class ParetoExports {
 public:
  explicit ParetoExports(std::string folder) : folder_(std::move(folder)) {}
  void add(const ParetoCase& of, const Truth& truth);
  void write_list() const;

 private:
  std::string write(const std::string& name, const Field& field, std::int64_t n) const;

  std::string folder_;
  Json list_ = Json::array();
};

// One line for each solve of the lists "methods" and "grids".
void write_pareto_csv(const Json& document, const std::string& file);

}  // namespace bench
