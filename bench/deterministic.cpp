#include "deterministic.h"

#include <algorithm>
#include <bit>
#include <iostream>
#include <string>

#include "table.h"

namespace bench {

namespace {

using More = std::vector<std::pair<std::string, std::string>>;

constexpr const char* key = "deterministic";

// What may be left out with results that need not repeat: nothing, or plans by measurement too.
struct Choice {
  const char* name;
  More options;
};
const Choice choices[] = {
    {"1", {{key, "1"}}}, {"0", {{key, "0"}}}, {"0, measured plans", {{key, "0"}, {"fft.planning", "measure"}}}};

// Fowler, Noll & Vo's hash of 64 bits, of all bits.
std::uint64_t hash_of(const Field& values) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const double value : values) hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3;
  return hash;
}

// Two solves in a process of their own, so that plans of other choices are not known: the first also loads and plans.
Json timed(ColdSolve& solve, std::int64_t threads, const Choice& choice) {
  solve.seconds(threads, choice.options);
  const std::uint64_t first = hash_of(solve.pressure());
  const double seconds = solve.seconds(threads, choice.options);
  return {{"seconds", seconds}, {"contact_percent", 100 * solve.area()}, {"first", first}, {"second", hash_of(solve.pressure())}};
}

const std::vector<Column> columns = {{"n", "n"},
                                     {"threads", "threads"},
                                     {"deterministic", "choice"},
                                     {"s, median", "median", "%.4f"},
                                     {"s, best", "best", "%.4f"},
                                     {"1 costs, median", "cost_median", "%+.3f"},
                                     {"1 costs, best", "cost_best", "%+.3f"},
                                     {"same bits as 1 thread", "same_as_one_thread"},
                                     {"same bits again", "same_again"}};

}  // namespace

Json run_deterministic(const DeterministicRequest& request) {
  try {
    Options().set(key, std::string("1"));
  } catch (const Failure& failure) {
    std::cout << "This library has no option \"" << key << "\": " << failure.what() << '\n';
    return {{"missing", failure.what()}};
  }
  ColdSolve solve(request.scene);
  constexpr std::size_t count = std::size(choices);
  Json rows = Json::array();
  std::uint64_t one_thread[count] = {};
  for (const std::int64_t threads : {std::int64_t{1}, request.threads}) {
    std::uint64_t first[count] = {};
    bool again[count];
    std::fill_n(again, count, true);
    std::vector<double> seconds[count];
    double percent = 0;
    // In turns, so that other work on the machine meets all of them.
    for (std::int64_t k = 0; k < request.repeats; ++k)
      for (std::size_t c = 0; c < count; ++c) {
        const Json run = in_child([&] { return timed(solve, threads, choices[c]); });
        if (run.contains("error")) throw Failure(run.at("error").get<std::string>());
        if (k == 0) first[c] = run.at("first");
        seconds[c].push_back(run.at("seconds"));
        again[c] = again[c] && run.at("first") == first[c] && run.at("second") == first[c];
        percent = run.at("contact_percent");
      }
    const double median = median_of(seconds[0]), best = *std::min_element(seconds[0].begin(), seconds[0].end());
    for (std::size_t c = 0; c < count; ++c) {
      if (threads == 1) one_thread[c] = first[c];
      const double other = median_of(seconds[c]), other_best = *std::min_element(seconds[c].begin(), seconds[c].end());
      rows.push_back({{"n", request.scene.n},
                      {"contact_percent", percent},
                      {"tol", request.scene.tol},
                      {"threads", threads},
                      {"choice", choices[c].name},
                      {"median", other},
                      {"best", other_best},
                      {"cost_median", median / other - 1},
                      {"cost_best", best / other_best - 1},
                      {"same_as_one_thread", one_thread[c] == first[c] ? "yes" : "no"},
                      {"same_again", again[c] ? "yes" : "no"}});
    }
    std::cerr << threads << " threads done\n";
    if (request.threads == 1) break;
  }
  std::cout << table(columns, rows);
  return {{"deterministic", rows}};
}

}  // namespace bench
