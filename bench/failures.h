// The failure atlas: where methods for this contact problem fail, how the library tells, and what it does about it.
#pragma once

#include <string>
#include <vector>

#include "child.h"

namespace bench {

struct FailuresRequest {
  bool quick = false;             // fewer draws, smaller surfaces
  std::vector<std::string> rows;  // families by name; empty: all
  std::string surface;            // a measured surface for the family cmr; empty: none
};

// What a family reports: the atlas' rows for readers, and every number behind them.
class Atlas {
 public:
  struct Row {
    std::string trigger, happens, detected, remedy;
  };
  void add(const std::string& family, const Row& row);
  // One record of the table of that name.
  void record(const std::string& name, const Json& values) { data_[name].push_back(values); }
  const Json& rows() const { return rows_; }
  const Json& data() const { return data_; }

 private:
  Json rows_ = Json::array(), data_ = Json::object();
};

// The families, each in a file of its own.
void greedy_failures(const FailuresRequest& request, Atlas& atlas);
void polonsky_keer_failures(const FailuresRequest& request, Atlas& atlas);
void nnls_failures(const FailuresRequest& request, Atlas& atlas);
void gradient_failures(const FailuresRequest& request, Atlas& atlas);
void admm_failures(const FailuresRequest& request, Atlas& atlas);
void cmr_failures(const FailuresRequest& request, Atlas& atlas);
void conditioning_failures(const FailuresRequest& request, Atlas& atlas);

std::vector<std::string> failure_families();
Json run_failures(const FailuresRequest& request);

}  // namespace bench
