#include "RoughGapFluxModel.h"

#include <roughcontact/law.h>

registerMooseObject("RoughContactApp", RoughGapFluxModel); // the name of your application

InputParameters
RoughGapFluxModel::validParams()
{
  InputParameters params = GapFluxModelBase::validParams();
  params.addClassDescription("Heat across a rough interface, by a contact law of roughcontact");
  params.addRequiredCoupledVar("temperature", "The name of the temperature variable");
  params.addRequiredCoupledVar("contact_pressure", "The name of the contact pressure variable");
  params.addRequiredParam<FileName>("law", "The file of the contact law");
  params.addRequiredParam<MaterialPropertyName>("primary_conductivity", "Conductivity of the primary side");
  params.addRequiredParam<MaterialPropertyName>("secondary_conductivity", "Conductivity of the secondary side");
  params.addParam<Real>("length", 1, "One unit of length of the law in units of the model");
  params.addParam<Real>("force", 1, "One unit of force of the law in units of the model");
  return params;
}

RoughGapFluxModel::RoughGapFluxModel(const InputParameters & parameters)
  : GapFluxModelBase(parameters),
    _primary_T(adCoupledNeighborValue("temperature")),
    _secondary_T(adCoupledValue("temperature")),
    _contact_pressure(adCoupledLowerValue("contact_pressure")),
    _primary_conductivity(getNeighborADMaterialProperty<Real>("primary_conductivity")),
    _secondary_conductivity(getADMaterialProperty<Real>("secondary_conductivity")),
    _length(getParam<Real>("length")),
    _pressure(getParam<Real>("force") / (_length * _length)),
    _law(nullptr)
{
  // Every thread has an object of its own; they share the law, which lives until the process ends.
  const std::string file = getParam<FileName>("law");
  if (rc_law_open(file.c_str(), file.c_str(), &_law) < 0)
    paramError("law", rc_last_error());
}

ADReal
RoughGapFluxModel::computeFlux() const
{
  const Real p = MetaPhysicL::raw_value(_contact_pressure[_qp]);
  if (p <= 0)
    return 0.0;
  // With resistivities that add up to 1. The derivative by the pressure is one of differences.
  Real here, beyond;
  const Real step = 1e-6 * p;
  if (rc_law_gap_conductance(_law, p / _pressure, 1, 0, &here) < 0 ||
      rc_law_gap_conductance(_law, (p + step) / _pressure, 1, 0, &beyond) < 0)
    mooseError(rc_last_error());
  const ADReal conductance = here + (beyond - here) / step * (_contact_pressure[_qp] - p);
  const ADReal resistivity = 1 / _primary_conductivity[_qp] + 1 / _secondary_conductivity[_qp];
  return conductance / (_length * resistivity) * (_primary_T[_qp] - _secondary_T[_qp]);
}
