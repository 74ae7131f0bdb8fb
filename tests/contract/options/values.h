// The values that are tried for an option, from the registry's schema.
#pragma once

#include <roughcontact/roughcontact.h>

#include <string>
#include <vector>

namespace options {

struct Option {
  std::string key, default_value, choices;
  std::int32_t type = 0;
  double minimum = 0, maximum = 0;

  // "fft" of "fft.precision"; "" for the core's.
  std::string owner() const { return key.substr(0, key.find('.') == std::string::npos ? 0 : key.find('.')); }
};

struct Names {
  std::vector<std::string> backends, solvers, kernels;
};

rc_context* make_context();
std::vector<Option> all_options(rc_context* context);
Names all_names(rc_context* context);

// Inside: within the range or any text, which may still be refused with a reason. Outside: must be refused.
struct Values {
  std::vector<std::string> inside, outside;
};
Values values_of(const Option& option, const Names& names);

inline constexpr const char* kinds[] = {"free", "periodic", "matrix", "product"};

// A user's calls on a small system of this kind: solves and certifies in both controls. Returns "" if every call gave an answer
// or a documented error, else says what is wrong. memory: whether RC_ERR_MEMORY counts as an answer.
std::string judge(const std::string& kind, const rc_options* options, bool memory);

}  // namespace options
