#include "scaling.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <numbers>
#include <type_traits>

#include "library.h"
#include "measurement.h"
#include "padded_product.h"
#include "product_timer.h"
#include "scene.h"
#include "table.h"

namespace bench {

namespace {

SelfAffine surface_of(const ScalingRequest& request) {
  SelfAffine surface;
  surface.seed = request.seed;
  return surface;
}

Options options_of(const ScalingRequest& request, double tol) {
  Options options;
  options.set(RC_OPT_SOLVER, request.solver).set(RC_OPT_BACKEND, request.backend);
  options.set(RC_OPT_THREADS, static_cast<double>(request.threads)).set(RC_OPT_TOL, tol);
  return options;
}

// Load that brings a share `area` of the surface into contact, from load ~ area at first. Solves loosely, in load control.
Json find_load(const ScalingRequest& request, std::int64_t n, double area, double guess) {
  constexpr double near_enough = 0.03, loose = 1e-3;
  constexpr int most_solves = 6;
  const Field gap = self_affine_gap(n, surface_of(request));
  Contact contact(unit_square(n), options_of(request, loose));
  rc_step step = RC_STEP_INIT;
  step.control = RC_CONTROL_LOAD;
  step.target = guess;
  double slope = 1, last_area = 0, last_load = 0;  // slope: d log load / d log area
  rc_result result{};
  for (int solves = 0; solves < most_solves; ++solves) {
    step.gap = solves == 0 ? gap.data() : nullptr;
    result = contact.solve(step);
    const double found = static_cast<double>(result.contacts) / static_cast<double>(result.points);
    if (std::abs(found / area - 1) <= near_enough) break;
    if (last_area > 0 && found != last_area)
      slope = std::clamp(std::log(step.target / last_load) / std::log(found / last_area), 0.5, 3.0);
    last_area = found;
    last_load = step.target;
    step.target *= std::pow(area / found, slope);
  }
  return {{"load", result.load}, {"displacement", result.displacement}};
}

// One row: a cold solve from a fresh process, its peak memory, then the product on the same trial set.
Json measure_solve(const ScalingRequest& request, std::int64_t n, rc_step step) {
  const double memory_before = peak_memory();
  const Field gap = self_affine_gap(n, surface_of(request));
  step.gap = gap.data();
  const rc_system system = unit_square(n);
  Field pressure(gap.size());
  const TimedSolve timed = time_solve(system, step, options_of(request, request.tol), request.budget, pressure.data());
  const double peak = peak_memory();
  step.control = RC_CONTROL_DISPLACEMENT;
  step.target = timed.result.displacement;
  ProductSetup setup;
  setup.backend = timed.result.backend;
  setup.threads = request.threads;
  setup.budget = request.budget / 4;
  const CallTimes product = time_products(system, step, setup);

  const double points = static_cast<double>(timed.result.points);
  Json row = record_of(timed.result);
  row["area_found"] = static_cast<double>(timed.result.contacts) / points;
  row["setup_seconds"] = timed.setup_seconds;
  row["cpu_seconds"] = timed.cpu_seconds;
  row["repeats"] = timed.repeats;
  row["product_seconds_best"] = product.best;
  row["product_seconds_median"] = product.median;
  row["product_count"] = product.count;
  row["peak_bytes"] = peak;
  row["bytes_per_point"] = (peak - memory_before) / points;
  return row;
}

Json measure_row(const ScalingRequest& request, std::int64_t n, double area, const char* control, rc_step step) {
  Json row = {{"n", n},
              {"area_wanted", area},
              {"control", control},
              {"tol", request.tol},
              {"threads", request.threads},
              {"seed", request.seed}};
  row.update(in_child([&] { return measure_solve(request, n, step); }));
  return row;
}

void solve_rows(const ScalingRequest& request, Json& rows) {
  // Bush, Gibson & Thomas (1975): area = sqrt(2 pi) p / (E* rms slope) at light loads; the last grid's answer afterwards.
  std::vector<double> loads;
  for (const double area : request.areas) loads.push_back(area / std::sqrt(2 * std::numbers::pi) * surface_of(request).rms_slope);
  for (const std::int64_t n : request.sizes) {
    for (std::size_t k = 0; k < loads.size(); ++k) {
      const double area = request.areas[k];
      std::cerr << "solving " << n << "^2 at " << 100 * area << " % contact\n";
      const Json found = in_child([&] { return find_load(request, n, area, loads[k]); });
      if (found.contains("error")) throw Failure(found.at("error").get<std::string>());
      loads[k] = found.at("load");

      rc_step step = RC_STEP_INIT;
      step.target = found.at("displacement");
      const Json displacement = measure_row(request, n, area, "displacement", step);
      rows.push_back(displacement);
      step.control = RC_CONTROL_LOAD;
      step.target = displacement.value("load", loads[k]);  // the same problem again
      rows.push_back(measure_row(request, n, area, "load", step));
    }
  }
}

// The library's product on the whole grid against the padded one, in turns, so that other work on the machine meets both.
template <class Real> Json measure_precision(const ScalingRequest& request, std::int64_t n, std::int64_t threads) {
  constexpr int rounds = 5;
  constexpr bool single = std::is_same_v<Real, float>;
  const double budget = request.budget / (4 * rounds);
  const Field gap = self_affine_gap(n, surface_of(request));
  const auto [lowest, highest] = std::minmax_element(gap.begin(), gap.end());
  rc_step step = RC_STEP_INIT;
  step.gap = gap.data();
  step.target = 2 * *highest - *lowest;  // every point is a candidate
  Field y;
  std::vector<Real> x(gap.size()), expected(gap.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<Real>((step.target - gap[i]) / (step.target - *lowest));

  PaddedProductIn<Real> padded_by_estimate(n, static_cast<int>(threads), FFTW_ESTIMATE, request.planning_limit);
  PaddedProductIn<Real> padded_by_measure(n, static_cast<int>(threads), FFTW_MEASURE, request.planning_limit);
  const auto time_ours = [&](const char* planning) {
    return time_products(unit_square(n), step, {"fft", planning, threads, budget, single}, &y);
  };
  const auto time_padded = [&](PaddedProductIn<Real>& product) {
    return time_calls(budget, [&] { product.multiply(x.data(), expected.data()); });
  };
  CallTimes estimate, measure, padded_estimate, padded_measure;
  for (int round = 0; round < rounds; ++round) {
    keep_best(estimate, time_ours("estimate"));
    keep_best(padded_estimate, time_padded(padded_by_estimate));
    keep_best(measure, time_ours("measure"));
    keep_best(padded_measure, time_padded(padded_by_measure));
  }
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    difference = std::max(difference, std::abs(y[i] - static_cast<double>(expected[i])));
    largest = std::max(largest, std::abs(static_cast<double>(expected[i])));
  }
  return {{"estimate_best", estimate.best},
          {"estimate_median", estimate.median},
          {"measure_best", measure.best},
          {"measure_median", measure.median},
          {"padded_estimate_best", padded_estimate.best},
          {"padded_estimate_median", padded_estimate.median},
          {"padded_measure_best", padded_measure.best},
          {"padded_measure_median", padded_measure.median},
          {"padded_measure_planning_seconds", padded_by_measure.planning_seconds()},
          {"ratio_estimate", padded_estimate.best / estimate.best},
          {"ratio_measure", padded_measure.best / measure.best},
          {"ratio", padded_measure.best / estimate.best},
          {"difference", difference / largest}};
}

// Double precision; the keys of single precision begin with "single_".
Json measure_product(const ScalingRequest& request, std::int64_t n, std::int64_t threads) {
  Json row = measure_precision<double>(request, n, threads);
  const Json single = measure_precision<float>(request, n, threads);
  for (const auto& [key, value] : single.items()) row["single_" + key] = value;
  return row;
}

void product_rows(const ScalingRequest& request, Json& rows) {
  std::vector<std::int64_t> threads{1};
  if (request.threads > 1) threads.push_back(request.threads);
  for (const std::int64_t n : request.sizes) {
    for (const std::int64_t t : threads) {
      std::cerr << "products on " << n << "^2, " << t << " threads\n";
      Json row = {{"n", n}, {"threads", t}};
      row.update(in_child([&] { return measure_product(request, n, t); }));
      rows.push_back(row);
    }
  }
}

const std::vector<Column> solve_columns = {{"n", "n"},
                                           {"control", "control"},
                                           {"area", "area_found", "%.4f"},
                                           {"solver", "solver"},
                                           {"backend", "backend"},
                                           {"set-up s", "setup_seconds", "%.4f"},
                                           {"solve s", "solve_seconds", "%.4f"},
                                           {"CPU s", "cpu_seconds", "%.4f"},
                                           {"iterations", "iterations"},
                                           {"products", "products"},
                                           {"product s", "product_seconds_best", "%.5f"},
                                           {"B/point", "bytes_per_point"},
                                           {"candidates", "candidates"},
                                           {"modelled", "modelled"},
                                           {"contacts", "contacts"},
                                           {"primal", "kkt_primal", "%.0e"},
                                           {"dual", "kkt_dual", "%.0e"},
                                           {"compl.", "kkt_complementarity", "%.0e"},
                                           {"load", "kkt_control", "%.0e"},
                                           {"status", "status"}};
const std::vector<Column> product_columns = {{"n", "n"},
                                             {"threads", "threads"},
                                             {"fft, estimated plan", "estimate_best", "%.6f"},
                                             {"fft, measured plan", "measure_best", "%.6f"},
                                             {"padded, estimated", "padded_estimate_best", "%.6f"},
                                             {"padded, measured", "padded_measure_best", "%.6f"},
                                             {"ratio", "ratio", "%.2f"},
                                             {"difference", "difference", "%.0e"},
                                             {"single: fft, estimated", "single_estimate_best", "%.6f"},
                                             {"fft, measured", "single_measure_best", "%.6f"},
                                             {"padded, measured", "single_padded_measure_best", "%.6f"},
                                             {"ratio", "single_ratio", "%.2f"},
                                             {"difference", "single_difference", "%.0e"}};

}  // namespace

Json run_scaling(const ScalingRequest& request) {
  Json products = Json::array(), solves = Json::array();
  product_rows(request, products);
  std::cout << "Product with H over the whole grid [s]; ratio: time of the FFT padded to 2n x 2n with measured plans over that "
               "of backend\n"
            << "fft with estimated ones, in the same precision\n"
            << table(product_columns, products);
  if (request.products_only) return {{"products", products}};
  solve_rows(request, solves);
  std::cout << "\nCold solves to a certified tolerance of " << request.tol << "\n" << table(solve_columns, solves);
  return {{"products", products}, {"solves", solves}};
}

}  // namespace bench
