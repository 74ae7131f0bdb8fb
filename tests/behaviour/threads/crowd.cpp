#include "crowd.h"

#include <array>
#include <barrier>
#include <cstdlib>
#include <thread>
#include <vector>

#include "support/cmocka.hpp"

namespace threads {

void together(const std::function<std::string(int)>& body) {
  std::array<std::string, crowd> complaints;
  std::barrier start(crowd);
  std::vector<std::thread> members;
  for (int member = 0; member < crowd; ++member)
    members.emplace_back([&, member] {
      start.arrive_and_wait();
      complaints[static_cast<std::size_t>(member)] = body(member);
    });
  for (std::thread& member : members) member.join();
  for (const std::string& complaint : complaints)
    if (!complaint.empty()) print_error("%s\n", complaint.c_str());
  for (const std::string& complaint : complaints) assert_true(complaint.empty());
}

int rounds(int full) { return std::getenv("RC_TEST_QUICK") ? (full + 3) / 4 : full; }

}  // namespace threads
