// Random scenes of many kinds: every step ends certified, and an independent check agrees.
//   test_random_scenes [--scenes A:B] [--jobs J] [--seed S] [--above N] [--pair SOLVER*BACKEND]
// Steps with more than N products are listed. --pair: every scene by this one.
#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdio>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>

#include "scene.h"
#include "support/registry.h"
#include "verification.h"

namespace scenes {

namespace {

using pairs::check, pairs::text;

struct Slice {
  std::uint64_t first = 0, end = 3000, seed = 1;
  int jobs = 1;
  std::int64_t above = std::numeric_limits<std::int64_t>::max();
  std::optional<pairs::Pair> pair{};
};

std::string residuals(const pairs::Answer& answer) {
  const rc_result& r = answer.result;
  return std::string(rc_status_name(answer.status)) + ", products " + std::to_string(r.products) + ", contacts " +
         std::to_string(r.contacts) + ", kkt " + text(r.kkt_primal) + " " + text(r.kkt_dual) + " " + text(r.kkt_complementarity) +
         " " + text(r.kkt_control);
}

// The arguments that repeat the scene, then its name and what happened.
std::string line(const Scene& scene, const std::string& what) {
  return "--scenes " + std::to_string(scene.number) + ":" + std::to_string(scene.number + 1) + "  " + scene.name + ", " + what;
}

// Findings besides passes and failures, shared by all jobs.
class Record {
 public:
  explicit Record(std::int64_t above) : above_(above) {}
  void add(const Scene& scene, const Step& step, const pairs::Answer& answer) {
    const std::lock_guard lock(mutex_);
    if (answer.result.products > above_) std::fprintf(stderr, "%s\n", line(scene, step.name + ": " + residuals(answer)).c_str());
    products_[pairs::group_name(scene.pair, scene.problem.system, step.control)].push_back(
        {answer.result.products, scene.number});
    // Notes are counted by their text before the first number.
    std::string_view note = answer.result.note;
    for (std::size_t end = 0; !note.empty(); note.remove_prefix(std::min(end + 2, note.size()))) {
      end = std::min(note.find("; "), note.size());
      ++notes_[std::string(note.substr(0, std::min(end, note.find_first_of("0123456789"))))];
    }
  }
  void add_failure(const std::string& line) {
    const std::lock_guard lock(mutex_);
    ++failures_;
    std::fprintf(stderr, "%s\n", line.c_str());
  }
  void print() {
    for (auto& [group, counts] : products_) {
      std::ranges::sort(counts);
      double total = 0;
      for (const auto& [count, number] : counts) total += static_cast<double>(count);
      const auto n = counts.size();
      pairs::report(group + ": " + std::to_string(n) + " steps, products mean " + text(total / static_cast<double>(n)) +
                    ", p99 " + std::to_string(counts[n - 1 - n / 100].first) + ", most " + std::to_string(counts.back().first) +
                    " (scene " + std::to_string(counts.back().second) + ")");
    }
    for (const auto& [note, count] : notes_) pairs::report(std::to_string(count) + " times: " + note);
  }
  std::int64_t failures() const { return failures_; }

 private:
  const std::int64_t above_;
  std::mutex mutex_;
  std::map<std::string, std::vector<std::pair<std::int64_t, std::uint64_t>>> products_;
  std::map<std::string, std::int64_t> notes_;
  std::int64_t failures_ = 0;
};

void run(const Scene& scene, Record& record) {
  const pairs::Contact contact(scene.problem, scene.pair, {{RC_OPT_TOL, text(scene.tol)}});
  Verification verification(scene);
  pairs::Problem problem = scene.problem;
  Field last;
  bool known = false;  // the contact has this step's surface already: a step that is refused leaves the one before
  for (const Step& step : scene.steps) {
    if (!step.gap.empty()) {
      problem.gap = step.gap;
      problem.mask = step.mask;
      known = false;
    }
    problem.control = step.control;
    problem.target = step.target;
    rc_step asked = problem.step();
    if (known) asked.undeformed_gap.data = nullptr, asked.mask.data = nullptr;
    asked.warm_start = step.warm;
    const std::optional<Field> start = start_pressures(step.start, problem, last);
    if (start) asked.p0.data = start->data();
    const pairs::Answer answer = contact.solve(asked);
    check(answer.status == step.expected, step.name + ": " + residuals(answer) + "; " + answer.message);
    if (answer.status < 0) continue;
    known = true;
    record.add(scene, step, answer);
    try {
      verification.check(problem, answer);
    } catch (const pairs::Failure& failure) {
      throw pairs::Failure(step.name + ": " + residuals(answer) + ", but " + failure.what());
    }
    last = answer.p;
  }
}

void all_end_certified(const Slice& slice) {
  Record record(slice.above);
  std::atomic<std::uint64_t> next = slice.first;
  const auto work = [&] {
    for (std::uint64_t number; (number = next++) < slice.end;) {
      Scene scene = random_scene(slice.seed, number);
      if (slice.pair) scene.pair = *slice.pair;
      try {
        run(scene, record);
      } catch (const std::exception& failure) {
        record.add_failure(line(scene, failure.what()));
      }
    }
  };
  std::vector<std::thread> jobs;
  for (int i = 1; i < slice.jobs; ++i) jobs.emplace_back(work);
  work();
  for (std::thread& job : jobs) job.join();
  record.print();
  pairs::check_equal(record.failures(), 0, "scenes that failed of " + std::to_string(slice.end - slice.first));
}

bool parse(std::string_view from, std::optional<pairs::Pair>& to) {
  const std::size_t star = from.find('*');
  if (star == std::string_view::npos) return false;
  to = pairs::Pair{std::string(from.substr(0, star)), std::string(from.substr(star + 1))};
  return true;
}

template <class Number> bool parse(std::string_view from, Number& to) {
  const auto [end, error] = std::from_chars(from.data(), from.data() + from.size(), to);
  return error == std::errc() && end == from.data() + from.size();
}

bool parse(int argc, char** argv, Slice& slice) {
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string_view key = argv[i], value = argv[i + 1];
    const std::size_t colon = std::min(value.find(':'), value.size() - 1);
    const bool good = key == "--scenes"  ? parse(value.substr(0, colon), slice.first) && parse(value.substr(colon + 1), slice.end)
                      : key == "--jobs"  ? parse(value, slice.jobs)
                      : key == "--seed"  ? parse(value, slice.seed)
                      : key == "--above" ? parse(value, slice.above)
                      : key == "--pair"  ? parse(value, slice.pair)
                                         : false;
    if (!good) return false;
  }
  return argc % 2 == 1;
}

}  // namespace

}  // namespace scenes

int main(int argc, char** argv) {
  scenes::Slice slice;
  if (pairs::quick()) slice.end = 300;
  if (!scenes::parse(argc, argv, slice)) {
    std::fprintf(stderr, "usage: %s [--scenes A:B] [--jobs J] [--seed S] [--above N] [--pair SOLVER*BACKEND]\n", argv[0]);
    return 2;
  }
  return pairs::run_group("scenes_random", {{"all_end_certified", [&] { scenes::all_end_certified(slice); }}}, 1, argv);
}
