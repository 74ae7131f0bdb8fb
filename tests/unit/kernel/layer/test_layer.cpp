// The kernel "layer"; with a file, its rows of layer_reference.py.
#include "layer.h"

int main(int argc, char** argv) {
  if (argc > 1) {
    const layer::Checks found = layer::check_rows(argv[1], 1e-9);
    print_message("%d of %d coefficients are off by more than 1e-9 of the largest; at most %.1e\n", found.beyond, found.rows,
                  found.worst);
    return found.beyond > 0 || found.rows == 0;
  }
  std::vector<CMUnitTest> all;
  for (const auto* part : {&layer::value_tests, &layer::solve_tests}) all.insert(all.end(), part->begin(), part->end());
  return _cmocka_run_group_tests("layer", all.data(), all.size(), nullptr, nullptr);
}
