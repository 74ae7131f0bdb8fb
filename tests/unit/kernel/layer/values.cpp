// The numbers that the kernel gives, against an independent solution of the layered problem and against its limits.
#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>

#include "kernel/layer/component.h"
#include "layer.h"
#include "support/unit_system.h"

namespace layer {

namespace {

// A host that knows this layer's options and nothing else.
class Kernel : rc_host {
 public:
  explicit Kernel(const Layer& layer, double hx = 1, double hy = 1) : rc_host{} {
    values_ = {{"layer.thickness", layer.thickness},
               {"layer.modulus", layer.modulus},
               {"layer.poisson", layer.poisson},
               {"layer.substrate_poisson", layer.substrate}};
    choices_ = {{"layer.base", layer.base}, {"layer.interface", layer.interface}};
    struct_size = sizeof(rc_host);
    option_real = [](const rc_host* host, const rc_options*, const char* key, double* out) {
      *out = static_cast<const Kernel*>(host)->values_.at(key);
      return rc_status{RC_OK};
    };
    option_text = [](const rc_host* host, const rc_options*, const char* key, const char** out) {
      *out = static_cast<const Kernel*>(host)->choices_.at(key);
      return rc_status{RC_OK};
    };
    fail = [](const rc_host*, rc_status code, const char* message) {
      print_message("%s\n", message);
      return code;
    };
    system_.hx = hx;
    system_.hy = hy;
  }

  std::vector<double> window(std::int64_t first_x, std::int64_t first_y, std::int64_t mx, std::int64_t my) const {
    std::vector<double> out(static_cast<std::size_t>(mx * my));
    const rc_kernel_spec asked = spec(system_);
    assert_int_equal(kernel_->window(this, &asked, first_x, first_y, mx, my, out.data()), RC_OK);
    return out;
  }
  rc_status window_status() const {
    double out = 0;
    const rc_kernel_spec asked = spec(system_);
    return kernel_->window(this, &asked, 0, 0, 1, 1, &out);
  }
  double wave(double q) const {  // of a wave along x
    rc_system system = system_;
    system.nx = 2;
    system.hx = pi / q;
    system.boundary = RC_BOUNDARY_PERIODIC;
    const rc_kernel_spec asked = spec(system);
    double out[2];
    assert_int_equal(kernel_->symbol(this, &asked, out), RC_OK);
    return out[1];
  }
  struct Bounds {
    double lowest = 0, galerkin_share = 0;
  };
  Bounds bounds() const {
    Bounds out;
    const rc_kernel_spec asked = spec(system_);
    assert_int_equal(kernel_->bounds(this, &asked, &out.lowest, &out.galerkin_share), RC_OK);
    return out;
  }

 private:
  rc_kernel_spec spec(const rc_system& system) const { return {sizeof(rc_kernel_spec), kernel_, &system, nullptr, 1, 1}; }

  std::map<std::string, double> values_;
  std::map<std::string, const char*> choices_;
  const rc_kernel* kernel_ = &rc::kernel::layer::component;
  rc_system system_ = support::unit_system();
};

const Layer layers[] = {{1, 0.1},
                        {1, 0.5},
                        {1, 1, 0.2, 0.45},
                        {1, 2},
                        {1, 10},
                        {1, 0.1, 0, 0.5},
                        {1, 0.3, 0.45},
                        {1, 10, 0, 0.5},
                        {1, 10, 0.5, 0},
                        {1, 3, 0.1, 0.4},
                        {1, 3, 0.3, 0.3, "half-space", "frictionless"},
                        {1, 0.2, 0.1, 0.4, "half-space", "frictionless"},
                        {1, 1, 0.3, 0.3, "rigid"},
                        {1, 2, 0.5, 0.3, "rigid"},
                        {1, 1, 0.3, 0.3, "rigid", "frictionless"}};

void assert_near(double value, double wanted, double tolerance, const char* what) {
  if (!(std::abs(value - wanted) <= tolerance * std::abs(wanted))) fail_msg("%s: %.15g instead of %.15g", what, value, wanted);
}

void thin_and_thick_layers_are_half_spaces(void**) {
  for (const double modulus : {0.1, 10.0})
    for (const double q : {0.1, 1.0, 3.0}) {
      assert_near(Kernel({1e-9, modulus}).wave(q), 2 / q, 1e-7, "thin, symbol");
      assert_near(Kernel({1e3, modulus}).wave(q), 2 / q / modulus, 1e-9, "thick, symbol");
    }
  std::vector<double> galerkin(8 * 8);
  assert_int_equal(rc_kernel_coefficients("galerkin", 1, 1, 8, 8, galerkin.data()), RC_OK);
  for (const double modulus : {0.1, 1.0, 10.0}) {
    const std::vector<double> thin = Kernel({1e-9, modulus}).window(0, 0, 8, 8),
                              thick = Kernel({1e8, modulus}).window(0, 0, 8, 8);
    for (std::size_t i = 0; i < galerkin.size(); ++i) {
      assert_near(thin[i], galerkin[i], 1e-6, "thin");
      assert_near(thick[i], galerkin[i] / modulus, 1e-6, "thick");
    }
  }
}

// A long wave compresses a layer on a rigid base like a column that cannot widen: K. L. Johnson, Contact Mechanics (1985),
// section 5.8: delta = p t (1 - 2 nu) / (1 - nu)^2 (1 - nu^2) / E.
void a_layer_on_a_rigid_base_is_a_bed_of_springs(void**) {
  for (const double nu : {0.0, 0.2, 0.3, 0.4}) {
    assert_near(Kernel({1, 1, nu, 0.3, "rigid"}).wave(1e-2), (1 - 2 * nu) / (1 - nu) / (1 - nu), 1e-3, "spring");
  }
}

// The pressures under a flat punch on a half-space, with the transform sin(q a)/(q a), give the change of its compliance to first
// order: by df is (2/pi) times the integral of df (sin(x)/x)^2 over x = q a.
double punch_stiffness(const Layer& layer) {
  constexpr int steps = 30000;  // Simpson's rule, up to s = 30 at least
  const double step = 30 / std::min(1.0, layer.thickness) / steps;
  const Kernel kernel(layer);
  double sum = 0;
  for (int i = 1; i <= steps; ++i) {
    const double x = i * step, beyond = kernel.wave(x) * x / 2 - 1 / layer.modulus;
    sum += (i == steps ? 1 : i % 2 == 1 ? 4 : 2) * beyond * std::pow(std::sin(x) / x, 2);
  }
  sum += 1 - 1 / layer.modulus;  // at x = 0
  return 1 / (1 / layer.modulus + 2 / pi * sum * step / 3);
}

void a_flat_punch_feels_the_published_share_of_the_layer(void**) {
  constexpr double little = 1e-3;
  for (const double xi : {0.1, 0.3, 1.0, 3.0, 10.0})
    for (const double nu : {0.1, 0.3, 0.45}) {
      const double stiffer = punch_stiffness({xi, 1 + little, nu, nu}), softer = punch_stiffness({xi, 1 - little, nu, nu});
      assert_near((stiffer - softer) / (2 * little), gao_modulus_share(xi, nu), 1e-5, "I0");
      // The same shear modulus: E/(1 - nu^2) = 2 mu/(1 - nu).
      const auto poisson = [&](double layer) { return 1 - (1 - nu) / punch_stiffness({xi, (1 - nu) / (1 - layer), layer, nu}); };
      assert_near((poisson(nu + little) - poisson(nu - little)) / (2 * little), gao_poisson_share(xi), 1e-4, "I1");
    }
}

// A cell of twice the side is four of the smaller ones. This crosses from the closed form to the points of the far field.
void cells_add_up(void**) {
  for (const double thickness : {0.02, 0.3, 4.0, 60.0})
    for (const double modulus : {0.2, 5.0}) {
      const std::vector<double> fine = Kernel({thickness, modulus}).window(0, 0, 80, 80),
                                coarse = Kernel({thickness, modulus}, 2, 2).window(0, 0, 39, 39);
      for (const int x : {0, 1, 3, 6, 11, 12, 30})
        for (const int y : {0, 2, 7, 13, 38}) {
          double sum = 0;
          for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
              sum += (i == 0 ? 2 : 1) * (j == 0 ? 2 : 1) * 0.25 *
                     fine[static_cast<std::size_t>(std::abs(2 * y + j) * 80 + std::abs(2 * x + i))];
          assert_near(coarse[static_cast<std::size_t>(y * 39 + x)], sum, 1e-10, "four cells");
        }
    }
}

// A value depends on its offset alone.
void windows_agree(void**) {
  const Kernel kernel({3, 0.3});
  const std::vector<double> whole = kernel.window(0, 0, 40, 40), part = kernel.window(7, 5, 20, 20);
  for (std::size_t i = 0; i < part.size(); ++i) assert_true(part[i] == whole[(5 + i / 20) * 40 + 7 + i % 20]);
}

void what_it_promises_holds(void**) {
  constexpr int side = 9;
  std::vector<double> galerkin(side * side);
  assert_int_equal(rc_kernel_coefficients("galerkin", 1, 1, side, side, galerkin.data()), RC_OK);
  const auto matrix = [](const std::vector<double>& k) {
    constexpr int n = side * side;
    Eigen::MatrixXd h(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        h(i, j) = k[static_cast<std::size_t>(std::abs(i / side - j / side) * side + std::abs(i % side - j % side))];
    return h;
  };
  const Eigen::MatrixXd g = matrix(galerkin);
  for (const Layer& each : layers)
    for (const double thickness : {0.05, 1.0, 5.0}) {
      Layer layer = each;
      layer.thickness = thickness;
      const Kernel kernel(layer);
      const Eigen::MatrixXd h = matrix(kernel.window(0, 0, side, side));
      const double least = Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(h, g).eigenvalues()[0];
      const Kernel::Bounds promised = kernel.bounds();
      if (!(promised.galerkin_share <= least)) fail_msg("share %g, least %g", promised.galerkin_share, least);
      assert_true(promised.galerkin_share > 0 || std::string(layer.base) == "rigid");
      const double lowest = h.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff();
      if (!(0 < promised.lowest && promised.lowest <= lowest)) fail_msg("lowest %g, %g found", promised.lowest, lowest);
    }
}

void coefficients_are_those_of_the_reference(void**) {
  const Checks found = check_rows(RC_LAYER_REFERENCE, 1e-10);
  assert_true(found.rows >= 100 && found.beyond == 0);
}

void what_loses_digits_is_refused(void**) {
  for (const Layer& each :
       {Layer{0, 1}, Layer{1e-10, 1}, Layer{1e10, 1}, Layer{1e-5, 1, 0.3, 0.3, "rigid"}, Layer{1, 1e-7}, Layer{1, 2e6}})
    assert_int_equal(Kernel(each).window_status(), RC_ERR_ARGUMENT);
}

// Next to the limits: positive on the diagonal and no larger elsewhere.
void coefficients_near_the_limits_are_sound(void**) {
  for (const Layer& each : {Layer{1e-9, 1e-6}, Layer{1e-9, 1e6}, Layer{1e9, 1e-6}, Layer{1, 1e6}, Layer{1, 1e-6, 0.5},
                            Layer{1e-4, 1, 0.5, 0.3, "rigid"}, Layer{1e-4, 1, 0, 0.3, "rigid", "frictionless"}}) {
    const std::vector<double> values = Kernel(each, 1, 0.1).window(0, 0, 20, 20);
    assert_true(values[0] > 0);
    for (const double value : values) assert_true(std::abs(value) <= values[0]);
  }
}

}  // namespace

Checks check_rows(const char* name, double tolerance) {
  std::ifstream file(name);
  Checks checks;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream in(line);
    Layer layer{};
    std::string base, interface;
    double hx, hy, wanted;
    std::int64_t x, y;
    in >> layer.thickness >> layer.modulus >> layer.poisson >> layer.substrate >> base >> interface >> hx >> hy >> x >> y >>
        wanted;
    assert_false(in.fail());
    layer.base = base.c_str();
    layer.interface = interface.c_str();
    const Kernel kernel(layer, hx, hy);
    const double largest = kernel.window(0, 0, 1, 1)[0], found = kernel.window(x, y, 1, 1)[0];
    const double error = std::abs(found - wanted) / largest;
    if (!(error <= tolerance)) {
      print_message("%s: %.17g\n", line.c_str(), found);
      ++checks.beyond;
    }
    checks.worst = std::max(checks.worst, error);
    ++checks.rows;
  }
  return checks;
}

double gao_modulus_share(double xi, double poisson) {
  const double square = xi * xi;
  return 2 / pi * std::atan(xi) +
         ((1 - 2 * poisson) * xi * std::log1p(1 / square) - xi / (1 + square)) / (2 * pi * (1 - poisson));
}
double gao_poisson_share(double xi) { return 2 / pi * std::atan(xi) + xi / pi * std::log1p(1 / (xi * xi)); }

const std::vector<CMUnitTest> value_tests = {
    cmocka_unit_test(thin_and_thick_layers_are_half_spaces),
    cmocka_unit_test(a_layer_on_a_rigid_base_is_a_bed_of_springs),
    cmocka_unit_test(a_flat_punch_feels_the_published_share_of_the_layer),
    cmocka_unit_test(cells_add_up),
    cmocka_unit_test(windows_agree),
    cmocka_unit_test(what_it_promises_holds),
    cmocka_unit_test(coefficients_are_those_of_the_reference),
    cmocka_unit_test(what_loses_digits_is_refused),
    cmocka_unit_test(coefficients_near_the_limits_are_sound),
};

}  // namespace layer
