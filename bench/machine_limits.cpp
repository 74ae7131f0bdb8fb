#include "machine_limits.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iostream>
#include <memory>
#include <thread>

#include "cold_solve.h"
#include "fftw_by_precision.h"
#include "product_timer.h"
#include "stopwatch.h"
#include "table.h"

namespace bench {

namespace {

// work(thread) on all of them at once.
template <class Work> void on_threads(std::int64_t threads, const Work& work) {
  std::vector<std::jthread> helpers;
  for (std::int64_t t = 1; t < threads; ++t) helpers.emplace_back([&, t] { work(t); });
  work(0);
}

// Bytes a second of a = b + s c, counted as McCalpin's STREAM does: two reads and a write.
Json measure_bandwidth(const LimitsRequest& request, std::int64_t threads) {
  const std::int64_t n = request.quick ? 1 << 20 : 1 << 24;  // three arrays of 128 MiB fit in no cache
  const std::unique_ptr<double[]> a(new double[static_cast<std::size_t>(n)]), b(new double[static_cast<std::size_t>(n)]),
      c(new double[static_cast<std::size_t>(n)]);
  const auto share = [&](std::int64_t t, const auto& body) {
    double *const x = a.get(), *const y = b.get(), *const z = c.get();
    for (std::int64_t i = n * t / threads; i < n * (t + 1) / threads; ++i) body(x[i], y[i], z[i]);
  };
  on_threads(threads, [&](std::int64_t t) {
    share(t, [](double& x, double& y, double& z) {
      x = 0;
      y = 1;
      z = 2;
    });
  });
  const CallTimes times = time_calls(request.budget, [&] {
    on_threads(threads, [&](std::int64_t t) { share(t, [](double& x, double y, double z) { x = y + 3 * z; }); });
  });
  const double bytes = 24 * static_cast<double>(n);
  return {{"threads", threads}, {"megabytes", bytes / 1e6}, {"gigabytes_per_second", bytes / times.best / 1e9}};
}

// 5 n log2 n operations for each complex transform, over and over on one line in the first two levels of the cache.
template <class Real> Json measure_transform(const LimitsRequest& request, std::int64_t length, std::int64_t threads) {
  const std::int64_t repeats = std::max<std::int64_t>(1, (1 << 21) / length);
  struct Line {
    std::unique_ptr<Real[], void (*)(void*)> data{nullptr, fftw_free};
    typename Fftw<Real>::Plan plan = nullptr;
  };
  std::vector<Line> lines(static_cast<std::size_t>(threads));
  Fftw<Real>::init_threads();
  Fftw<Real>::plan_with_threads(1);
  for (Line& line : lines) {
    line.data.reset(Fftw<Real>::alloc_real(static_cast<std::size_t>(2 * length)));
    auto* const z = reinterpret_cast<typename Fftw<Real>::Complex*>(line.data.get());
    line.plan = Fftw<Real>::plan_complex(static_cast<int>(length), z, z, FFTW_FORWARD, FFTW_MEASURE);
    if (!line.plan) throw Failure("FFTW made no plan");
    std::fill_n(line.data.get(), 2 * length, Real{0});  // stays zero: values would grow beyond all bounds
  }
  const CallTimes times = time_calls(request.budget, [&] {
    on_threads(threads, [&](std::int64_t t) {
      for (std::int64_t k = 0; k < repeats; ++k) Fftw<Real>::execute(lines[static_cast<std::size_t>(t)].plan);
    });
  });
  for (Line& line : lines) Fftw<Real>::destroy(line.plan);
  const double operations = 5 * static_cast<double>(length * repeats * threads) * std::log2(static_cast<double>(length));
  return {{"length", length},
          {"precision", sizeof(Real) == 4 ? "single" : "double"},
          {"threads", threads},
          {"gigaflops", operations / times.best / 1e9}};
}

// Of one product over n x n points by transforms of length P = 2n, docs/performance.md. Rows: n real transforms of 5/2 P log2 P
// forward and as many back. Columns: n + 1 complex ones of 5 P log2 P forward and back, and 2 P products with eigenvalues each.
double product_operations(double n) {
  const double length = 2 * n, line = 5 * length * std::log2(length);
  return n * line + (n + 1) * (2 * line + 2 * length);
}

// Of sizeof(Real): x read, half spectra of rows written; those read and written again by the columns, eigenvalues read; half
// spectra read, y written.
double product_values(double n) {
  return n * n + 2 * n * (n + 1) + (4 * n * (n + 1) + (n + 1) * (n + 1)) + 2 * n * (n + 1) + n * n;
}

// What the solver's own passes read and write for a point and an iteration, docs/performance.md.
struct PassBytes {
  double trees, vectors;
  double all() const { return trees + vectors; }
};
PassBytes pass_bytes(double real) {
  // Two trees, applied side by side: residuals and the contact set read going up and going down, z written, q read; loads of the
  // finest blocks written and pressures read; on the coarser levels, with a twelfth of the points, blocks of 20 bytes and values.
  const double applied = 4 * real + 6 + 2 * (2 * 20.0 / 12 + 4);
  // Set up every second iteration: the contact set read, blocks written.
  const double set_up = (3 + 2 * (20.0 / 12 + 2)) / 2;
  const double turn = 4 * real + 1, curvature = 2 * real, advance = 16 + 4 * real;
  // Every second iteration: what was cut off, the residual with its measures, the choice of the contact set.
  const double bound = (real + (3 * real + 16) + (8 + real + 2)) / 2;
  return {applied + set_up, turn + curvature + advance + bound};
}

const char* name_of(bool single) { return single ? "single" : "double"; }

double value_of(const Json& rows, const Json& key, const char* value) {
  for (const Json& row : rows)
    if (std::all_of(key.items().begin(), key.items().end(), [&](const auto& item) { return row.at(item.key()) == item.value(); }))
      return row.at(value);
  return 0;
}

class Limits {
 public:
  explicit Limits(const LimitsRequest& request) : request_(request) {
    threads_.push_back(1);
    if (request.threads > 1) threads_.push_back(request.threads);
  }

  Json run() {
    for (const std::int64_t threads : threads_) bandwidth_.push_back(measure_bandwidth(request_, threads));
    for (const std::int64_t n : request_.sizes)
      for (const std::int64_t threads : threads_) {
        transforms_.push_back(measure_transform<float>(request_, 2 * n, threads));
        transforms_.push_back(measure_transform<double>(request_, 2 * n, threads));
      }
    for (const std::int64_t n : request_.sizes) {
      std::cerr << "products and passes on " << n << "^2\n";
      const Json rows = in_child([&] { return of_grid(n); });
      if (rows.is_object()) throw Failure(rows.at("error").get<std::string>());
      for (const Json& row : rows) (row.contains("iterations") ? passes_ : products_).push_back(row);
    }
    return {{"bandwidth", bandwidth_}, {"transforms", transforms_}, {"products", products_}, {"passes", passes_}};
  }

 private:
  Json of_grid(std::int64_t n) const {
    ColdSolve solve({.n = n, .area = 0.1, .tol = 1e-3, .solver = "haar-cg", .backend = "fft"});
    solve.seconds(threads_.back());
    solve.prescribe_approach();
    Json rows = Json::array();
    for (const std::int64_t threads : threads_) {
      double seconds[2];
      for (const bool single : {false, true}) {
        rows.push_back(product(n, solve.step(), threads, single));
        seconds[single] = rows.back().at("seconds");
      }
      for (const bool single : {false, true}) rows.push_back(passes(solve, threads, single, seconds));
    }
    return rows;
  }

  Json product(std::int64_t n, rc_step step, std::int64_t threads, bool single) const {
    const auto [lowest, highest] = std::minmax_element(step.gap, step.gap + n * n);
    step.target = 2 * *highest - *lowest;  // every point is a candidate
    const CallTimes times = time_products(unit_square(n), step, {"fft", "", threads, request_.budget, single});
    const double points = static_cast<double>(n * n), side = static_cast<double>(n);
    const double operations = product_operations(side), bytes = product_values(side) * (single ? 4 : 8);
    const double flops = value_of(transforms_, {{"length", 2 * n}, {"precision", name_of(single)}, {"threads", threads}},
                                  "gigaflops"),
                 bandwidth = value_of(bandwidth_, {{"threads", threads}}, "gigabytes_per_second");
    const double by_flops = operations / flops / 1e9, by_bytes = bytes / bandwidth / 1e9;
    return {{"n", n},
            {"precision", name_of(single)},
            {"threads", threads},
            {"operations_per_point", operations / points},
            {"bytes_per_point", bytes / points},
            {"seconds", times.best},
            {"operation_seconds", by_flops},
            {"byte_seconds", by_bytes},
            {"gigaflops", operations / times.best / 1e9},
            {"gigabytes_per_second", bytes / times.best / 1e9},
            {"fraction_of_transforms", by_flops / times.best},
            {"fraction_of_bandwidth", by_bytes / times.best},
            {"fraction", std::max(by_flops, by_bytes) / times.best}};
  }

  // What a solve takes besides its products. In single precision two are in double: the one that confirms, and the certificate's.
  Json passes(ColdSolve& solve, std::int64_t threads, bool single, const double* product_seconds) const {
    const std::vector<std::pair<std::string, std::string>> options = {{"haar-cg.nested", "0"},
                                                                      {"haar-cg.products", single ? "mixed" : "double"}};
    solve.seconds(threads, options);
    double best = solve.seconds(threads, options);
    const auto begun = Clock::now();
    while (seconds_since(begun) < request_.budget) best = std::min(best, solve.seconds(threads, options));
    const rc_result& result = solve.result();
    const auto products = static_cast<double>(result.applications), iterations = static_cast<double>(result.iterations);
    const double in_products =
        single ? 2 * product_seconds[0] + (products - 2) * product_seconds[1] : products * product_seconds[0];
    const PassBytes bytes = pass_bytes(single ? 4 : 8);
    const double rest = best - in_products, bandwidth = value_of(bandwidth_, {{"threads", threads}}, "gigabytes_per_second");
    const double by_bytes = iterations * bytes.all() * static_cast<double>(result.points) / bandwidth / 1e9;
    return {{"n", std::llround(std::sqrt(static_cast<double>(result.points)))},
            {"precision", name_of(single)},
            {"threads", threads},
            {"iterations", result.iterations},
            {"products", result.applications},
            {"seconds", best},
            {"product_seconds", in_products},
            {"other_seconds", rest},
            {"share_of_products", in_products / best},
            {"tree_bytes_per_point", bytes.trees},
            {"vector_bytes_per_point", bytes.vectors},
            {"byte_seconds", by_bytes},
            {"fraction_of_bandwidth", by_bytes / rest}};
  }

  const LimitsRequest request_;
  std::vector<std::int64_t> threads_;
  Json bandwidth_ = Json::array(), transforms_ = Json::array(), products_ = Json::array(), passes_ = Json::array();
};

const std::vector<Column> bandwidth_columns = {{"threads", "threads"}, {"GB/s", "gigabytes_per_second", "%.1f"}};
const std::vector<Column> transform_columns = {
    {"length", "length"}, {"precision", "precision"}, {"threads", "threads"}, {"GFlop/s", "gigaflops", "%.1f"}};
const std::vector<Column> product_columns = {{"n", "n"},
                                             {"precision", "precision"},
                                             {"threads", "threads"},
                                             {"operations/point", "operations_per_point", "%.0f"},
                                             {"bytes/point", "bytes_per_point", "%.0f"},
                                             {"measured s", "seconds", "%.5f"},
                                             {"by operations", "operation_seconds", "%.5f"},
                                             {"by bytes", "byte_seconds", "%.5f"},
                                             {"GFlop/s", "gigaflops", "%.1f"},
                                             {"GB/s", "gigabytes_per_second", "%.1f"},
                                             {"fraction", "fraction", "%.2f"}};
const std::vector<Column> pass_columns = {{"n", "n"},
                                          {"precision", "precision"},
                                          {"threads", "threads"},
                                          {"iterations", "iterations"},
                                          {"products", "products"},
                                          {"solve s", "seconds", "%.4f"},
                                          {"products s", "product_seconds", "%.4f"},
                                          {"other s", "other_seconds", "%.4f"},
                                          {"trees B/point", "tree_bytes_per_point", "%.0f"},
                                          {"vectors B/point", "vector_bytes_per_point", "%.0f"},
                                          {"by bytes", "byte_seconds", "%.4f"},
                                          {"fraction", "fraction_of_bandwidth", "%.2f"}};

}  // namespace

Json run_limits(const LimitsRequest& request) {
  for (const std::int64_t n : request.sizes)
    if (!std::has_single_bit(static_cast<std::uint64_t>(n))) throw Failure("the counts hold for powers of two only");
  const Json found = Limits(request).run();
  std::cout << "Memory: triad\n"
            << table(bandwidth_columns, found.at("bandwidth")) << "\nComplex transforms in the cache, FFTW, measured plans\n"
            << table(transform_columns, found.at("transforms")) << "\nOne product over the whole grid\n"
            << table(product_columns, found.at("products"))
            << "\nA cold solve to 1e-3 without coarser grids; other: trees, passes over vectors, set-up, certificate\n"
            << table(pass_columns, found.at("passes"));
  return found;
}

}  // namespace bench
