#include "busy.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

#include "table.h"

namespace bench {

namespace {

// Processes that do nothing but use a core each, for as long as this lives.
class Spinners {
 public:
  explicit Spinners(std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) {
      const pid_t child = fork();
      if (child < 0) throw Failure("no child process");
      if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        for (volatile std::uint64_t turns = 0;;) turns = turns + 1;
      }
      children_.push_back(child);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));  // until the scheduler has given them their cores
  }
  ~Spinners() {
    for (const pid_t child : children_) kill(child, SIGKILL);
    for (const pid_t child : children_) waitpid(child, nullptr, 0);
  }
  Spinners(const Spinners&) = delete;
  Spinners& operator=(const Spinners&) = delete;

 private:
  std::vector<pid_t> children_;
};

const std::vector<Column> columns = {{"n", "n"},
                                     {"contact %", "contact_percent", "%.2f"},
                                     {"threads", "threads"},
                                     {"others", "others"},
                                     {"idle s", "idle_median", "%.4f"},
                                     {"idle largest", "idle_largest", "%.4f"},
                                     {"busy s", "busy_median", "%.4f"},
                                     {"busy largest", "busy_largest", "%.4f"},
                                     {"ratio of medians", "ratio", "%.2f"},
                                     {"largest ratio", "ratio_largest", "%.2f"}};

}  // namespace

Json run_busy(const BusyRequest& request) {
  ColdSolve solve(request.scene);
  Json rows = Json::array();
  for (const std::int64_t threads : request.threads) {
    solve.seconds(threads);  // loads what is loaded once
    std::vector<double> idle, busy;
    for (std::int64_t k = 0; k < request.repeats; ++k) {
      idle.push_back(solve.seconds(threads));
      const Spinners others(request.others);
      busy.push_back(solve.seconds(threads));
    }
    const double median = median_of(idle), largest = *std::max_element(busy.begin(), busy.end());
    rows.push_back({{"n", request.scene.n},
                    {"contact_percent", 100 * solve.area()},
                    {"tol", request.scene.tol},
                    {"solver", solve.result().solver},
                    {"backend", solve.result().backend},
                    {"threads", threads},
                    {"others", request.others},
                    {"idle_median", median},
                    {"idle_largest", *std::max_element(idle.begin(), idle.end())},
                    {"busy_median", median_of(busy)},
                    {"busy_largest", largest},
                    {"ratio", median_of(busy) / median},
                    {"ratio_largest", largest / median},
                    {"idle", idle},
                    {"busy", busy}});
    std::cerr << threads << " threads done\n";
  }
  std::cout << "Cold solves alone and beside " << request.others
            << " processes at full load; largest ratio: the slowest busy one over the "
            << "median idle one\n"
            << table(columns, rows);
  return {{"busy", rows}};
}

}  // namespace bench
