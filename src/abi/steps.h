// Steps, histories and batches as a caller gives them, checked.
#pragma once

#include "abi/arrays.h"
#include "abi/sized_struct.h"

namespace rc {

inline rc_system read_system(const rc_system* from) {
  const rc_system system = read<rc_system>(from, "rc_system", RC_SYSTEM_INIT);
  check_host_array(system.creep_ratio, "rc_system.creep_ratio");
  check_host_array(system.creep_time, "rc_system.creep_time");
  return system;
}

inline rc_step read_step(const rc_step* from) {
  const rc_step step = read<rc_step>(from, "rc_step", RC_STEP_INIT);
  check_switch(step.warm_start, "rc_step.warm_start");
  check_switch(step.borrow, "rc_step.borrow");
  check_reserved(step.reserved, "rc_step.reserved");
  check_array(step.undeformed_gap, "rc_step.undeformed_gap", Types::floats);
  check_array(step.mask, "rc_step.mask", Types::native);
  check_array(step.p0, "rc_step.p0", Types::floats);
  return step;
}

inline rc_result read_result(const rc_result* from) {
  const rc_result result = read<rc_result>(from, "rc_result", RC_RESULT_INIT);
  check_array(result.p, "rc_result.p", Types::floats);
  check_array(result.gap, "rc_result.gap", Types::floats);
  return result;
}

inline void check_columns(const rc_columns& columns) {
  check_host_arrays<rc_array>({{"rc_columns.load", columns.load},
                               {"rc_columns.approach", columns.approach},
                               {"rc_columns.contact_area", columns.contact_area},
                               {"rc_columns.mean_gap", columns.mean_gap},
                               {"rc_columns.energy", columns.energy},
                               {"rc_columns.stiffness", columns.stiffness},
                               {"rc_columns.load_lower", columns.load_lower},
                               {"rc_columns.load_upper", columns.load_upper},
                               {"rc_columns.area_lower", columns.area_lower},
                               {"rc_columns.area_upper", columns.area_upper},
                               {"rc_columns.stiffness_lower", columns.stiffness_lower},
                               {"rc_columns.stiffness_upper", columns.stiffness_upper},
                               {"rc_columns.certificate", columns.certificate},
                               {"rc_columns.iterations", columns.iterations},
                               {"rc_columns.products", columns.products},
                               {"rc_columns.status", columns.status}});
}

inline rc_history read_history(rc_history* from) {
  const rc_history history = read<rc_history>(from, "rc_history", RC_HISTORY_INIT);
  from->completed = 0;
  check_switch(history.warm_start, "rc_history.warm_start");
  check_switch(history.virgin, "rc_history.virgin");
  check_host_array(history.targets, "rc_history.targets");
  check_host_array(history.undeformed_gap, "rc_history.undeformed_gap", Types::floats);
  check_host_array(history.mask, "rc_history.mask");
  check_host_array(history.times, "rc_history.times");
  check_columns(history.columns);
  return history;
}

inline rc_batch read_batch(rc_batch* from) {
  const rc_batch batch = read<rc_batch>(from, "rc_batch", RC_BATCH_INIT);
  from->written = from->certified = 0;
  from->first = -1;
  check_switch(batch.warm_start, "rc_batch.warm_start");
  check_switch(batch.virgin, "rc_batch.virgin");
  check_reserved(batch.reserved, "rc_batch.reserved");
  check_host_array(batch.targets, "rc_batch.targets");
  check_host_array(batch.undeformed_gap, "rc_batch.undeformed_gap", Types::floats);
  check_host_array(batch.mask, "rc_batch.mask");
  check_host_array(batch.times, "rc_batch.times");
  check_host_array(batch.p0, "rc_batch.p0", Types::floats);
  check_host_array(batch.p, "rc_batch.p", Types::floats);
  check_columns(batch.columns);
  return batch;
}

}  // namespace rc
