// roughcontact-bench: time, memory and accuracy of the library, through its public interface alone.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <thread>

#include "accuracy.h"
#include "batch.h"
#include "busy.h"
#include "deterministic.h"
#include "dilute.h"
#include "failures.h"
#include "histories.h"
#include "machine_limits.h"
#include "products.h"
#include "provenance.h"
#include "scaling.h"

namespace {

void write(const std::string& file, const bench::Json& document) {
  if (file.empty()) return;
  std::ofstream out(file);
  out << document.dump(1) << '\n';
  if (!out.flush()) throw std::runtime_error("cannot write " + file);
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{"Benchmarks of the roughcontact library"};
  app.require_subcommand(1);
  std::string file;
  const auto available = static_cast<std::int64_t>(std::max(1U, std::thread::hardware_concurrency()));

  bench::ScalingRequest scaling;
  scaling.threads = available;
  bool quick = false;
  CLI::App* const scale = app.add_subcommand("scaling", "time, products and memory against grid size and contact area");
  CLI::Option* const sizes =
      scale->add_option("--sizes", scaling.sizes, "points per side")->delimiter(',')->check(CLI::Range(16, 16384));
  std::vector<double> percent{1, 10, 40};
  scale->add_option("--percents", percent, "contact areas in percent of the grid")
      ->delimiter(',')
      ->check(CLI::Range(0.001, 90.0));
  scale->add_option("--controls", scaling.controls, "displacement, load")
      ->delimiter(',')
      ->check(CLI::IsMember({"displacement", "load"}));
  scale->add_option("--seed", scaling.seed, "of the surface");
  scale->add_option("--tol", scaling.tol, "certified tolerance");
  scale->add_option("--precision", scaling.precision, "of products: option fft.precision")
      ->check(CLI::IsMember({"mixed", "single"}));
  scale->add_option("--solver", scaling.solver, "solver by name, or auto");
  scale->add_option("--backend", scaling.backend, "backend by name, or auto");
  scale->add_option("--threads", scaling.threads, "threads")->check(CLI::Range(1, 1024));
  scale->add_option("--budget", scaling.budget, "seconds for repeats of each solve");
  scale->add_option("--time-limit", scaling.time_limit, "seconds after which no row begins; 0: none");
  scale->add_flag("--quick", quick, "up to 512^2, few repeats");

  bench::ProductsRequest products;
  products.threads = available;
  CLI::App* const product = app.add_subcommand("products", "one product against a transform padded to 2n x 2n");
  CLI::Option* const product_sizes =
      product->add_option("--sizes", products.sizes, "points per side")->delimiter(',')->check(CLI::Range(16, 8192));
  product->add_option("--seed", products.seed, "of the surface");
  product->add_option("--threads", products.threads, "threads, and one")->check(CLI::Range(1, 1024));
  product->add_option("--budget", products.budget, "seconds for repeats of each row");
  product->add_option("--planning-limit", products.planning_limit, "seconds for FFTW_MEASURE of the padded transform");
  product->add_flag("--quick", quick, "up to 512^2, few repeats");

  bench::LimitsRequest limits;
  limits.threads = available;
  CLI::App* const limit = app.add_subcommand("limits", "products and passes against what memory and in-cache transforms allow");
  CLI::Option* const limit_sizes =
      limit->add_option("--sizes", limits.sizes, "points per side, powers of two")->delimiter(',')->check(CLI::Range(64, 8192));
  limit->add_option("--threads", limits.threads, "threads, and one")->check(CLI::Range(1, 1024));
  limit->add_option("--budget", limits.budget, "seconds for repeats of each measurement");
  limit->add_flag("--quick", quick, "256^2, few repeats");

  bench::BusyRequest busy;
  bench::DeterministicRequest deterministic;
  deterministic.threads = available;
  CLI::App* const beside = app.add_subcommand("busy", "a solve alone, and beside other processes at full load");
  CLI::App* const repeatable = app.add_subcommand("deterministic", "what bitwise repeatable results cost");
  bench::ColdScene scene;
  double scene_percent = 100 * scene.area;
  std::int64_t repeats = busy.repeats;
  for (CLI::App* const command : {beside, repeatable}) {
    command->add_option("--points", scene.n, "points per side")->check(CLI::Range(16, 16384));
    command->add_option("--percent", scene_percent, "contact area in percent of the grid, about")->check(CLI::Range(0.001, 90.0));
    command->add_option("--tol", scene.tol, "certified tolerance");
    command->add_option("--solver", scene.solver, "solver by name, or auto");
    command->add_option("--backend", scene.backend, "backend by name, or auto");
    command->add_option("--repeats", repeats, "of each solve")->check(CLI::Range(1, 1000));
    command->add_flag("--quick", quick, "256^2, three repeats");
  }
  beside->add_option("--threads", busy.threads, "threads")->delimiter(',')->check(CLI::Range(1, 1024));
  beside->add_option("--others", busy.others, "processes at full load; 0: none")->check(CLI::Range(0, 1024));
  repeatable->add_option("--threads", deterministic.threads, "threads, against one")->check(CLI::Range(1, 1024));

  bench::AccuracyRequest accuracy;
  accuracy.threads = available;
  CLI::App* const accurate = app.add_subcommand("accuracy", "speed against accuracy of solvers on every backend");
  accurate->add_option("--scenes", accuracy.scenes, "hertz, self-affine-N")->delimiter(',');
  accurate->add_option("--solvers", accuracy.solvers, "by name")->delimiter(',');
  accurate->add_option("--digits", accuracy.digits, "tolerances 10^-digits")->delimiter(',')->check(CLI::Range(1, 15));
  accurate->add_option("--threads", accuracy.threads, "threads")->check(CLI::Range(1, 1024));
  accurate->add_option("--budget", accuracy.budget, "seconds for repeats of each solve");
  accurate->add_option("--time-limit", accuracy.time_limit, "seconds for one solve; 0: none");

  bench::HistoriesRequest histories;
  CLI::App* const history = app.add_subcommand("histories", "loading histories: warm starts against cold ones");
  history->add_option("--levels", histories.levels, "2^levels points a side")->check(CLI::Range(4, 13));
  history->add_option("--steps", histories.steps, "of increasing approach")->check(CLI::Range(2, 1000));
  history->add_option("--seeds", histories.seeds, "of the surfaces")->delimiter(',');
  history->add_option("--solvers", histories.solvers, "name, name+key=value+..., either with @backend; every one, and nnls@dense")
      ->delimiter(',');
  history->add_option("--backend", histories.backend, "by name");
  history->add_option("--tol", histories.tol, "certified tolerance");
  history->add_option("--threads", histories.threads, "threads")->check(CLI::Range(1, 1024));
  history->add_option("--time-limit", histories.time_limit, "seconds for one step; 0: none");

  bench::FailuresRequest failures;
  CLI::App* const failure = app.add_subcommand("failures", "the failure atlas: where methods fail, how that shows, what helps");
  failure->add_option("--row", failures.rows, "families of rows")
      ->delimiter(',')
      ->check(CLI::IsMember(bench::failure_families()));
  failure->add_option("--surface", failures.surface, "a measured surface for the rows of cmr")->check(CLI::ExistingFile);
  failure->add_flag("--quick", failures.quick, "fewer draws, smaller surfaces");
  bench::BatchRequest batch;
  batch.threads = available;
  CLI::App* const many =
      app.add_subcommand("batch", "histories of many small contacts in one call, with one thread and with several");
  CLI::Option* const surfaces = many->add_option("--surfaces", batch.surfaces, "contacts")->check(CLI::Range(1, 1000000));
  many->add_option("--points", batch.points, "points per side")->check(CLI::Range(16, 4096));
  many->add_option("--steps", batch.steps, "of each history")->check(CLI::Range(1, 1000));
  many->add_option("--threads", batch.threads, "threads, against one")->check(CLI::Range(1, 1024));
  many->add_option("--control", batch.control, "displacement, or load")->check(CLI::IsMember({"displacement", "load"}));
  many->add_option("--solver", batch.solver, "solver by name, or auto");
  many->add_option("--backend", batch.backend, "backend by name, or auto");
  many->add_option("--tol", batch.tol, "certified tolerance");
  many->add_flag("--quick", quick, "40 surfaces");
  bench::DiluteRequest dilute;
  dilute.threads = available;
  CLI::App* const sparse = app.add_subcommand("dilute", "dilute contacts: products by backends split and fft, and solves");
  CLI::Option* const dilute_sizes =
      sparse->add_option("--sizes", dilute.sizes, "points per side")->delimiter(',')->check(CLI::Range(16, 16384));
  std::vector<double> in_contact{0.04, 0.1, 1, 10};
  sparse->add_option("--contacts", in_contact, "contact areas in percent of the grid")
      ->delimiter(',')
      ->check(CLI::Range(0.001, 25.0));
  sparse->add_option("--threads", dilute.threads, "threads; products with one as well")->check(CLI::Range(1, 1024));
  sparse->add_option("--seed", dilute.seed, "of the surface");
  sparse->add_option("--budget", dilute.budget, "seconds for repeats of each product and solve");
  sparse->add_option("--controls", dilute.controls, "displacement, load")
      ->delimiter(',')
      ->check(CLI::IsMember({"displacement", "load"}));
  sparse->add_option("--tols", dilute.tolerances, "certified tolerances of the solves")->delimiter(',');
  sparse->add_option("--largest-full", dilute.largest_full, "points a side up to which solves go over the whole grid as well");
  bool large = false, products_only = false, solves_only = false;
  sparse->add_flag("--large", large, "8192^2 and 16384^2 as well");
  sparse->add_flag("--products-only", products_only, "no solves");
  sparse->add_flag("--solves-only", solves_only, "no products")->excludes("--products-only");
  CLI::App* const who = app.add_subcommand("provenance", "what is measured here: library, compiler, machine, as JSON");
  for (CLI::App* const command : {scale, product, limit, beside, repeatable, accurate, history, failure, many, sparse})
    command->add_option("--json", file, "also write the results to this file");
  CLI11_PARSE(app, argc, argv);

  if (who->parsed()) {
    std::cout << bench::provenance(available).dump(1) << '\n';
  } else if (scale->parsed()) {
    scaling.areas.clear();
    for (const double value : percent) scaling.areas.push_back(value / 100);
    if (quick) {
      if (sizes->empty()) scaling.sizes = {128, 256, 512};
      scaling.budget = 0.2;
    }
    scaling.file = file;
    bench::run_scaling(scaling);
  } else if (product->parsed()) {
    if (quick) {
      if (product_sizes->empty()) products.sizes = {128, 256, 512};
      products.budget = 0.2;
      products.planning_limit = 1;
    }
    bench::Json document = {{"benchmark", "products"}, {"provenance", bench::provenance(products.threads)}};
    document.update(bench::run_products(products));
    write(file, document);
  } else if (limit->parsed()) {
    if (quick) {
      if (limit_sizes->empty()) limits.sizes = {256};
      limits.budget = 0.05;
      limits.quick = true;
    }
    bench::Json document = {{"benchmark", "limits"}, {"provenance", bench::provenance(limits.threads)}};
    document.update(bench::run_limits(limits));
    write(file, document);
  } else if (beside->parsed() || repeatable->parsed()) {
    scene.area = scene_percent / 100;
    if (quick) {
      scene.n = std::min<std::int64_t>(scene.n, 256);
      repeats = std::min<std::int64_t>(repeats, 3);
    }
    busy.scene = deterministic.scene = scene;
    busy.repeats = deterministic.repeats = repeats;
    bench::Json document = {{"benchmark", beside->parsed() ? "busy" : "deterministic"},
                            {"provenance", bench::provenance(available)}};
    document.update(beside->parsed() ? bench::run_busy(busy) : bench::run_deterministic(deterministic));
    write(file, document);
  } else if (many->parsed()) {
    if (quick && surfaces->empty()) batch.surfaces = 40;
    bench::Json document = {{"benchmark", "batch"}, {"provenance", bench::provenance(batch.threads)}};
    document.update(bench::run_batch(batch));
    write(file, document);
  } else if (sparse->parsed()) {
    dilute.contacts.clear();
    if (large && dilute_sizes->empty()) dilute.sizes.insert(dilute.sizes.end(), {8192, 16384});
    dilute.products = !solves_only;
    dilute.solves = !products_only;
    for (const double value : in_contact) dilute.contacts.push_back(value / 100);
    bench::Json document = {{"benchmark", "dilute"}, {"provenance", bench::provenance(dilute.threads)}};
    document.update(bench::run_dilute(dilute));
    write(file, document);
  } else if (failure->parsed()) {
    bench::Json document = {{"benchmark", "failures"}, {"provenance", bench::provenance(1)}};
    document.update(bench::run_failures(failures));
    write(file, document);
  } else if (history->parsed()) {
    bench::Json document = {{"benchmark", "histories"}, {"provenance", bench::provenance(histories.threads)}};
    document.update(bench::run_histories(histories));
    write(file, document);
  } else {
    bench::Json document = {{"benchmark", "accuracy"}, {"provenance", bench::provenance(accuracy.threads)}};
    document.update(bench::run_accuracy(accuracy));
    write(file, document);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "roughcontact-bench: %s\n", error.what());
  return 1;
}
