// Collects the remarks of a step.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rc {

// The remarks of rc_result.note.
class Remarks {
 public:
  void add(std::string text) { all_.push_back(std::move(text)); }
  // Drops an earlier remark that has the same words before its colon.
  void replace(const std::string& text) {
    const std::string from = text.substr(0, text.find(':'));
    std::erase_if(all_, [&](const std::string& each) { return each.substr(0, each.find(':')) == from; });
    all_.push_back(text);
  }
  void add(const Remarks& others) { all_.insert(all_.end(), others.all_.begin(), others.all_.end()); }
  const std::vector<std::string>& all() const { return all_; }

 private:
  std::vector<std::string> all_;
};

}  // namespace rc
