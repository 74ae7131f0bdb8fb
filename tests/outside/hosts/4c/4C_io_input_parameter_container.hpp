#pragma once

#include <any>
#include <map>

#include "4C_config.hpp"

FOUR_C_NAMESPACE_OPEN
namespace Core::IO {
struct InputParameterContainer {
  std::map<std::string, std::any> values;
  template <class T> const T& get(const std::string& name) const { return std::any_cast<const T&>(values.at(name)); }
};
}  // namespace Core::IO
FOUR_C_NAMESPACE_CLOSE
