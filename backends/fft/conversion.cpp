#include "conversion.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rc_fft {

namespace {

struct Sums {
  double sum = 0, largest = 0;
};

// Sums in an order that does not depend on the threads.
Sums sums_of(const rc_team& team, std::int64_t n, const double* x) {
  constexpr std::int64_t block = 8192, lanes = 8;
  const std::int64_t blocks = (n + block - 1) / block;
  std::vector<Sums> parts(static_cast<std::size_t>(blocks));
  roughcontact::for_each(team, blocks, blocks > 8, [&](std::int64_t item, std::int64_t) {
    double sum[lanes] = {}, largest[lanes] = {};
    const std::int64_t end = std::min((item + 1) * block, n);
    std::int64_t i = item * block;
    for (; i + lanes <= end; i += lanes)
      for (std::int64_t lane = 0; lane < lanes; ++lane) {
        sum[lane] += x[i + lane];
        largest[lane] = std::max(largest[lane], std::abs(x[i + lane]));
      }
    for (; i < end; ++i) {
      sum[0] += x[i];
      largest[0] = std::max(largest[0], std::abs(x[i]));
    }
    Sums& part = parts[static_cast<std::size_t>(item)];
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
      part.sum += sum[lane];
      part.largest = std::max(part.largest, largest[lane]);
    }
  });
  Sums total;
  for (const Sums& part : parts) {
    total.sum += part.sum;
    total.largest = std::max(total.largest, part.largest);
  }
  return total;
}

double unit_of(double largest) {
  constexpr int most = 1000;  // its reciprocal is finite as well
  return largest > 0 && std::isfinite(largest) ? std::ldexp(1.0, std::clamp(std::ilogb(largest), -most, most)) : 1.0;
}

}  // namespace

Conversion conversion_of(const rc_team& team, std::int64_t n, const double* x) {
  return {0, unit_of(sums_of(team, n, x).largest), 0};
}

Conversion conversion_of(const rc_team& team, std::int64_t n, const double* x, double zero_mode, std::int64_t points) {
  const Sums sums = sums_of(team, n, x);
  const double mean = sums.sum / static_cast<double>(points);
  return {mean, unit_of(sums.largest), zero_mode * mean};
}

}  // namespace rc_fft
