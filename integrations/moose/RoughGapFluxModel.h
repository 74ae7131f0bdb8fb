// Heat across a rough interface in MOOSE: conductance by a contact law of roughcontact, at the contact pressure.
#pragma once

#include "GapFluxModelBase.h"

struct rc_law;

class RoughGapFluxModel : public GapFluxModelBase {
 public:
  static InputParameters validParams();

  RoughGapFluxModel(const InputParameters& parameters);

  ADReal computeFlux() const override;

 private:
  const ADVariableValue& _primary_T;
  const ADVariableValue& _secondary_T;
  const ADVariableValue& _contact_pressure;
  const ADMaterialProperty<Real>& _primary_conductivity;
  const ADMaterialProperty<Real>& _secondary_conductivity;
  const Real _length, _pressure;  // one unit of the law in units of the model
  const rc_law* _law;
};
