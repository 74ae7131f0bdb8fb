// rc_area_measure, rc_patches_find, rc_histogram_fill, rc_crossing_find, rc_conductance, rc_punch_stiffness
#include <cmath>
#include <limits>

#include "abi/arrays.h"
#include "abi/guard.h"
#include "abi/sized_struct.h"
#include "abi/steps.h"
#include "analysis/area.h"
#include "analysis/conductance.h"
#include "analysis/crossing.h"
#include "analysis/histogram.h"
#include "analysis/patches.h"
#include "contact/calls/set_stiffness.h"

namespace {

using namespace rc;

ContactMap map_of(const rc_system* system, const rc_const_array& p, const rc_const_array& mask) {
  return {read_system(system), host_values<double>(p, "p"), host_values<std::uint8_t>(mask, "mask")};
}

}  // namespace

extern "C" {

rc_status rc_area_measure(const rc_system* system, rc_const_array p, rc_const_array mask, rc_area* out) {
  return guard("rc_area_measure", [&] {
    check_size(out, "rc_area");
    write(out, measure_area(map_of(system, p, mask)));
    return RC_OK;
  });
}

rc_status rc_patches_find(const rc_system* system, rc_const_array p, rc_const_array mask, rc_patches* out) {
  return guard("rc_patches_find", [&] {
    const rc_patches asked = read<rc_patches>(out, "rc_patches", RC_PATCHES_INIT);
    check_reserved(asked.reserved, "rc_patches.reserved");
    check_host_arrays<rc_array>({{"rc_patches.label", asked.label},
                                 {"rc_patches.cells", asked.cells},
                                 {"rc_patches.area", asked.area},
                                 {"rc_patches.perimeter", asked.perimeter},
                                 {"rc_patches.load", asked.load},
                                 {"rc_patches.mean_pressure", asked.mean_pressure},
                                 {"rc_patches.max_pressure", asked.max_pressure},
                                 {"rc_patches.peak", asked.peak}});
    out->count = find_patches(map_of(system, p, mask), asked);
    return RC_OK;
  });
}

rc_status rc_histogram_fill(const rc_system* system, rc_const_array p, rc_const_array mask, rc_histogram* out) {
  return guard("rc_histogram_fill", [&] {
    rc_histogram asked = read<rc_histogram>(out, "rc_histogram", RC_HISTOGRAM_INIT);
    check_host_arrays<rc_array>({{"rc_histogram.counts", asked.counts}, {"rc_histogram.density", asked.density}});
    fill_histogram(map_of(system, p, mask), asked);
    write(out, asked);
    return RC_OK;
  });
}

rc_status rc_crossing_find(const rc_system* system, rc_const_array p, rc_const_array mask, int32_t* contact, int32_t* gap) {
  return guard("rc_crossing_find", [&] {
    if (!contact || !gap) fail(RC_ERR_ARGUMENT, contact ? "gap" : "contact", " is null");
    const ContactMap map = map_of(system, p, mask);
    const std::int32_t of_contact = crossed_axes(map, true), of_gap = crossed_axes(map, false);
    *contact = of_contact;
    *gap = of_gap;
    return RC_OK;
  });
}

rc_status rc_conductance(const rc_system* system, const rc_result* result, double rho1, double rho2, double* conductance,
                         double* lower, double* upper) {
  return guard("rc_conductance", [&] {
    if (!conductance) fail(RC_ERR_ARGUMENT, "conductance is null");
    const rc_system given = read_system(system);
    rc_result answer = RC_RESULT_INIT;  // an older caller's has no interval
    answer.stiffness_lower = answer.stiffness_upper = std::numeric_limits<double>::quiet_NaN();
    answer = read<rc_result>(result, "rc_result", answer);
    const double unit = conductance_per_stiffness(given, answer, rho1, rho2);
    if (std::isnan(answer.stiffness)) fail(RC_ERR_ARGUMENT, "rc_result.stiffness is NaN; solve with option stiffness = 1 or 2");
    *conductance = answer.stiffness * unit;
    if (lower) *lower = answer.stiffness_lower * unit;
    if (upper) *upper = answer.stiffness_upper * unit;
    return RC_OK;
  });
}

rc_status rc_punch_stiffness(const rc_system* system, rc_const_array mask, const rc_options* options, double* stiffness,
                             double* lower, double* upper) {
  return guard("rc_punch_stiffness", [&] {
    if (!stiffness) fail(RC_ERR_ARGUMENT, "stiffness is null");
    StiffnessInterval found;
    const rc_status status = set_stiffness(read_system(system), host_values<std::uint8_t>(mask, "mask"),
                                           options ? *options : rc_options{Context::standard(), {}}, found);
    if (std::isnan(found.value)) return status;
    *stiffness = found.value;
    if (lower) *lower = found.lower;
    if (upper) *upper = found.upper;
    return status;
  });
}

}  // extern "C"
