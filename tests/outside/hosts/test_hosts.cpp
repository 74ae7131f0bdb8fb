// The classes for MOOSE and 4C, on stand-ins of the classes that they derive from, against the law.
#include <roughcontact/law.h>

#include <cmath>
#include <filesystem>

#include "4C_contact_constitutivelaw_roughcontact.hpp"
#include "RoughGapFluxModel.h"
#include "support/contact.h"

namespace {

using pairs::check;
using pairs::check_equal;
using pairs::text;

const std::string file = "hosts.law", none = "none.law";

const rc_law* law() {
  static const rc_law* const made = [] {
    constexpr std::int64_t n = 16;
    static double gap[n * n];
    for (int i = 0; i < n * n; ++i) gap[i] = 2 - std::cos(0.9 * (i % n)) * std::cos(0.5 * (i / n)) - std::cos(0.2 * (i % n));
    rc_system system = RC_SYSTEM_INIT;
    system.boundary = RC_BOUNDARY_PERIODIC;
    system.nx = system.ny = n;
    system.hx = system.hy = system.modulus = 1;
    rc_law_spec spec = RC_LAW_SPEC_INIT;
    spec.undeformed_gap = RC_IN(gap);
    spec.p_lower = 1e-3, spec.p_upper = 2e-2;
    rc_law* found = nullptr;
    check(rc_law_create(&system, nullptr, &spec, &found) >= 0, rc_last_error());
    check_equal(rc_law_save(found, file.c_str()), RC_OK, rc_last_error());
    return found;
  }();
  return made;
}

template <class Call> std::string thrown(const Call& call) {
  try {
    call();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

InputParameters moose_input(double p) {
  InputParameters input = RoughGapFluxModel::validParams();
  input.given["law"] = FileName(file.c_str());
  input.values = {{"neighbour temperature", {400.0}},
                  {"temperature", {300.0}},
                  {"contact_pressure", {{p, 1}}},
                  {"primary_conductivity", {50.0}},
                  {"secondary_conductivity", {20.0}}};
  return input;
}

void moose_has_the_conductance_of_the_law() {
  law();
  check_equal(RoughGapFluxModel(moose_input(0)).computeFlux().value == 0, true, "open");
  for (const double p : {1e-3, 4e-3, 1.9e-2}) {
    for (const double length : {1.0, 1e3}) {
      InputParameters input = moose_input(p / length / length);
      input.given["length"] = length;
      const ADReal flux = RoughGapFluxModel(input).computeFlux();
      double known = 0, more = 0;
      rc_law_gap_conductance(law(), p, 1 / 50.0, 1 / 20.0, &known);
      rc_law_gap_conductance(law(), p * (1 + 1e-6), 1 / 50.0, 1 / 20.0, &more);
      check(std::abs(flux.value / (100 * known / length) - 1) < 1e-12, "flux at " + text(p));
      const double rate = 100 * (more - known) / (1e-6 * p) * length;
      check(std::abs(flux.derivative - rate) <= 1e-5 * std::abs(rate) + 1e-8 * flux.value / p * length * length,
            "its derivative at " + text(p));
    }
  }
  InputParameters input = moose_input(1e-2);
  input.given["law"] = FileName(none.c_str());
  check(thrown([&] { RoughGapFluxModel{input}; }).find("law: rc_law_open: none.law: cannot be read") == 0, "no file");
}

void four_c_has_the_pressure_of_the_law() {
  using namespace FourC;
  law();
  const Core::IO::InputParameterContainer input{{{"Offset", 0.1}, {"Law_Filename", std::filesystem::path(file)}}};
  CONTACT::CONSTITUTIVELAW::RoughcontactConstitutiveLaw rough{CONTACT::CONSTITUTIVELAW::RoughcontactConstitutiveLawParams(input)};
  for (const double gap : {1.0, 0.0, -0.2, -0.35}) {
    double p = 0, slope = 0;
    rc_law_pressure(law(), -(gap + 0.1), &p, &slope, nullptr);
    check(rough.evaluate(gap, nullptr) == -p && rough.evaluate_derivative(gap, nullptr) == slope, "at " + text(gap));
  }
  check(rough.parameter()->get_offset() == 0.1, "offset");
  const Core::IO::InputParameterContainer wrong{{{"Offset", 0.1}, {"Law_Filename", std::filesystem::path(none)}}};
  check(thrown([&] { CONTACT::CONSTITUTIVELAW::RoughcontactConstitutiveLawParams{wrong}; }).find("cannot be read") !=
            std::string::npos,
        "no file");
  check(thrown([&] { rough.evaluate(std::nan(""), nullptr); }).find("NaN") != std::string::npos, "NaN");
}

}  // namespace

int main(int argc, char** argv) {
  return pairs::run_group("hosts",
                          {{"MOOSE has the conductance of the law", moose_has_the_conductance_of_the_law},
                           {"4C has the pressure of the law", four_c_has_the_pressure_of_the_law}},
                          argc, argv);
}
