// Version, messages, initial values.
#include "contact/bounds.h"
#include "core/error.h"

namespace {

template <class Number> void give(Number* to, Number value) {
  if (to) *to = value;
}

}  // namespace

extern "C" {

void rc_version(int32_t* major, int32_t* minor, int32_t* patch, int32_t* abi) {
  give<int32_t>(major, RC_VERSION_MAJOR);
  give<int32_t>(minor, RC_VERSION_MINOR);
  give<int32_t>(patch, RC_VERSION_PATCH);
  give<int32_t>(abi, RC_ABI);
}

const char* rc_last_error(void) { return rc::last_message(); }

void rc_system_init(rc_system* system) { give<rc_system>(system, RC_SYSTEM_INIT); }
void rc_step_init(rc_step* step) { give<rc_step>(step, RC_STEP_INIT); }
void rc_context_config_init(rc_context_config* config) { give<rc_context_config>(config, RC_CONTEXT_CONFIG_INIT); }

void rc_path_init(rc_path* path) { give<rc_path>(path, RC_PATH_INIT); }

void rc_batch_init(rc_batch* batch) { give<rc_batch>(batch, RC_BATCH_INIT); }

void rc_level_init(rc_level* level) {
  rc_level empty{};
  empty.struct_size = sizeof(rc_level);
  give(level, empty);
}

void rc_direct_init(rc_direct* result) {
  rc_direct empty{};
  empty.struct_size = sizeof(rc_direct);
  give(result, empty);
}

void rc_area_init(rc_area* area) {
  rc_area empty{};
  empty.struct_size = sizeof(rc_area);
  give(area, empty);
}

void rc_patches_init(rc_patches* patches) { give<rc_patches>(patches, RC_PATCHES_INIT); }
void rc_histogram_init(rc_histogram* histogram) { give<rc_histogram>(histogram, RC_HISTOGRAM_INIT); }

void rc_result_init(rc_result* result) {
  rc_result empty{};
  empty.struct_size = sizeof(rc_result);
  rc::Bounds().write(empty);
  give(result, empty);
}

}  // extern "C"
