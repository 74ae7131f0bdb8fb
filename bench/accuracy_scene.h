// Scenes with a truth to measure errors against.
#pragma once

#include <string>

#include "child.h"
#include "library.h"
#include "scene.h"

namespace bench {

struct Truth {
  double load = 0, area = 0;
  Field pressure;
};

// Relative errors: of load and contact area, and of the pressures in the L2 norm.
Json errors_against(const Truth& truth, const Field& pressure, double load, double area);

struct AccuracyScene {
  std::string name;
  std::int64_t n = 0;
  double approach = 0;
  Field gap;
  Truth truth;
  Json discretisation = Json::array();  // errors of the exact solution of this grid and of others

  std::int64_t candidates() const;
  Json errors(const Field& pressure, const rc_result& result) const {
    return errors_against(truth, pressure, result.load, result.contact_area);
  }
};

// "hertz", with the analytic truth, at the grid's cell size, half and a quarter of it; "self-affine-N" for an N x N grid at about
// 10 % contact, with the solution at tolerance 1e-13 as truth, and that of the grid of half the cell size for the discretisation.
AccuracyScene make_accuracy_scene(const std::string& name, std::int64_t threads);

}  // namespace bench
