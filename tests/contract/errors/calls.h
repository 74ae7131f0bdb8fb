// The calls that the table's rows name.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "world.h"

namespace errors {

// The status that a call returned, with the calling thread's message at that moment.
struct Outcome {
  Outcome(rc_status given) : status(given), message(rc_last_error()) {}
  rc_status status;
  std::string message;
};

using Calls = std::map<std::string, std::function<Outcome(World&)>>;

Calls calls();             // one function of the headers, with what a row spoils
Calls contact_calls();     // orders of calls of a contact
Calls history_calls();     // what is called from within histories and batches
Calls derivative_calls();  // what comes before derivatives
Calls plugin_calls();      // plugins, and files that are none

Outcome run_history(rc_contact* contact, World& world);
Outcome run_batch(World& world);

}  // namespace errors
