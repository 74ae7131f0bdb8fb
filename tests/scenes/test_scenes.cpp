// Random scenes and what must hold of each. The seed is the name of a failure.
//   test_scenes [--seeds A:B] [--property NAME] [--pair SOLVER*BACKEND] [--reduced] [--slow] [--stop]
// --pair: each scene that this pair can solve is solved by it.
// --reduced: scenes of few points, for slow builds, as RC_TEST_QUICK=1 asks for. --slow: lists scenes that take more than 0.2 s.
// --stop: ends at the first failure.
#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <map>
#include <string_view>

#include "property.h"

namespace scenes {

namespace {

struct Wanted {
  std::uint64_t first = 0, end = 2000;
  std::string property;
  bool reduced = false, slow = false, stop = false;
};

struct Tally {
  std::int64_t seeds = 0, asked = 0, held = 0, undecidable = 0, spoilt = 0, noticed = 0;
  std::map<std::string, std::int64_t> not_asked;
  std::map<std::string, std::pair<std::int64_t, std::int64_t>> by_solver;  // undecidable, asked
};

std::vector<Kind> all_kinds() {
  std::vector<Kind> all;
  for (const auto& some : {properties_of_steps(), properties_of_sequences(), properties_of_slopes(), properties_of_laws(),
                           properties_of_costs(), properties_of_creep(), properties_of_ways()})
    all.insert(all.end(), some.begin(), some.end());
#ifdef RC_SCENES_FLOW
  for (const auto& some : {properties_of_flows(), properties_of_closing()}) all.insert(all.end(), some.begin(), some.end());
#endif
  return all;
}

constexpr std::uint64_t spoilt_every = 8;

class Driver {
 public:
  explicit Driver(const Wanted& wanted) : wanted_(wanted), kinds_(all_kinds()), tallies_(kinds_.size()) {}

  void run() {
    for (std::uint64_t seed = wanted_.first; seed < wanted_.end && !(wanted_.stop && failures_ > 0); ++seed) run(seed);
  }

  /** Whether all is well. */
  bool print() {
    bool well = failures_ == 0;
    for (std::size_t k = 0; k < kinds_.size(); ++k) {
      const Tally& t = tallies_[k];
      if (t.seeds == 0) continue;
      std::string reasons;
      for (const auto& [reason, count] : t.not_asked) reasons += ", " + reason + " " + std::to_string(count);
      std::printf("%s: asked %lld, held %lld, undecidable %lld; not asked %lld%s; spoilt %lld, noticed %lld\n", kinds_[k].name,
                  as_printed(t.asked), as_printed(t.held), as_printed(t.undecidable), as_printed(t.seeds - t.asked),
                  reasons.c_str(), as_printed(t.spoilt), as_printed(t.noticed));
      if (t.seeds < 200) continue;
      // The first 200 seeds, which are small under sanitizers, need not have what is rare.
      if (t.seeds > 200 && static_cast<double>(t.asked) < kinds_[k].least_asked * static_cast<double>(t.seeds)) {
        std::printf("  asked of too few: at least %.0f in 100 are wanted\n", 100 * kinds_[k].least_asked);
        well = false;
      }
      if (static_cast<double>(t.undecidable) > kinds_[k].most_undecidable * static_cast<double>(t.asked)) {
        std::printf("  too many are undecidable: at most %.0f in 100 may be\n", 100 * kinds_[k].most_undecidable);
        well = false;
      }
      for (const auto& [solver, counts] : t.by_solver) {
        const auto [undecidable, asked] = counts;
        if (asked < 40 || kinds_[k].most_undecidable > 0.01 || undecidable * 10 <= asked) continue;
        std::printf("  too many are undecidable with %s: %lld of %lld\n", solver.c_str(), as_printed(undecidable),
                    as_printed(asked));
        well = false;
      }
      if (t.noticed * 20 < t.spoilt * 19 || (t.spoilt == 0 && t.asked >= 100)) {
        std::printf("  notices too few of the spoilt answers: 95 in 100 are wanted\n");
        well = false;
      }
    }
    for (auto& [name, values] : numbers_) {
      const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
      std::ranges::nth_element(values, middle);
      std::printf("%s: median %.3g of %zu\n", name.c_str(), *middle, values.size());
      well = well && (values.size() < 50 || *middle <= most_median);
    }
    std::printf("%llu seeds, %lld failures\n", static_cast<unsigned long long>(wanted_.end - wanted_.first),
                as_printed(failures_));
    return well;
  }

 private:
  static long long as_printed(std::int64_t value) { return value; }

  void fail(std::uint64_t seed, const char* property, const std::string& words, const std::string& what) {
    ++failures_;
    std::printf("test_scenes --seeds %llu:%llu --property %s\n  %s\n  %s\n", static_cast<unsigned long long>(seed),
                static_cast<unsigned long long>(seed + 1), property, words.c_str(), what.c_str());
    std::fflush(stdout);
  }

  void run(std::uint64_t seed) {
    const auto begun = std::chrono::steady_clock::now();
    try {
      const Case c(seed, wanted_.reduced);
      for (std::size_t k = 0; k < kinds_.size(); ++k)
        if (seed % kinds_[k].every == kinds_[k].at && (wanted_.property.empty() || wanted_.property == kinds_[k].name))
          run(c, kinds_[k], tallies_[k]);
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
      if (wanted_.slow && seconds > 0.2)
        std::printf("%.2f s: seed %llu, %s\n", seconds, static_cast<unsigned long long>(seed), c.words().c_str());
    } catch (const std::exception& failure) {
      fail(seed, "any", "", failure.what());
    }
  }

  void run(const Case& c, const Kind& kind, Tally& tally) {
    const std::uint64_t seed = c.scene().seed;
    ++tally.seeds;
    try {
      const auto property = kind.make();
      const std::string reason = property->ask(c);
      if (!reason.empty()) {
        ++tally.not_asked[reason];
        return;
      }
      ++tally.asked;
      const Verdict verdict = property->judge(c);
      ++(verdict == Verdict::held ? tally.held : tally.undecidable);
      auto& [undecidable, asked] = tally.by_solver[c.pair().solver];
      undecidable += verdict == Verdict::undecidable;
      ++asked;
      if (verdict == Verdict::held) property->measure(numbers_);
      Random random(seed, 400);
      if (verdict != Verdict::held || random.below(spoilt_every) != 0 || !property->spoil(c, random)) return;
      ++tally.spoilt;
      try {
        property->judge(c);
        if (!wanted_.property.empty())
          std::printf("not noticed: seed %llu, %s\n", static_cast<unsigned long long>(seed), c.words().c_str());
      } catch (const pairs::Failure&) {
        ++tally.noticed;
      }
    } catch (const std::exception& failure) {
      fail(seed, kind.name, c.words(), failure.what());
    }
  }

  const Wanted wanted_;
  const std::vector<Kind> kinds_;
  std::vector<Tally> tallies_;
  std::map<std::string, Field> numbers_;
  std::int64_t failures_ = 0;
};

template <class Number> bool parse(std::string_view from, Number& to) {
  const auto [end, error] = std::from_chars(from.data(), from.data() + from.size(), to);
  return error == std::errc() && end == from.data() + from.size();
}

bool parse(int argc, char** argv, Wanted& wanted) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view key = argv[i];
    if (key == "--reduced" || key == "--slow" || key == "--stop") {
      (key == "--slow" ? wanted.slow : key == "--stop" ? wanted.stop : wanted.reduced) = true;
      continue;
    }
    if (++i == argc) return false;
    const std::string_view value = argv[i];
    const std::size_t colon = std::min(value.find(':'), value.size());
    const std::size_t star = value.find('*');
    if (key == "--property")
      wanted.property = value;
    else if (key == "--pair" && star != value.npos)
      Case::only = pairs::Pair{std::string(value.substr(0, star)), std::string(value.substr(star + 1))};
    else if (key != "--seeds" || colon == value.size() || !parse(value.substr(0, colon), wanted.first) ||
             !parse(value.substr(colon + 1), wanted.end))
      return false;
  }
  return true;
}

}  // namespace

}  // namespace scenes

int main(int argc, char** argv) {
  scenes::Wanted wanted;
  if (pairs::quick()) wanted.end = 200, wanted.reduced = true;
  if (!scenes::parse(argc, argv, wanted)) {
    std::fprintf(stderr, "usage: %s [--seeds A:B] [--property NAME] [--pair SOLVER*BACKEND] [--reduced] [--slow] [--stop]\n",
                 argv[0]);
    return 2;
  }
  scenes::Driver driver(wanted);
  driver.run();
  return driver.print() ? 0 : 1;
}
