// The pressure of a rough interface in 4C by a contact law of roughcontact: without Python, as one of 4C's own laws.
#ifndef FOUR_C_CONTACT_CONSTITUTIVELAW_ROUGHCONTACT_HPP
#define FOUR_C_CONTACT_CONSTITUTIVELAW_ROUGHCONTACT_HPP

#include <filesystem>

#include "4C_config.hpp"
#include "4C_contact_constitutivelaw_contactconstitutivelaw.hpp"
#include "4C_contact_constitutivelaw_contactconstitutivelaw_parameter.hpp"

struct rc_law;

FOUR_C_NAMESPACE_OPEN

namespace CONTACT::CONSTITUTIVELAW {
class RoughcontactConstitutiveLawParams : public Parameter {
 public:
  RoughcontactConstitutiveLawParams(const Core::IO::InputParameterContainer& container);
  const rc_law* law() const { return law_; }

 private:
  const rc_law* law_;  // lives until the process ends
};

class RoughcontactConstitutiveLaw : public ConstitutiveLaw {
 public:
  explicit RoughcontactConstitutiveLaw(RoughcontactConstitutiveLawParams params);
  const Parameter* parameter() const override { return &params_; }

  // minus the nominal pressure at the overclosure -(gap + offset), and its derivative by the gap
  double evaluate(double gap, CONTACT::Node* cnode) override;
  double evaluate_derivative(double gap, CONTACT::Node* cnode) override;

 private:
  RoughcontactConstitutiveLawParams params_;
};
}  // namespace CONTACT::CONSTITUTIVELAW

FOUR_C_NAMESPACE_CLOSE

#endif
