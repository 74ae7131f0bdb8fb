// roughcontact-baseline: one solve by the standard method in a process of its own, for bench/peers. Writes the pressures at which
// each level of the residual was first met, and prints times and memory as JSON.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "../child.h"
#include "npy_writer.h"
#include "polonsky_keer.h"
#include "formats/surface.h"

namespace {

// A line of /proc/self/status [bytes].
double memory(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(name + ":")) return 1024 * std::stod(line.substr(name.size() + 1));
  return NAN;
}

void write(const std::string& file, const std::vector<double>& values, std::int64_t n) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(file.c_str(), "wb"), std::fclose);
  if (!out) throw std::runtime_error("cannot write " + file);
  cli::write_npy(out.get(), values, n, n);
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"Polonsky-Keer conjugate gradients with a padded transform"};
  std::string gap_file, prefix, wisdom, control = "load";
  double target = 0, limit = 60, planning = 60;
  std::vector<double> levels{1e-4, 1e-6, 1e-8};
  int threads = 2;
  std::int64_t most = 100000;
  app.add_option("--gap", gap_file, "gap on the unit square, .npy")->required()->check(CLI::ExistingFile);
  app.add_option("--out", prefix, "pressures go to PREFIX-0.npy, PREFIX-1.npy ...")->required();
  app.add_option("--control", control, "what is prescribed")->check(CLI::IsMember({"load", "displacement"}));
  app.add_option("--target", target, "load or approach")->required();
  app.add_option("--levels", levels, "residuals, descending")->delimiter(',');
  app.add_option("--limit", limit, "seconds of iterations");
  app.add_option("--planning", planning, "seconds of FFTW_MEASURE at most");
  app.add_option("--wisdom", wisdom, "plans are kept in this file from run to run");
  app.add_option("--threads", threads, "threads")->check(CLI::Range(1, 1024));
  app.add_option("--iterations", most, "at most");
  CLI11_PARSE(app, argc, argv);

  const std::vector<double> gap = cli::read_surface(gap_file, 1).heights;
  bench::StandardProblem problem;
  problem.n = std::llround(std::sqrt(static_cast<double>(gap.size())));
  if (problem.n * problem.n != static_cast<std::int64_t>(gap.size())) throw std::runtime_error(gap_file + ": not square");
  problem.gap = &gap;
  problem.load_control = control == "load";
  problem.target = target;

  std::ofstream("/proc/self/clear_refs") << "5";  // the peak counts from here; without the right to do so, from the start
  // The caller's gap is there already; every code's memory counts it.
  const double start = memory("VmHWM") - 8.0 * static_cast<double>(gap.size()), cpu_start = bench::cpu_seconds();
  const auto begun = std::chrono::steady_clock::now();
  fftw_init_threads();
  if (!wisdom.empty()) fftw_import_wisdom_from_filename(wisdom.c_str());
  bench::PaddedProduct product(problem.n, threads, FFTW_MEASURE, planning);
  const double setup = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  if (!wisdom.empty()) fftw_export_wisdom_to_filename(wisdom.c_str());

  nlohmann::ordered_json reached = nlohmann::ordered_json::array();
  double peak = 0;
  bench::polonsky_keer(problem, product, threads, most, [&](const bench::StandardState& state) {
    // The certificate finds its own approach; half of the level leaves it room.
    while (reached.size() < levels.size() && state.residual <= 0.5 * levels[reached.size()]) {
      peak = memory("VmHWM");
      const std::string file = prefix + "-" + std::to_string(reached.size()) + ".npy";
      write(file, state.p, problem.n);
      reached.push_back({{"tol", levels[reached.size()]},
                         {"file", file},
                         {"solve_seconds", state.seconds},
                         {"iterations", state.iteration},
                         {"products", state.products},
                         {"peak_bytes", peak}});
    }
    return reached.size() < levels.size() && state.seconds < limit;
  });
  std::cout << nlohmann::ordered_json{{"setup_seconds", setup},
                                      {"planning_seconds", product.planning_seconds()},
                                      {"start_bytes", start},
                                      {"cpu_seconds", bench::cpu_seconds() - cpu_start},
                                      {"reached", reached}}
            << '\n';
} catch (const std::exception& error) {
  std::fprintf(stderr, "roughcontact-baseline: %s\n", error.what());
  return 1;
}
