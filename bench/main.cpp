// roughcontact-bench: time, memory and accuracy of the library, through its public interface alone.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <thread>

#include "batch.h"
#include "busy.h"
#include "deterministic.h"
#include "dilute.h"
#include "failures.h"
#include "goal.h"
#include "goal_surfaces.h"
#include "goal_trial.h"
#include "histories.h"
#include "machine_limits.h"
#include "paper.h"
#include "pareto.h"
#include "physics.h"
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

  bench::ParetoRequest pareto;
  pareto.threads = available;
  CLI::App* const tradeoff = app.add_subcommand("pareto", "speed against accuracy of every method, kernel and grid");
  CLI::Option* const pareto_scenes = tradeoff->add_option("--scenes", pareto.scenes, "what is pressed")
                                         ->delimiter(',')
                                         ->check(CLI::IsMember(bench::pareto_scene_names()));
  std::vector<double> pareto_percent{10, 1, 40, 90};
  CLI::Option* const pareto_contacts =
      tradeoff->add_option("--contacts", pareto_percent, "contact areas in percent of the grid, in the order of measuring")
          ->delimiter(',')
          ->check(CLI::Range(0.001, 95.0));
  tradeoff->add_option("--points", pareto.n, "points per side of surfaces that are not measured, a power of two")
      ->check(CLI::IsMember({32, 64, 128, 256, 512, 1024}));
  CLI::Option* const pareto_digits =
      tradeoff->add_option("--digits", pareto.digits, "tolerances 10^-digits")->delimiter(',')->check(CLI::Range(1, 15));
  tradeoff->add_option("--surfaces", pareto.surfaces, "folder with measured surfaces")->check(CLI::ExistingDirectory);
  tradeoff->add_option("--threads", pareto.threads, "threads")->check(CLI::Range(1, 1024));
  tradeoff->add_option("--budget", pareto.budget, "seconds for repeats of each solve");
  tradeoff->add_option("--solve-limit", pareto.solve_limit, "seconds for one solve; 0: none");
  tradeoff->add_option("--method-limit", pareto.method_limit, "seconds after which a method goes on to no tighter tolerance");
  tradeoff->add_option("--time-limit", pareto.time_limit, "seconds after which nothing begins; 0: none");
  tradeoff->add_option("--csv", pareto.csv, "also write the results to this file, a line for each solve");
  tradeoff->add_option("--export", pareto.export_folder, "write gaps and certified pressures into this folder, for other codes");
  tradeoff->add_flag("--quick", quick, "a sphere and a rough surface on 64^2, three tolerances");

  bench::GoalRequest goal;
  goal.threads = available;
  CLI::App* const goals =
      app.add_subcommand("goal", "option accuracy: how often the goal is met, on which grids, and what it saves");
  goals->add_option("--scenes", goal.scenes, "what is pressed")
      ->delimiter(',')
      ->check(CLI::IsMember(bench::pareto_scene_names()));
  goals->add_option("--surfaces", goal.surfaces, "folder with measured surfaces")->check(CLI::ExistingDirectory);
  goals->add_option("--points", goal.points, "points per side of surfaces that are not measured, a power of two")
      ->check(CLI::IsMember({64, 128, 256, 512, 1024, 2048}));
  goals->add_option("--seeds", goal.seeds, "surfaces of each random scene")->check(CLI::Range(1, 1000));
  goals->add_option("--contacts", goal.contacts, "contact areas in percent of the grid")
      ->delimiter(',')
      ->check(CLI::Range(0.1, 95.0));
  goals->add_option("--goals", goal.goals, "values of option accuracy")->delimiter(',')->check(CLI::Range(1e-6, 0.5));
  goals->add_option("--threads", goal.threads, "threads")->check(CLI::Range(1, 1024));

  bench::GoalTrialRequest trial;
  CLI::App* const trials =
      app.add_subcommand("goal-trial", "option accuracy on surfaces made to mislead it: answers beyond their goal");
  trials->add_option("--kinds", trial.surfaces, "what is pressed")
      ->delimiter(',')
      ->check(CLI::IsMember(bench::goal_surface_names()));
  trials->add_option("--points", trial.points, "points per side, about")->check(CLI::Range(32, 2048));
  trials->add_option("--first", trial.first, "seed of each kind")->check(CLI::Range(1, 1000000));
  trials->add_option("--last", trial.last, "seed of each kind")->check(CLI::Range(1, 1000000));
  trials->add_option("--goals", trial.goals, "values of option accuracy")->delimiter(',')->check(CLI::Range(1e-6, 0.5));
  trials->add_option("--threads", trial.threads, "threads")->check(CLI::Range(1, 1024));
  trials->add_flag("--times", trial.times, "solve the whole grid to the goal's tolerance as well, for its time");

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
  bench::PaperRequest paper;
  CLI::App* const figures = app.add_subcommand("paper", "the figures of Bemporad & Paggi (2015)");
  figures->add_option("--figure", paper.figures, "2 (with Example 1), 4, 5, 6, 8, 9, 10 (with 11)")
      ->delimiter(',')
      ->check(CLI::IsMember(bench::paper_figures()));
  figures->add_option("--surfaces", paper.surfaces, "folder with measured surfaces for figure 10")->check(CLI::ExistingDirectory);
  figures->add_option("--threads", paper.threads, "threads of FFT products")->check(CLI::Range(1, 1024));
  figures->add_flag("--quick", paper.quick, "small grids, few seeds");
  bench::PhysicsRequest physics;
  physics.threads = available;
  CLI::App* const rough =
      app.add_subcommand("physics", "area, gap, stiffness, patches and pressures of rough surfaces against load");
  CLI::Option* const seeds = rough->add_option("--seeds", physics.seeds, "of the surfaces")->delimiter(',');
  rough->add_option("--hurst", physics.hurst, "exponent")->check(CLI::Range(0.05, 1.0));
  CLI::Option* const roll_off = rough->add_option("--roll-off", physics.roll_off, "waves a side below which the spectrum is flat")
                                    ->check(CLI::Range(1.0, 1024.0));
  CLI::Option* const cut_off =
      rough->add_option("--cut-off", physics.cut_off, "waves a side above which it is zero")->check(CLI::Range(1.0, 4096.0));
  CLI::Option* const curve_points =
      rough->add_option("--points", physics.points, "points per side, over all loads")->check(CLI::Range(16, 16384));
  CLI::Option* const meshes =
      rough->add_option("--sizes", physics.sizes, "points per side, at two loads")->delimiter(',')->check(CLI::Range(16, 16384));
  rough->add_option("--tol", physics.tol, "certified tolerance");
  rough->add_option("--threads", physics.threads, "threads")->check(CLI::Range(1, 1024));
  rough->add_flag("--quick", quick, "two surfaces of 16 waves a side on up to 256^2");
  CLI::App* const who = app.add_subcommand("provenance", "what is measured here: library, compiler, machine, as JSON");
  for (CLI::App* const command :
       {scale, product, limit, beside, repeatable, tradeoff, goals, trials, history, failure, many, sparse, figures, rough})
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
  } else if (figures->parsed()) {
    paper.file = file;
    bench::run_paper(paper);
  } else if (rough->parsed()) {
    if (quick) {
      if (seeds->empty()) physics.seeds = {1, 2};
      if (roll_off->empty()) physics.roll_off = 2;
      if (cut_off->empty()) physics.cut_off = 16;
      if (curve_points->empty()) physics.points = 128;
      if (meshes->empty()) physics.sizes = {64, 128, 256};
    }
    physics.file = file;
    bench::run_physics(physics);
  } else if (failure->parsed()) {
    bench::Json document = {{"benchmark", "failures"}, {"provenance", bench::provenance(1)}};
    document.update(bench::run_failures(failures));
    write(file, document);
  } else if (goals->parsed()) {
    goal.file = file;
    bench::run_goal(goal);
  } else if (trials->parsed()) {
    trial.file = file;
    bench::run_goal_trial(trial);
  } else if (history->parsed()) {
    bench::Json document = {{"benchmark", "histories"}, {"provenance", bench::provenance(histories.threads)}};
    document.update(bench::run_histories(histories));
    write(file, document);
  } else {
    if (quick) {
      if (pareto_scenes->empty()) pareto.scenes = {"hertz", "self-affine"};
      if (pareto_contacts->empty()) pareto_percent = {10};
      if (pareto_digits->empty()) pareto.digits = {2, 4, 8};
      pareto.n = 64;
      pareto.budget = 0;
      pareto.method_limit = 1;
    }
    pareto.contacts.clear();
    for (const double value : pareto_percent) pareto.contacts.push_back(value / 100);
    pareto.file = file;
    bench::run_pareto(pareto);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "roughcontact-bench: %s\n", error.what());
  return 1;
}
