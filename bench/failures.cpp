#include "failures.h"

#include <algorithm>
#include <iostream>

#include "library.h"

namespace bench {

namespace {

struct Family {
  const char* name;
  void (*run)(const FailuresRequest&, Atlas&);
};
constexpr Family families[] = {{"greedy", greedy_failures},
                               {"polonsky-keer", polonsky_keer_failures},
                               {"nnls", nnls_failures},
                               {"gp", gradient_failures},
                               {"admm", admm_failures},
                               {"cmr", cmr_failures},
                               {"conditioning", conditioning_failures}};

}  // namespace

void Atlas::add(const std::string& family, const Row& row) {
  rows_.push_back(
      {{"row", family}, {"trigger", row.trigger}, {"happens", row.happens}, {"detected", row.detected}, {"library", row.remedy}});
  std::cout << '[' << family << "] " << row.trigger << "\n  happens:  " << row.happens << "\n  detected: " << row.detected
            << "\n  library:  " << row.remedy << '\n'
            << std::flush;
}

std::vector<std::string> failure_families() {
  std::vector<std::string> names;
  for (const Family& family : families) names.emplace_back(family.name);
  return names;
}

Json run_failures(const FailuresRequest& request) {
  Atlas atlas;
  for (const Family& family : families) {
    if (!request.rows.empty() && std::find(request.rows.begin(), request.rows.end(), family.name) == request.rows.end()) continue;
    std::cerr << "atlas: " << family.name << '\n';
    family.run(request, atlas);
  }
  return {{"atlas", atlas.rows()}, {"data", atlas.data()}};
}

}  // namespace bench
