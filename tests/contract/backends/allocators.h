// Allocators of the backends' dependencies, where they can be replaced.
#pragma once

namespace contract {

// From this call on their allocations can be made to fail as well. Nothing that they allocated before may be released later.
void let_dependencies_use_operator_new();

}  // namespace contract
