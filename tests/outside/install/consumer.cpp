// The sphere of examples/press_sphere.c from C++, with ownership by unique_ptr.
#include <roughcontact/roughcontact.h>

#include <cstdio>
#include <memory>
#include <vector>

int main(int argc, char** argv) {
  constexpr int n = 64;
  constexpr double h = 4e-6, radius = 10e-3;
  std::vector<double> gap(n * n), pressure(n * n);
  for (int i = 0; i < n * n; ++i) {
    const double x = (i % n - (n - 1) / 2.0) * h, y = (i / n - (n - 1) / 2.0) * h;
    gap[i] = (x * x + y * y) / (2 * radius);
  }

  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = n;
  system.hx = system.hy = h;
  system.modulus = 230e9;
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_APPROACH;
  step.target = 1e-6;
  step.undeformed_gap.data = gap.data();
  rc_result result = RC_RESULT_INIT;
  result.p.data = pressure.data();

  rc_options* raw_options = nullptr;
  rc_contact* raw_contact = nullptr;
  rc_status status = rc_options_create(nullptr, &raw_options);
  const std::unique_ptr<rc_options, decltype(&rc_options_destroy)> options(raw_options, rc_options_destroy);
  if (status == RC_OK) status = rc_options_set_text(options.get(), RC_OPT_BACKEND, argc > 1 ? argv[1] : "auto");
  if (status == RC_OK) status = rc_contact_create(&system, options.get(), &raw_contact);
  const std::unique_ptr<rc_contact, decltype(&rc_contact_destroy)> contact(raw_contact, rc_contact_destroy);
  if (status == RC_OK) status = rc_contact_solve(contact.get(), &step, &result);
  if (status != RC_OK) {
    std::fprintf(stderr, "%s: %s\n", rc_status_name(status), rc_last_error());
    return 1;
  }
  std::printf("%s on %s: load %.6f N, %s\n", result.solver, result.backend, result.load, rc_status_name(status));
}
