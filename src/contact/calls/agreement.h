// Arguments that must be equal on all ranks: a difference is reported as "rank 2 and rank 0 disagree on nx: 64 and 128".
#pragma once

#include <roughcontact/ranks.h>

#include <string>
#include <vector>

#include "contact/surface/outputs.h"
#include "core/ranks.h"
#include "registry/options_handle.h"

namespace rc {

struct Fact {
  std::string name, value;
};

std::vector<Fact> facts_of(const rc_system& system, const rc_options& options);
// The arguments and wanted outputs of a step or history, without the values at points.
std::vector<Fact> facts_of(const rc_step& step, const Outputs& outputs);
std::vector<Fact> facts_of(const rc_history& path);

// Throws Error(ARGUMENT) on every rank if the facts of one differ from those of rank 0. counts: this rank's do.
void check_agreement(const Ranks& ranks, const std::vector<Fact>& facts, bool counts = true);

}  // namespace rc
