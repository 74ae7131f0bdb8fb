// Figures 8 and 9: cascade multi-resolution on midpoint displacement surfaces, by Hurst exponent and by radius h.
#include "cascade.h"
#include "failure_run.h"
#include "paper.h"

namespace bench {

namespace {

// Products, and the solver that the cascade and the whole problem are solved by.
struct Inner {
  const char* backend;
  const char* solver;
};
constexpr Inner transforms = {"fft", "polonsky-keer"}, stored = {"dense", "nnls"};

Solved solve_timed(const Scene& scene, Settings settings, std::int64_t threads) {
  settings.emplace_back(RC_OPT_BOUNDS, "0");
  settings.emplace_back(RC_OPT_THREADS, std::to_string(threads));
  Solved solved = solve(scene, settings);
  if (solved.status < 0) throw Failure(solved.message);
  return solved;
}

Solved solve_whole(const Scene& scene, const Inner& inner, std::int64_t threads) {
  Solved solved = solve_timed(scene, {{"solver", inner.solver}, {"backend", inner.backend}}, threads);
  if (solved.status != RC_OK) throw Failure(solved.message);
  return solved;
}

double error_of(const Solved& solved, const Solved& whole) { return solved.result.load / whole.result.load - 1; }

// Algorithm 6 against the whole problem.
Json compared(const Scene& scene, const Cascade& cascade, const Solved& whole, std::int64_t threads) {
  const Solved plain = solve_timed(scene, settings_of(cascade, false), threads),
               certified = solve_timed(scene, settings_of(cascade, true), threads);
  const CascadeNote note = cascade_note(certified.result.note);
  return {{"load_error", error_of(plain, whole)},
          {"status", plain.name()},
          {"kept", note.share_at_first()},
          {"rounds", note.rounds},
          {"cpu_seconds", plain.cpu_seconds},
          {"products", plain.products()},
          {"certified_error", error_of(certified, whole)},
          {"certified_status", certified.name()},
          {"certified_cpu_seconds", certified.cpu_seconds},
          {"certified_products", certified.products()}};
}

Json whole_record(const Solved& whole) {
  return {{"candidates", whole.result.candidates},
          {"contacts", whole.result.contacts},
          {"whole_cpu_seconds", whole.cpu_seconds},
          {"whole_products", whole.products()}};
}

Json by_exponent(std::int64_t levels, double hurst, std::uint64_t seed, const std::string& kernel, const Inner& inner,
                 std::int64_t threads) {
  Scene scene = rough_scene(levels, seed, hurst);
  scene.kernel = kernel;
  const Solved whole = solve_whole(scene, inner, threads);
  Json row = whole_record(whole);
  Cascade cascade{.backend = inner.backend, .inner = inner.solver};
  row.update(compared(scene, cascade, whole, threads));
  cascade.area = "diagonal";
  row["diagonal"] = compared(scene, cascade, whole, threads);
  return row;
}

Json by_radius(std::int64_t levels, std::uint64_t seed, const std::vector<double>& radii, const Inner& inner,
               std::int64_t threads) {
  Scene scene = rough_scene(levels, seed);
  scene.kernel = "eq9";
  const Solved whole = solve_whole(scene, inner, threads);
  Json row = whole_record(whole);
  row["radii"] = Json::array();
  for (const double radius : radii) {
    Json entry = {{"h", radius}};
    entry.update(compared(scene, {.radius = radius, .backend = inner.backend, .inner = inner.solver}, whole, threads));
    row["radii"].push_back(entry);
  }
  return row;
}

}  // namespace

void plan_figure_8(const PaperRequest& request, Plan& plan) {
  struct Run {
    const char* kernel;
    Inner inner;
    std::uint64_t seeds;
    double cost;
  };
  const std::vector<Run> full = {{"eq9", transforms, 30, 0.5}, {"love", transforms, 30, 0.5}, {"eq9", stored, 8, 8}};
  const std::vector<Run> quick = {{"eq9", transforms, 8, 0.03}, {"love", transforms, 8, 0.03}, {"eq9", stored, 2, 0.1}};
  const std::vector<double> exponents =
      request.quick ? std::vector<double>{0.3, 0.6, 0.9} : std::vector<double>{0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};
  const std::int64_t levels = request.quick ? 6 : 8;
  for (const Run& run : request.quick ? quick : full)
    for (std::uint64_t seed = 1; seed <= run.seeds; ++seed)
      for (const double hurst : exponents)
        plan.push_back(
            {"figure_8",
             {{"hurst", hurst}, {"kernel", run.kernel}, {"backend", run.inner.backend}, {"seed", seed}},
             run.cost,
             [=, threads = request.threads] { return by_exponent(levels, hurst, seed, run.kernel, run.inner, threads); }});
}

void plan_figure_9(const PaperRequest& request, Plan& plan) {
  const std::vector<double> radii =
      request.quick ? std::vector<double>{1.25, 2, 3} : std::vector<double>{1.25, 1.5, 1.75, 2, 2.25, 2.5, 2.75, 3};
  const std::int64_t levels = request.quick ? 6 : 8;
  for (const Inner& inner : {transforms, stored}) {
    const bool dense = std::string(inner.backend) == "dense";
    const std::uint64_t seeds = request.quick ? (dense ? 2 : 6) : (dense ? 6 : 30);
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
      plan.push_back({"figure_9",
                      {{"backend", inner.backend}, {"seed", seed}},
                      request.quick ? 0.2
                      : dense       ? 30.0
                                    : 2.0,
                      [=, threads = request.threads] { return by_radius(levels, seed, radii, inner, threads); }});
  }
}

}  // namespace bench
