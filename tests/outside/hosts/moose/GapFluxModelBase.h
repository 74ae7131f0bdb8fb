// Stand-ins of what the model in integrations/moose uses of MOOSE, by the same names. ADReal has one derivative.
#pragma once

#include <any>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

using Real = double;
struct ADReal {
  Real value, derivative;
  ADReal(Real v = 0, Real d = 0) : value(v), derivative(d) {}
};
inline ADReal operator+(ADReal a, ADReal b) { return {a.value + b.value, a.derivative + b.derivative}; }
inline ADReal operator-(ADReal a, ADReal b) { return {a.value - b.value, a.derivative - b.derivative}; }
inline ADReal operator*(ADReal a, ADReal b) { return {a.value * b.value, a.value * b.derivative + a.derivative * b.value}; }
inline ADReal operator/(ADReal a, ADReal b) {
  return {a.value / b.value, (a.derivative - a.value / b.value * b.derivative) / b.value};
}
namespace MetaPhysicL {
inline Real raw_value(const ADReal& a) { return a.value; }
}  // namespace MetaPhysicL

using ADVariableValue = std::vector<ADReal>;
template <class T> using ADMaterialProperty = std::vector<ADReal>;
struct FileName : std::string {
  using std::string::string;
};
using MaterialPropertyName = std::string;

struct InputParameters {
  std::map<std::string, std::any> given;
  std::map<std::string, ADVariableValue> values;
  void addClassDescription(const std::string&) {}
  void addRequiredCoupledVar(const std::string&, const std::string&) {}
  template <class T> void addRequiredParam(const std::string&, const std::string&) {}
  template <class T> void addParam(const std::string& name, T value, const std::string&) { given.emplace(name, value); }
};
template <> inline void InputParameters::addParam<Real>(const std::string& name, Real value, const std::string&) {
  given.emplace(name, value);
}

class GapFluxModelBase {
 public:
  static InputParameters validParams() { return {}; }
  GapFluxModelBase(const InputParameters& parameters) : parameters_(parameters) {}
  virtual ~GapFluxModelBase() = default;
  virtual ADReal computeFlux() const = 0;

 protected:
  const ADVariableValue& adCoupledNeighborValue(const std::string& name) { return parameters_.values["neighbour " + name]; }
  const ADVariableValue& adCoupledValue(const std::string& name) { return parameters_.values[name]; }
  const ADVariableValue& adCoupledLowerValue(const std::string& name) { return parameters_.values[name]; }
  template <class T> const ADMaterialProperty<T>& getNeighborADMaterialProperty(const std::string& name) {
    return parameters_.values[name];
  }
  template <class T> const ADMaterialProperty<T>& getADMaterialProperty(const std::string& name) {
    return parameters_.values[name];
  }
  template <class T> const T& getParam(const std::string& name) const {
    return std::any_cast<const T&>(parameters_.given.at(name));
  }
  [[noreturn]] void paramError(const std::string& name, const char* text) const { throw std::runtime_error(name + ": " + text); }
  [[noreturn]] void mooseError(const char* text) const { throw std::runtime_error(text); }
  unsigned int _qp = 0;

 private:
  InputParameters parameters_;
};
#define registerMooseObject(application, object) static_assert(true, application #object)
