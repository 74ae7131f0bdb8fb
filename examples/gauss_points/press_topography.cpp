// press_topography FILE LENGTH MODULUS DISPLACEMENT [KERNEL]: presses a height map as MIRCO's input has it (values separated by
// semicolons, a square of side LENGTH) and prints what it prints, the mean pressure, with the tangent and the contact area beside
// it. KERNEL: love (default), or eq9, the influence coefficients of Bemporad & Paggi (2015) as printed.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "contact_law.h"
#include "topography.h"

namespace {

double positive(const char* name, const char* text) {
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  if (*end != '\0' || !(value > 0)) throw std::runtime_error(std::string(name) + ": \"" + text + "\" is not a positive number");
  return value;
}

void print(const char* name, ContactLaw& law, double displacement) {
  const ContactLaw::Answer answer = law.evaluate(displacement);
  std::printf("%-22s mean pressure %.9e, d(mean pressure)/d(displacement) %.9e, contact area %.4f %%\n", name,
              answer.force / law.area(), answer.tangent / law.area(), 100 * answer.contact_area / law.area());
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 5 || count > 6) {
    std::fprintf(stderr, "usage: %s FILE LENGTH MODULUS DISPLACEMENT [KERNEL]\n", arguments[0]);
    return 2;
  }
  try {
    const Topography map = read_topography(arguments[1]);
    const double length = positive("LENGTH", arguments[2]);
    rc_system system = RC_SYSTEM_INIT;
    system.boundary = RC_BOUNDARY_FREE;
    system.nx = system.ny = map.side;
    system.hx = system.hy = length / static_cast<double>(map.side);
    system.modulus = positive("MODULUS", arguments[3]);
    const double displacement = positive("DISPLACEMENT", arguments[4]);
    ContactLaw law(system, map.heights, {{RC_OPT_KERNEL, count > 5 ? arguments[5] : "love"}});
    std::printf("%lld by %lld points, pitch %g\n", static_cast<long long>(map.side), static_cast<long long>(map.side), system.hx);
    print("patch on a half-space:", law, displacement);
    law.subtract_bulk(ContactLaw::square_stiffness(system.modulus, length));
    print("without its bulk:", law, displacement);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 1;
  }
  return 0;
}
