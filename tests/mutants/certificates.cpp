#include <limits>

#include "contact/proof/certificate.h"
#include "core/certificate_terms.h"
#include "known_answers.h"
#include "problems.h"

namespace mutants {

void figures_of_certificates(Figures& figures) {
  const auto put = [&figures](const std::string& name, const Small& small, double scale) {
    const rc::Certificate c =
        certify(small.surface(), small.compression, small.answer, small.survey(), scale, std::numeric_limits<double>::infinity());
    figures.section("certificate/" + name);
    figures.exact("primal", c.primal);
    figures.exact("dual", c.dual);
    figures.exact("complementarity", c.complementarity);
    figures.exact("control", c.control);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  Small small(5, 4);
  for (const double off : {0.4, 1e-3, 0.0})
    for (const double scale : {0.4, 7.0, 0.0, -1.0}) {
      small.press(0.4, off, 1);
      const std::string name = std::to_string(off) + "/" + std::to_string(scale);
      put(name, small, scale);
      small.answer.pressures.p[3] = -0.3;
      small.answer.pressures.p[4] = 1e-4;
      small.answer.product[4] += 5;
      put(name + "/negative", small, scale);
      for (double& p : small.answer.pressures.p) p = -p;
      put(name + "/reversed", small, scale);
      for (double& p : small.answer.pressures.p) p = 0;
      put(name + "/none", small, scale);
      small.press(0.4, off, 1);
      small.mask.assign(small.points(), 1);
      small.mask[2] = small.mask[7] = 0;
      small.answer.pressures.p[2] = nan;
      put(name + "/nan_under_a_mask", small, scale);
      small.answer.pressures.p[2] = 9;
      put(name + "/mask", small, scale);
      small.mask.clear();
      for (const double strange : {nan, infinite}) {
        small.press(0.4, off, 1);
        small.answer.pressures.p[6] = strange;
        put(name + "/strange_pressure", small, scale);
        small.press(0.4, off, 1);
        small.answer.product[6] = strange;
        put(name + "/strange_product", small, scale);
        small.answer.pressures.p[6] = 0;
        put(name + "/strange_product_without_pressure", small, scale);
      }
      small.press(0.4, off, 1);
      small.list({1, 4, 9, 10}, infinite);
      put(name + "/listed", small, scale);
    }
  small.list({}, infinite);
  put("nothing_listed", small, 0.4);
  figures.section("within");
  for (int bad = -1; bad < 4; ++bad)
    for (const double value : {1e-6, 1e-7, nan}) {
      rc::Certificate c{1e-8, 1e-8, 1e-8, 1e-8};
      (bad == 0 ? c.primal : bad == 1 ? c.dual : bad == 2 ? c.complementarity : c.control) = bad < 0 ? 1e-7 : value;
      figures.exact(std::to_string(bad), c.within(1e-7));
    }
  figures.section("imbalance");
  for (const auto& [load, wanted] : {std::pair{1.0, 2.0}, {3.0, 2.0}, {0.0, 0.0}, {1.0, 0.0}, {2.0, 2.0}})
    figures.exact(std::to_string(load) + "/" + std::to_string(wanted), rc::load_imbalance(load, wanted));
}

}  // namespace mutants
