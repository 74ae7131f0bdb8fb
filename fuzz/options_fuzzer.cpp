// Options as text, "key=value" a line. Each is set by every setter, read back, and given to a contact. A refused value changes
// nothing, and an accepted value reads the same when it is set again.
#include <roughcontact/roughcontact.h>

#include <cmath>
#include <cstring>
#include <string>

#include "bytes.h"
#include "require.h"

namespace {

std::string shown(const rc_options* options, const char* key) {
  double number = 0;
  const char* text = nullptr;
  if (rc_options_get_number(options, key, &number) == RC_OK) {
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.17g", number);
    return digits;
  }
  return rc_options_get_text(options, key, &text) == RC_OK ? text : "";
}

void set(rc_options* options, const char* key, const char* value) {
  const std::string before = shown(options, key);
  const rc_status status = rc_options_set_text(options, key, value);
  fuzz::require(status == RC_OK || status == RC_ERR_OPTION || status == RC_ERR_NO_BACKEND || status == RC_ERR_NO_SOLVER ||
                    status == RC_ERR_ARGUMENT,
                "an option is taken or refused");
  fuzz::require((status == RC_OK) == (rc_last_error()[0] == '\0'), "what is refused is explained");
  const std::string after = shown(options, key);
  if (status != RC_OK) fuzz::require(after == before, "a refused value changes nothing");
  if (status == RC_OK && rc_options_set_text(options, key, after.c_str()) == RC_OK)
    fuzz::require(shown(options, key) == after, "a value reads the same when it is set again");

  char* end = nullptr;
  const double real = std::strtod(value, &end);
  rc_options_set_text(options, key, value);
  if (end != value) {
    rc_options_set_number(options, key, real);
    rc_options_set_number(options, key, std::trunc(real));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rc_options* options = nullptr;
  if (rc_options_create(nullptr, &options) != RC_OK) return 0;
  fuzz::Bytes bytes(data, size);
  while (!bytes.empty()) {
    const std::string line{bytes.until('\n')};
    const auto equals = line.find('=');
    // C strings: they end at the first zero byte.
    if (equals != std::string::npos) set(options, line.substr(0, equals).c_str(), line.substr(equals + 1).c_str());
  }
  double threads = 0;
  if (rc_options_get_number(options, RC_OPT_THREADS, &threads) == RC_OK && threads <= 3) {
    const double gap[] = {0, 0.5, 0.25, 1};
    double p[4] = {7, 7, 7, 7};
    rc_system system = RC_SYSTEM_INIT;
    system.boundary = RC_BOUNDARY_FREE;
    system.nx = system.ny = 2;
    system.hx = system.hy = system.modulus = 1;
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_APPROACH;
    step.undeformed_gap.data = gap;
    step.target = 0.6;
    rc_result result = RC_RESULT_INIT;
    result.p.data = p;
    const rc_status status = rc_solve(&system, &step, options, &result);
    fuzz::require(status >= 0 || p[0] == 7, "a failed call writes no pressure");
    fuzz::require(status != RC_ERR_INTERNAL, "no defect");
  }
  rc_options_destroy(options);
  return 0;
}
