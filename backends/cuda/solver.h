// haar-cg on the device: the gap goes in, the pressures come out, and everything between the two stays there.
#pragma once

#include <roughcontact/plugin.h>

namespace rc_cuda {

rc_status solve(const rc_host* host, const rc_problem* problem, const rc_options* options, double* p, double* d);
rc_status score(const rc_facts* facts, rc_estimate* estimate);

}  // namespace rc_cuda
