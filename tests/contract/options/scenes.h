// A small system of each kind, and a user's calls on it.
#pragma once

#include <roughcontact/roughcontact.h>

#include <string>
#include <vector>

#include "support/unit_system.h"

namespace options {

inline constexpr const char* kinds[] = {"free", "periodic", "matrix", "product"};

class Scene {
 public:
  explicit Scene(const std::string& kind);
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  // Solves and certifies in both controls. "": every call gave an answer or a documented error; otherwise what is wrong.
  // memory: running out of memory is an answer, too.
  std::string judge(const rc_options* options, bool memory);

 private:
  std::string wrong(rc_status status, const rc_result& result, bool memory) const;

  rc_system system_ = support::unit_system();
  std::vector<double> gap_, matrix_, p_, deformed_;
};

}  // namespace options
