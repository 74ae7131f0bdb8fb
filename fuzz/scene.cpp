#include "scene.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace fuzz {

namespace {

constexpr std::size_t most_points = 64, most_options = 8;
constexpr int most_threads = 3;

// mantissa 10^exponent: most numbers are near 1, some come from the whole range of double.
double magnitude(Bytes& bytes) {
  const int mantissa = bytes.byte();
  if (mantissa == 0) return 1;
  const int exponent = bytes.whole();
  const double scale = mantissa % 16 == 0 ? 2.4 : 1.0 / 32;  // 10^+-307, or 10^+-4
  return (1 + mantissa / 256.0) * std::pow(10.0, std::trunc(exponent * scale));
}

int apply(const double* x, double* y, std::int64_t n, void* user) {
  Scene& scene = *static_cast<Scene*>(user);
  if (++scene.products == scene.fails_at) return 1;
  for (std::int64_t i = 0; i < n; ++i) {
    y[i] = 0;
    for (std::int64_t j = 0; j < n; ++j) y[i] += scene.matrix[static_cast<std::size_t>(i * n + j)] * x[j];
  }
  return 0;
}

// Symmetric: positive definite with a condition number that a byte chooses, or whatever the bytes say.
void read_matrix(Bytes& bytes, Scene& scene) {
  const std::size_t n = scene.points(), kind = bytes.below(4);
  scene.matrix.assign(n * n, 0.0);
  const auto at = [&](std::size_t i, std::size_t j) -> double& { return scene.matrix[i * n + j]; };
  if (kind == 0) {  // decays with the distance along a line
    const double decay = 0.05 + bytes.byte() / 64.0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) at(i, j) = std::exp(-decay * std::abs(static_cast<double>(i) - static_cast<double>(j)));
  } else if (kind == 3) {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j <= i; ++j) at(i, j) = at(j, i) = bytes.whole() / 16.0 + (i == j ? 4 : 0);
  } else {  // B B' + epsilon I with a few columns B, of either sign or positive
    const double epsilon = std::pow(10.0, -static_cast<int>(bytes.below(10)));
    Reals column(n);
    for (std::size_t count = 1 + bytes.below(4); count > 0; --count) {
      for (double& value : column) value = kind == 1 ? bytes.whole() / 32.0 : bytes.byte() / 64.0;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) at(i, j) += column[i] * column[j];
    }
    for (std::size_t i = 0; i < n; ++i) at(i, i) += epsilon;
  }
  const double unit = magnitude(bytes);
  for (double& value : scene.matrix) value *= unit;
}

void read_options(Bytes& bytes, Scene& scene) {
  while (!bytes.empty()) {
    const std::string line{bytes.until('\n')};
    if (line.empty()) return;
    if (line.find('\0') != std::string::npos) continue;
    const auto equals = line.find('=');
    if (equals == std::string::npos || scene.options.size() == most_options) continue;
    const std::string key = line.substr(0, equals), value = line.substr(equals + 1);
    if (key == "hardness") {
      std::from_chars(value.data(), value.data() + value.size(), scene.system.hardness);
      continue;
    }
    int threads = 0;
    std::from_chars(value.data(), value.data() + value.size(), threads);
    if (key != RC_OPT_THREADS || threads <= most_threads) scene.options.emplace_back(key, value);
  }
}

double special(std::size_t which) {
  constexpr double values[] = {std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(),
                               1e308,
                               0,
                               -std::numeric_limits<double>::infinity(),
                               1e6,
                               1e12,
                               5e-324};
  return values[which];
}

}  // namespace

std::string Scene::option(const std::string& key, const std::string& otherwise) const {
  std::string value = otherwise;
  for (const auto& [each, text] : options) {
    if (each == key) value = text;
  }
  return value;
}

void read_scene(Bytes& bytes, Scene& scene) {
  read_options(bytes, scene);
  rc_system& s = scene.system;
  const std::size_t kind = bytes.below(8);  // most systems are half-space grids
  s.op = kind == 6 ? RC_OPERATOR_DENSE : kind == 7 ? RC_OPERATOR_CALLBACK : RC_OPERATOR_HALFSPACE;
  s.boundary = kind < 3 ? RC_BOUNDARY_FREE : RC_BOUNDARY_PERIODIC;
  s.nx = static_cast<std::int64_t>(1 + bytes.below(16));
  s.ny = static_cast<std::int64_t>(1 + bytes.below(most_points / static_cast<std::size_t>(s.nx)));
  if (bytes.flag()) std::swap(s.nx, s.ny);
  s.hx = magnitude(bytes);
  s.hy = bytes.flag() ? magnitude(bytes) : s.hx;
  s.modulus = magnitude(bytes);
  scene.height = magnitude(bytes);
  if (s.op == RC_OPERATOR_HALFSPACE) {
    s.hardness *= s.modulus * scene.height / std::sqrt(s.hx * s.hy);
    return;
  }
  read_matrix(bytes, scene);
  s.hardness *= scene.height / std::abs(scene.matrix.front());
  if (s.op == RC_OPERATOR_DENSE) {
    s.dense = scene.matrix.data();
    s.dense_ld = s.nx * s.ny;
  } else {
    s.apply = apply;
    s.user = &scene;
    const int at = bytes.byte();
    scene.fails_at = at < 32 ? at : 0;
  }
}

void read_step(Bytes& bytes, const Scene& scene, const Last& last, bool keeps_gap, Step& step) {
  const std::size_t n = scene.points();
  const unsigned flags = bytes.byte();
  step.given.control = (flags & 1) != 0 ? RC_CONTROL_LOAD : RC_CONTROL_APPROACH;
  step.given.warm_start = (flags & 2) != 0 ? 0 : 1;
  step.given.borrow = (flags & 4) != 0 ? 1 : 0;
  double lowest = 0, mean = 0;
  if (!keeps_gap || (flags & 8) == 0) {
    const double offset = (flags & 16) != 0 ? scene.height * 1e4 * bytes.whole() : 0;
    const std::size_t which = bytes.below(8);
    step.undeformed_gap.resize(n);
    lowest = std::numeric_limits<double>::infinity();
    for (double& value : step.undeformed_gap) {
      const int whole = bytes.whole();
      value = whole == -128 ? special(which) : scene.height * (whole / 16.0) + offset;
      if (value < lowest) lowest = value;
      if (std::isfinite(value)) mean += value / static_cast<double>(n);
    }
    step.given.undeformed_gap.data = step.undeformed_gap.data();
  }
  if ((flags & 32) != 0) {
    step.mask.resize(n);
    for (std::size_t i = 0; i < n; i += 8) {
      const unsigned bits = bytes.byte();
      for (std::size_t k = i; k < std::min(i + 8, n); ++k) step.mask[k] = (bits >> (k - i) & 1) == 0;
    }
    step.given.mask.data = step.mask.data();
  }
  if ((flags & 64) != 0) {
    const double unit = magnitude(bytes);
    step.start.resize(n);
    for (double& value : step.start) value = unit * bytes.whole();
    step.given.p0.data = step.start.data();
  }
  const double part = bytes.whole() / 16.0 + bytes.byte() / 4096.0;
  const std::size_t from = bytes.below(8);
  if (step.given.control == RC_CONTROL_LOAD) {
    const rc_system& s = scene.system;
    const double unit = s.op == RC_OPERATOR_HALFSPACE ? s.modulus * std::sqrt(s.hx * s.hy) * scene.height : s.hx * s.hy;
    step.given.target = from == 0 ? last.load * (1 + part) : (from == 1 ? 1e6 : from == 2 ? 1e-6 : 1) * part * unit;
  } else {
    // Above the lowest point, around an approach before, or just below the mean plane.
    const double closeness = std::pow(10.0, -static_cast<double>(bytes.below(16)));
    step.given.target = from == 0   ? last.approach + part * scene.height
                        : from == 1 ? mean - std::abs(part) * scene.height * closeness
                        : from == 2 ? lowest + part * scene.height * closeness
                                    : lowest + part * scene.height;
  }
}

rc_options* make_options(const Scene& scene) {
  rc_options* options = nullptr;
  if (rc_options_create(nullptr, &options) != RC_OK) return nullptr;
  for (const auto& [key, value] : scene.options) rc_options_set_text(options, key.c_str(), value.c_str());
  return options;
}

}  // namespace fuzz
