// Memory of this process and of the machine, in bytes.
#pragma once

namespace bench {

// Resident memory of this process now.
double resident_memory();
// What a new process could still take without driving others out.
double available_memory();
// No allocation of this process succeeds beyond so many more bytes: it fails instead of others being killed.
void limit_growth(double bytes);

}  // namespace bench
