// --budget: how sure the numbers of the last step are.
#pragma once

#include <roughcontact/budget.h>

#include <memory>

#include "files/json_text.h"
#include "solve/problem.h"

namespace cli {

using Budget = std::shared_ptr<const rc_budget>;

// Solves the last step again for each source of arguments.budget; null if the first signal ended it, see stop_flag().
Budget make_budget(const SolveArguments& arguments, const Problem& problem, const rc_options* options);

void print_budget(const rc_budget& budget);
void add_budget(const rc_budget& budget, const std::string& sources, JsonText& document);

}  // namespace cli
