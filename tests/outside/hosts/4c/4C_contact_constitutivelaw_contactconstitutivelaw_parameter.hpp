#pragma once

#include "4C_io_input_parameter_container.hpp"

FOUR_C_NAMESPACE_OPEN
namespace CONTACT::CONSTITUTIVELAW {
class Parameter {
 public:
  Parameter() = delete;
  Parameter(const Core::IO::InputParameterContainer& data) : offset_(data.get<double>("Offset")) {}
  virtual ~Parameter() = default;
  double get_offset() const { return offset_; }
  const double offset_;
};
}  // namespace CONTACT::CONSTITUTIVELAW
FOUR_C_NAMESPACE_CLOSE
