// Arguments that ranks must give the same, on ranks that are threads of this process.
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "contact/calls/agreement.h"
#include "support/cmocka.hpp"

namespace {

// Between so many threads: what each gives lies where all can read it.
class Meeting {
 public:
  explicit Meeting(std::size_t count) : given(count) {}

  // Returns when all have come. Not std::barrier: where GCC 12 has no futex, as on Windows, its waiters may miss that they are
  // woken.
  void wait() {
    std::unique_lock lock(mutex_);
    const std::size_t round = round_;
    if (++here_ == given.size()) {
      here_ = 0;
      ++round_;
      all_here_.notify_all();
    }
    all_here_.wait(lock, [&] { return round_ != round; });
  }

  std::vector<const void*> given;

 private:
  std::mutex mutex_;
  std::condition_variable all_here_;
  std::size_t here_ = 0, round_ = 0;
};

struct Member {
  Meeting* meeting;
  std::size_t rank;
};

const char* gather(void* user, const void* mine, const std::int64_t* bytes, void* all) {
  const auto& [meeting, rank] = *static_cast<const Member*>(user);
  meeting->given[rank] = mine;
  meeting->wait();
  auto* to = static_cast<char*>(all);
  for (std::size_t r = 0; r < meeting->given.size(); to += bytes[r++])
    if (bytes[r] > 0) std::memcpy(to, meeting->given[r], static_cast<std::size_t>(bytes[r]));
  meeting->wait();
  return nullptr;
}

const char* shift(void* user, std::int64_t, const void* from, std::int64_t, std::int64_t source, void* into,
                  std::int64_t received) {
  const auto& [meeting, rank] = *static_cast<const Member*>(user);
  meeting->given[rank] = from;
  meeting->wait();
  if (source >= 0) std::memcpy(into, meeting->given[static_cast<std::size_t>(source)], static_cast<std::size_t>(received));
  meeting->wait();
  return nullptr;
}

// What each rank gets where these are its facts: the error's message, or "".
std::vector<std::string> said(const std::vector<std::vector<rc::Fact>>& facts) {
  Meeting meeting(facts.size());
  std::vector<std::string> result(facts.size());
  std::vector<std::thread> ranks;
  for (std::size_t rank = 0; rank < facts.size(); ++rank)
    ranks.emplace_back([&, rank] {
      Member member{&meeting, rank};
      rc_exchange exchange = RC_EXCHANGE_INIT;
      exchange.rank = static_cast<std::int64_t>(rank);
      exchange.ranks = static_cast<std::int64_t>(facts.size());
      exchange.user = &member;
      exchange.gather = gather;
      exchange.shift = shift;
      try {
        rc::check_agreement(rc::Ranks(exchange, 64), facts[rank]);
      } catch (const rc::Error& error) {
        result[rank] = error.what();
      }
    });
  for (std::thread& rank : ranks) rank.join();
  return result;
}

void ranks_of_another_version_are_refused(void**) {
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = 64;
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(nullptr, &options), RC_OK);
  const std::vector<rc::Fact> ours = rc::facts_of(system, *options);
  rc_options_destroy(options);
  for (const std::string& each : said({ours, ours, ours})) assert_string_equal(each.c_str(), "");
  std::vector<rc::Fact> theirs = ours;
  assert_string_equal(theirs[0].name.c_str(), "the library's version");
  const std::string version = theirs[0].value;
  theirs[0].value = "9.9.9, ABI 9";
  const std::string expected = "rank 2 and rank 0 disagree on the library's version: 9.9.9, ABI 9 and " + version;
  for (const std::string& each : said({ours, ours, theirs})) assert_string_equal(each.c_str(), expected.c_str());
}

void ranks_with_other_components_are_refused(void**) {
  const std::vector<rc::Fact> ours{{"a", "1"}, {"option other.key", "2"}}, fewer{{"a", "1"}};
  for (const std::string& each : said({ours, fewer}))
    assert_string_equal(each.c_str(), "rank 1 and rank 0 have different options: their components differ");
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(ranks_of_another_version_are_refused),
                              cmocka_unit_test(ranks_with_other_components_are_refused)};
  return cmocka_run_group_tests_name("unit.agreement", tests, nullptr, nullptr);
}
