#include "products.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <type_traits>

#include "library.h"
#include "padded_product.h"
#include "product_timer.h"
#include "scene.h"
#include "table.h"

namespace bench {

namespace {

// The library's product on the whole grid against the padded one, in turns, so that other work on the machine meets both.
template <class Real> Json measure_precision(const ProductsRequest& request, std::int64_t n, std::int64_t threads) {
  constexpr int rounds = 5;
  constexpr bool single = std::is_same_v<Real, float>;
  const double budget = request.budget / (4 * rounds);
  const Field gap = self_affine_gap(n, {.seed = request.seed});
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
Json measure_product(const ProductsRequest& request, std::int64_t n, std::int64_t threads) {
  Json row = measure_precision<double>(request, n, threads);
  const Json single = measure_precision<float>(request, n, threads);
  for (const auto& [key, value] : single.items()) row["single_" + key] = value;
  return row;
}

Json product_rows(const ProductsRequest& request) {
  Json rows = Json::array();
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
  return rows;
}

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

Json run_products(const ProductsRequest& request) {
  const Json products = product_rows(request);
  std::cout << "Product with H over the whole grid [s]; ratio: time of the FFT padded to 2n x 2n with measured plans over that "
               "of backend\n"
            << "fft with estimated ones, in the same precision\n"
            << table(product_columns, products);
  return {{"products", products}};
}

}  // namespace bench
