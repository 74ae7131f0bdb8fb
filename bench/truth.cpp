#include "truth.h"

#include <cmath>

namespace bench {

RelativeErrors errors_against(const Truth& truth, const Field& pressure, double load, double area) {
  double difference = 0, square = 0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    difference += (pressure[i] - truth.pressure[i]) * (pressure[i] - truth.pressure[i]);
    square += truth.pressure[i] * truth.pressure[i];
  }
  return {std::abs(load / truth.load - 1), std::abs(area / truth.area - 1), std::sqrt(difference / square)};
}

Field block_means(const Field& values, std::int64_t fine, std::int64_t n) {
  const std::int64_t ratio = fine / n;
  if (ratio == 1) return values;
  Field means(static_cast<std::size_t>(n * n));
  for (std::int64_t iy = 0; iy < fine; ++iy) {
    const double* const row = values.data() + iy * fine;
    double* const mean = means.data() + iy / ratio * n;
    for (std::int64_t ix = 0; ix < fine; ++ix) mean[ix / ratio] += row[ix];
  }
  for (double& mean : means) mean /= static_cast<double>(ratio * ratio);
  return means;
}

}  // namespace bench
