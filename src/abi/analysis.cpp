// rc_area_measure, rc_patches_find, rc_histogram_fill
#include "abi/guard.h"
#include "abi/sized_struct.h"
#include "analysis/area.h"
#include "analysis/histogram.h"
#include "analysis/patches.h"

namespace {

using namespace rc;

ContactMap map_of(const rc_system* system, const double* p, const uint8_t* mask) {
  return {read<rc_system>(system, "rc_system", RC_SYSTEM_INIT), p, mask};
}

}  // namespace

extern "C" {

rc_status rc_area_measure(const rc_system* system, const double* p, const uint8_t* mask, rc_area* out) {
  return guard("rc_area_measure", [&] {
    check_size(out, "rc_area");
    write(out, measure_area(map_of(system, p, mask)));
    return RC_OK;
  });
}

rc_status rc_patches_find(const rc_system* system, const double* p, const uint8_t* mask, rc_patches* out) {
  return guard("rc_patches_find", [&] {
    const rc_patches today = read<rc_patches>(out, "rc_patches", RC_PATCHES_INIT);
    out->count = find_patches(map_of(system, p, mask), today);
    return RC_OK;
  });
}

rc_status rc_histogram_fill(const rc_system* system, const double* p, const uint8_t* mask, rc_histogram* out) {
  return guard("rc_histogram_fill", [&] {
    rc_histogram today = read<rc_histogram>(out, "rc_histogram", RC_HISTOGRAM_INIT);
    fill_histogram(map_of(system, p, mask), today);
    write(out, today);
    return RC_OK;
  });
}

}  // extern "C"
