// rc_batch_*
#include "contact/calls/batch.h"

#include "abi/guard.h"
#include "abi/steps.h"

extern "C" rc_status rc_batch_solve(const rc_system* system, const rc_options* options, rc_batch* batch) {
  using namespace rc;
  return guard("rc_batch_solve", [&] {
    const rc_batch asked = read_batch(batch);
    const BatchOutcome outcome =
        solve_batch(read_system(system), options ? *options : rc_options{Context::standard(), {}}, asked);
    batch->written = asked.n;
    batch->certified = outcome.certified;
    batch->first = outcome.first;
    if (outcome.status < 0) fail(outcome.status, outcome.message);
    set_message(outcome.message.c_str());
    return outcome.status;
  });
}
