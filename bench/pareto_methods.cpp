#include "pareto_methods.h"

#include <string_view>

namespace bench {

namespace {

constexpr double least_single_tol = 1e-5;  // of fft.precision=single

bool supported(const std::string& solver, const std::string& backend, const rc_system& system, std::int32_t control) {
  return rc_pair_supported(nullptr, solver.c_str(), backend.c_str(), &system, control, nullptr) == RC_OK;
}

bool is_option(const std::string& key) {
  for (std::int64_t i = 0; i < rc_options_count(nullptr); ++i) {
    rc_option_spec spec{};
    spec.struct_size = sizeof spec;
    check(rc_options_describe(nullptr, i, &spec));
    if (key == spec.key) return true;
  }
  return false;
}

bool multiplies_by_transforms(const std::string& backend) { return backend == "fft" || backend == "split"; }
bool is_conjugate_gradients(std::string_view solver) { return solver == "haar-cg" || solver == "polonsky-keer"; }

// A product of backend split is worth its price where contact is sparse, and then with the solvers that need few; a stored
// matrix, with those that solve systems on it or multiply by it and no more.
bool makes_sense(const std::string& solver, const std::string& backend) {
  if (backend == "fft") return true;
  if (backend == "split") return is_conjugate_gradients(solver) || solver == "nnls";
  return solver != "cmr" && solver != "gp";
}

void add_variants(const std::string& solver, const std::string& backend, std::vector<ParetoMethod>& methods) {
  const Settings pair = {{RC_OPT_SOLVER, solver}, {RC_OPT_BACKEND, backend}};
  methods.push_back({solver, backend, "", pair, 0});
  const auto add = [&](const char* variant, const std::string& key, double least_tol) {
    if (!is_option(key)) return;
    Settings settings = pair;
    settings.emplace_back(key, variant);
    methods.push_back({solver, backend, variant, settings, least_tol});
  };
  if (backend == "fft") add("double", solver + ".products", 0);
  if (backend == "fft" && is_conjugate_gradients(solver)) add("single", backend + ".precision", least_single_tol);
}

}  // namespace

std::vector<ParetoMethod> pareto_methods(const rc_system& system, std::int32_t control, std::int64_t candidates,
                                         std::int64_t most_factored) {
  std::vector<ParetoMethod> methods = {{"auto", "auto", "", {}, 0}};
  for (const std::string& backend : backend_names())
    for (const std::string& solver : solver_names())
      if (supported(solver, backend, system, control) && makes_sense(solver, backend) &&
          (multiplies_by_transforms(backend) || candidates <= most_factored))
        add_variants(solver, backend, methods);
  return methods;
}

}  // namespace bench
