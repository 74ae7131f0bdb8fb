// Version, messages, initial values.
#include <algorithm>
#include <cstring>

#include "contact/proof/bounds.h"
#include "core/error.h"

namespace {

template <class Number> void give(Number* to, Number value) {
  if (to) *to = value;
}

// Writes as much of the struct as the caller knows. What a newer caller knows beyond it becomes zero.
template <class Struct> void begin(Struct* to, std::size_t struct_size, Struct value) {
  if (!to || struct_size < sizeof value.struct_size) return;
  value.struct_size = struct_size;
  const std::size_t known = std::min(struct_size, sizeof value);
  std::memcpy(to, &value, known);
  std::memset(reinterpret_cast<unsigned char*>(to) + known, 0, struct_size - known);
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

// Parentheses, because the header has macros of the same names.
void(rc_system_init)(rc_system* system, size_t struct_size) { begin<rc_system>(system, struct_size, RC_SYSTEM_INIT); }
void(rc_step_init)(rc_step* step, size_t struct_size) { begin<rc_step>(step, struct_size, RC_STEP_INIT); }
void(rc_result_init)(rc_result* result, size_t struct_size) {
  rc_result empty{};
  rc::Bounds().write(empty);
  begin<rc_result>(result, struct_size, empty);
}
void(rc_context_config_init)(rc_context_config* config, size_t struct_size) {
  begin<rc_context_config>(config, struct_size, RC_CONTEXT_CONFIG_INIT);
}
void(rc_path_init)(rc_path* path, size_t struct_size) { begin<rc_path>(path, struct_size, RC_PATH_INIT); }
void(rc_batch_init)(rc_batch* batch, size_t struct_size) { begin<rc_batch>(batch, struct_size, RC_BATCH_INIT); }
void(rc_state_init)(rc_state* state, size_t struct_size) { begin<rc_state>(state, struct_size, RC_STATE_INIT); }
void(rc_level_init)(rc_level* level, size_t struct_size) { begin<rc_level>(level, struct_size, {}); }
void(rc_direct_init)(rc_direct* result, size_t struct_size) { begin<rc_direct>(result, struct_size, {}); }
void(rc_area_init)(rc_area* area, size_t struct_size) { begin<rc_area>(area, struct_size, {}); }
void(rc_patches_init)(rc_patches* patches, size_t struct_size) { begin<rc_patches>(patches, struct_size, RC_PATCHES_INIT); }
void(rc_histogram_init)(rc_histogram* histogram, size_t struct_size) {
  begin<rc_histogram>(histogram, struct_size, RC_HISTOGRAM_INIT);
}

}  // extern "C"
