#pragma once

#include "4C_contact_constitutivelaw_contactconstitutivelaw_parameter.hpp"

FOUR_C_NAMESPACE_OPEN
namespace CONTACT {
class Node;
namespace CONSTITUTIVELAW {
class ConstitutiveLaw {
 public:
  virtual ~ConstitutiveLaw() = default;
  virtual const Parameter* parameter() const = 0;
  virtual double evaluate(double gap, CONTACT::Node* cnode) = 0;
  virtual double evaluate_derivative(double gap, CONTACT::Node* cnode) = 0;
};
}  // namespace CONSTITUTIVELAW
}  // namespace CONTACT
FOUR_C_NAMESPACE_CLOSE
