#include "law/named.h"

#include <map>
#include <mutex>
#include <string>

namespace rc {

namespace {

struct NamedLaws {
  std::mutex mutex;
  std::map<std::string, const rc_law*, std::less<>> laws;
};

// Never destroyed: threads may evaluate laws while the process ends.
NamedLaws& named_laws() {
  static NamedLaws* const laws = new NamedLaws;
  return *laws;
}

}  // namespace

const rc_law* named_law(const char* name, const std::function<rc_law*()>& make) {
  NamedLaws& list = named_laws();
  const std::lock_guard lock(list.mutex);
  if (const auto found = list.laws.find(name); found != list.laws.end()) return found->second;
  const auto place = list.laws.emplace(name, nullptr).first;
  try {
    place->second = make();
  } catch (...) {
    list.laws.erase(place);
    throw;
  }
  return place->second;
}

}  // namespace rc
