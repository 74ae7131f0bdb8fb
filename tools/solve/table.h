// The table on standard output: one row a step.
#pragma once

#include "solve/problem.h"
#include "solve/step_record.h"

namespace cli {

void print_table_head(const Problem& problem);
void print_table_row(const Problem& problem, const StepRecord& step);

}  // namespace cli
