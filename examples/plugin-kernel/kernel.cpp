// The kernel "layer": an elastic layer, bonded to a half-space of another material, under normal pressure without shear.
//
// A pressure wave exp(i q.x) deflects the half-space by 2/(E* |q|) times itself, and the coated one by f(|q| t) times that, t the
// layer's thickness. With s = |q| t, mu = G1/G2 (1: layer, 2: half-space), Dundurs-like constants
//   lambda = 1 - 4 (1 - nu1) / (1 + mu (3 - 4 nu2)),  kappa = (mu - 1) / (mu + 3 - 4 nu1),
// and e = exp(-2 s),
//   f = E2*/E1* (1 + 4 kappa s e - lambda kappa e^2) / (1 - (lambda + kappa + 4 kappa s^2) e + lambda kappa e^2):
// Burmister (1945); O'Sullivan & King, ASME Journal of Tribology 110 (1988) 235. f goes from 1 at long waves to E2*/E1* at short
// ones.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <roughcontact/plugin.hpp>
#include <vector>

namespace {

constexpr roughcontact::Component component{"layer", "use fewer points"};

class Layer {
 public:
  // In the units of the system: lengths and moduli are 1 there where they are spec.length and spec.modulus for the caller.
  Layer(const rc_host* host, const rc_kernel_spec& spec) {
    const auto option = [&](const char* key) { return roughcontact::option_real(host, spec.options, key); };
    thickness = option("layer.thickness") / spec.length;
    const double modulus = option("layer.modulus") / spec.modulus;
    const double nu1 = option("layer.poisson"), nu2 = option("layer.substrate_poisson");
    softness_ = modulus > 0 ? 1 / modulus : 1;
    const double mu = (1 - nu1) / (1 - nu2) / softness_;  // G = E* (1 - nu) / 2
    lambda_ = 1 - 4 * (1 - nu1) / (1 + mu * (3 - 4 * nu2));
    kappa_ = (mu - 1) / (mu + 3 - 4 * nu1);
  }

  double softness() const { return softness_; }  // E2*/E1*

  double f(double s) const {
    if (s > 300) return softness_;
    const double e = std::exp(-2 * s), product = lambda_ * kappa_ * e * e;
    return softness_ * (1 + 4 * kappa_ * s * e - product) / (1 - (lambda_ + kappa_ + 4 * kappa_ * s * s) * e + product);
  }

  double thickness;

 private:
  double softness_, lambda_, kappa_;
};

// Free boundaries. exp(-|q| z) 2/|q| is the transform of 1/(pi sqrt(r^2 + z^2)), so where f is a sum of exponentials
//   f(s) = E2*/E1* + sum of w_j exp(-s z_j),  sum of w_j = 1 - E2*/E1*,
// the deflection is that of point loads at the depths z_j t: "complex images" as electromagnetics has them, with real depths. The
// weights are fitted; every eigenvalue is then off by at most the misfit, relative to f, and both limits are exact.
class Images {
 public:
  explicit Images(const Layer& layer) {
    depth_.push_back(0);
    weight_.push_back(layer.thickness > 0 ? layer.softness() : 1);
    lowest_ = weight_.front();
    if (layer.thickness > 0) fit(layer);
  }

  double lowest() const { return lowest_; }  // of the fitted f
  double misfit() const { return misfit_; }  // largest, relative to f
  std::size_t size() const { return depth_.size(); }
  double depth(std::size_t j) const { return depth_[j]; }
  double weight(std::size_t j) const { return weight_[j]; }

 private:
  static constexpr int terms = 40, samples = 4 * terms, unknowns = terms - 1;
  static constexpr double shallowest = 0.5, deepest = 300, least_s = 1e-3, most_s = 40, small = 1e-12;

  static double between(double first, double last, int i, int n) { return first * std::pow(last / first, i / (n - 1.0)); }

  // Least squares by Gram and Schmidt's orthogonalisation. The last image takes what the others leave of the sum; rows with a
  // small number on the diagonal keep the weights small, which the exponentials alone hardly determine.
  void fit(const Layer& layer) {
    constexpr int rows = samples + unknowns;
    const double sum = 1 - layer.softness();
    std::array<double, terms> z;
    for (int j = 0; j < terms; ++j) z[j] = between(shallowest, deepest, j, terms);
    std::vector<std::array<double, rows>> column(unknowns + 1);  // the last one is the right-hand side
    for (auto& each : column) each.fill(0);
    for (int i = 0; i < samples; ++i) {
      const double s = between(least_s, most_s, i, samples), last = std::exp(-s * z[unknowns]);
      for (int j = 0; j < unknowns; ++j) column[j][i] = std::exp(-s * z[j]) - last;
      column[unknowns][i] = layer.f(s) - layer.softness() - sum * last;
    }
    for (int j = 0; j < unknowns; ++j) column[j][samples + j] = small;

    std::vector<std::array<double, unknowns + 1>> r(unknowns);
    const auto dot = [](const auto& a, const auto& b) {
      double total = 0;
      for (int i = 0; i < rows; ++i) total += a[i] * b[i];
      return total;
    };
    for (int k = 0; k < unknowns; ++k) {
      r[k][k] = std::sqrt(dot(column[k], column[k]));
      for (double& value : column[k]) value /= r[k][k];
      for (int j = k + 1; j <= unknowns; ++j) {
        r[k][j] = dot(column[k], column[j]);
        for (int i = 0; i < rows; ++i) column[j][i] -= r[k][j] * column[k][i];
      }
    }
    std::array<double, terms> w;
    w[unknowns] = sum;
    for (int k = unknowns - 1; k >= 0; --k) {
      w[k] = r[k][unknowns];
      for (int j = k + 1; j < unknowns; ++j) w[k] -= r[k][j] * w[j];
      w[k] /= r[k][k];
    }
    for (int j = 0; j < unknowns; ++j) w[unknowns] -= w[j];
    for (int j = 0; j < terms; ++j) {
      depth_.push_back(z[j] * layer.thickness);
      weight_.push_back(w[j]);
    }
    compare(layer, z, w);
  }

  void compare(const Layer& layer, const std::array<double, terms>& z, const std::array<double, terms>& w) {
    constexpr int looks = 1000;
    lowest_ = std::min(1.0, layer.softness());
    for (int i = 0; i < looks; ++i) {
      const double s = between(1e-4, 100, i, looks), wanted = layer.f(s);
      double fitted = layer.softness();
      for (int j = 0; j < terms; ++j) fitted += w[j] * std::exp(-s * z[j]);
      lowest_ = std::min(lowest_, fitted);
      misfit_ = std::max(misfit_, std::abs(fitted - wanted) / wanted);
    }
  }

  std::vector<double> depth_, weight_;
  double lowest_ = 0, misfit_ = 0;
};

// The mean of 1/R over two rectangles of sides a and b, z above each other, whose centres are x and y apart.
//
// Near by, it is the second difference in x and in y of a function G with G_xxyy = 1/R: Ruehli & Brennan, IEEE Transactions on
// Microwave Theory and Techniques 21 (1973) 76. Farther away the differences cancel, and four points along each axis do, which
// have the second, fourth and sixth moments of the distance between two uniformly distributed points.
class MeanInverseDistance {
 public:
  MeanInverseDistance(double a, double b) : a_(a), b_(b), near_(12 * std::max(a, b)) {}

  bool near(double x, double y, double z) const { return x * x + y * y + z * z < near_ * near_; }

  double closed(double x, double y, double z) const {
    constexpr std::array<double, 3> difference{1, -2, 1};
    double sum = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) sum += difference[i] * difference[j] * potential(x + (i - 1) * a_, y + (j - 1) * b_, z);
    return sum / (a_ * a_ * b_ * b_);
  }

  // Adds weight times the mean for x = a first, a (first + 1) ...
  void add_far(double weight, std::int64_t first, double y, double z, std::int64_t n, double* out) const {
    // The squares of the points are the roots of u^2 - 31/49 u + 19/490.
    const double root = std::sqrt(31.0 * 31 / 49 / 49 - 4 * 19.0 / 490), outer = (31.0 / 49 + root) / 2, inner = outer - root;
    const double share = (1.0 / 6 - inner) / root / 2, u = std::sqrt(outer), v = std::sqrt(inner);
    const std::array<double, 4> at{-u, -v, v, u}, part{share, 0.5 - share, 0.5 - share, share};
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        const double across = y + at[j] * b_, square = across * across + z * z, shift = at[i] * a_;
        const double strength = weight * part[i] * part[j];
        for (std::int64_t k = 0; k < n; ++k) {
          const double along = static_cast<double>(first + k) * a_ + shift;
          out[k] += strength / std::sqrt(along * along + square);
        }
      }
  }

 private:
  static double potential(double x, double y, double z) {
    const double square = x * x + y * y + z * z, r = std::sqrt(square);
    if (r == 0) return 0;
    const auto term = [z](double u, double v) {
      const double across = std::sqrt(v * v + z * z);
      return across > 0 ? (v * v - z * z) / 2 * u * std::asinh(u / across) : 0;
    };
    const double twist = z > 0 ? x * y * z * std::atan(x * y / (z * r)) : 0;
    return term(x, y) + term(y, x) - (square - 3 * z * z) * r / 6 - twist;
  }

  double a_, b_, near_;
};

rc_status window(const rc_host* host, const rc_kernel_spec* spec, std::int64_t first_x, std::int64_t first_y, std::int64_t mx,
                 std::int64_t my, double* out) {
  return roughcontact::guard(host, component, [&] {
    constexpr double largest_misfit = 1e-6;
    const Images images{Layer(host, *spec)};
    if (images.misfit() > largest_misfit)
      roughcontact::fail(component, RC_ERR_INCOMPATIBLE,
                         "the layer is too unlike its half-space for free boundaries: the fit of its ", "response is off by ",
                         images.misfit(), ", more than ", largest_misfit, "; use periodic ones");
    const double a = spec->system->hx, b = spec->system->hy;
    const MeanInverseDistance mean(a, b);
    for (std::int64_t iy = 0; iy < my; ++iy) {
      double* const row = out + iy * mx;
      const double y = b * static_cast<double>(first_y + iy);
      std::fill_n(row, mx, 0.0);
      for (std::size_t j = 0; j < images.size(); ++j) {
        const double z = images.depth(j), weight = images.weight(j) * a * b / std::numbers::pi;
        std::int64_t ix = 0;
        for (; ix < mx; ++ix) {
          const double at = a * static_cast<double>(first_x + ix);
          if (!mean.near(at, y, z)) break;
          row[ix] += weight * mean.closed(at, y, z);
        }
        mean.add_far(weight, first_x + ix, y, z, mx - ix, row + ix);
      }
    }
  });
}

rc_status symbol(const rc_host* host, const rc_kernel_spec* spec, double* out) {
  return roughcontact::guard(host, component, [&] {
    const Layer layer(host, *spec);
    const rc_system& s = *spec->system;
    const double step_x = 2 * std::numbers::pi / (static_cast<double>(s.nx) * s.hx),
                 step_y = 2 * std::numbers::pi / (static_cast<double>(s.ny) * s.hy);
    for (std::int64_t ky = 0; ky <= s.ny / 2; ++ky)
      for (std::int64_t kx = 0; kx <= s.nx / 2; ++kx) {
        const double q = std::hypot(step_x * static_cast<double>(kx), step_y * static_cast<double>(ky));
        *out++ = q > 0 ? 2 / q * layer.f(q * layer.thickness) : 0;
      }
  });
}

// The kernel galerkin has f = 1, so the least f is a share of it. Between the points looked at, f is less by far less than 1e-3.
rc_status bounds(const rc_host* host, const rc_kernel_spec* spec, rc_kernel_bounds* out) {
  return roughcontact::guard(host, component, [&] {
    if (spec->system->boundary == RC_BOUNDARY_FREE)
      out->galerkin_share = std::max(0.0, (1 - 1e-3) * Images{Layer(host, *spec)}.lowest());
  });
}

constexpr rc_option_spec real_option(const char* key, const char* value, double maximum, const char* help) {
  return {.struct_size = sizeof(rc_option_spec),
          .key = key,
          .default_value = value,
          .help = help,
          .type = RC_TYPE_REAL,
          .minimum = 0,
          .maximum = maximum};
}

const rc_option_spec thickness = real_option("layer.thickness", "0", 1e30, "of the layer [length]; 0: there is none"),
                     modulus = real_option("layer.modulus", "0", 1e30,
                                           "E1/(1-nu1^2) of the layer [force/length^2]; 0: that of the half-space"),
                     poisson = real_option("layer.poisson", "0.3", 0.5, "Poisson's ratio of the layer"),
                     substrate = real_option("layer.substrate_poisson", "0.3", 0.5, "Poisson's ratio of the half-space");
const rc_option_spec* const options[] = {&thickness, &modulus, &poisson, &substrate};

const rc_kernel kernel = {.struct_size = sizeof(rc_kernel),
                          .name = "layer",
                          .summary = "elastic layer bonded to a half-space of modulus E*, against a rigid surface",
                          .license = "BSD-3-Clause",
                          .caps = RC_KERNEL_FREE | RC_KERNEL_PERIODIC,
                          .n_options = 4,
                          .options = options,
                          .window = window,
                          .symbol = symbol,
                          .bounds = bounds};
const rc_kernel* const kernels[] = {&kernel};
const rc_plugin plugin = {.struct_size = sizeof(rc_plugin),
                          .abi_major = RC_PLUGIN_ABI_MAJOR,
                          .abi_minor = RC_PLUGIN_ABI_MINOR,
                          .name = "layer",
                          .version = "1.0",
                          .n_kernels = 1,
                          .kernels = kernels};

}  // namespace

RC_PLUGIN_ENTRY(layer, , out) {
  *out = &plugin;
  return RC_OK;
}
