#include "4C_contact_constitutivelaw_roughcontact.hpp"

#include <roughcontact/law.h>

#include <utility>

#include "4C_io_input_parameter_container.hpp"

FOUR_C_NAMESPACE_OPEN

namespace {
struct Answer {
  double pressure = 0, slope = 0;
};

Answer at(const CONTACT::CONSTITUTIVELAW::RoughcontactConstitutiveLawParams& params, double gap) {
  Answer answer;
  if (rc_law_pressure(params.law(), -(gap + params.get_offset()), &answer.pressure, &answer.slope, nullptr) < 0)
    FOUR_C_THROW("{}", rc_last_error());
  return answer;
}
}  // namespace

CONTACT::CONSTITUTIVELAW::RoughcontactConstitutiveLawParams::RoughcontactConstitutiveLawParams(
    const Core::IO::InputParameterContainer& container)
    : Parameter(container), law_(nullptr) {
  const std::string file = container.get<std::filesystem::path>("Law_Filename").string();
  if (rc_law_open(file.c_str(), file.c_str(), &law_) < 0) FOUR_C_THROW("{}", rc_last_error());
}

CONTACT::CONSTITUTIVELAW::RoughcontactConstitutiveLaw::RoughcontactConstitutiveLaw(RoughcontactConstitutiveLawParams params)
    : params_(std::move(params)) {}

double CONTACT::CONSTITUTIVELAW::RoughcontactConstitutiveLaw::evaluate(double gap, CONTACT::Node*) {
  return 0.0 - at(params_, gap).pressure;
}

double CONTACT::CONSTITUTIVELAW::RoughcontactConstitutiveLaw::evaluate_derivative(double gap, CONTACT::Node*) {
  return at(params_, gap).slope;
}

FOUR_C_NAMESPACE_CLOSE
