// Newton's steps of the datum: to a prescribed load or, if a mean is added to the operator, to the deflection that it causes. The
// functions that take a State return by how much the datum changes.
#pragma once

#include <cmath>
#include <limits>

#include "core/by_value.h"
#include "solvers/haar_cg/iteration/known_loads.h"
#include "solvers/haar_cg/iteration/newton_slope.h"

namespace rc {

class NewtonDatum {
 public:
  static constexpr double blur = 1e-5;  // of the penetration: error of a datum at which every point is at an end

  constexpr explicit NewtonDatum(bool elongated)
      : elongated_(elongated),
        excess_(1 / (elongated ? elongated_excess : usual_excess), elongated ? elongated_excess : usual_excess) {
    if (elongated) excess_.expect(unknown);
  }

  // The state before a step. depth: the largest penetration. The trees give pending, the load that the present gap calls for,
  // and slope, that of the load over the datum: 1'z with z = M 1. residual: after the last bound.
  struct State {
    double datum, load, depth, pending, slope, residual;
    constexpr bool settled() const { return residual < settled_residual; }
  };

  // Whether the trees' slope has to be measured first. The added mean causes less than the whole deflection; if the trees
  // contradict that, they overrate the slope.
  constexpr bool unmeasured(double mean, double slope, bool by_load) const {
    return !excess_.known() || (!by_load && mean * excess_.factor() * slope > most_share);
  }
  // energy: z'Hz. The multiple of z that has the least energy is 1'z / z'Hz, with an error of second order in that of M.
  constexpr void measured(double slope, double energy) { excess_.set(energy > 0 ? slope / energy : 1); }

  // The missing load is what remains to be added once the present gap is closed. imbalance: relative error of the load.
  constexpr double to_load(const State& now, double load, double imbalance, double mean) {
    const double missing = load - now.load + excess_.factor() * now.pending;
    excess_.correct(missing, now.settled(), now.settled());
    const double wanted = missing / (excess_.factor() * now.slope);
    const bool far = imbalance > overloaded;
    const double most_down = (far ? most_fall_overloaded : most_fall) * now.depth;
    const double change = loads_.between(now.datum, within(wanted, -most_down, larger_of(now.depth, mean * load)));
    excess_.expect(change == wanted ? missing : far || elongated_ ? unknown : 0);
    return change;
  }

  constexpr double to_deflection(const State& now, double mean) {
    const double excess = excess_.factor(), missing = mean * (now.load - excess * now.pending) - now.datum;
    stiffening_.correct(missing, true, now.settled());
    const double wanted = missing / (stiffening_.factor() * larger_of(1 - mean * excess * now.slope, least_slope));
    const double depth = 1 + now.datum, change = within(wanted, -0.5 * depth, depth);
    stiffening_.expect(change == wanted ? missing : unknown);
    return change;
  }
  constexpr void begin_deflection() { stiffening_.set(1); }

  // Every point is at an end of its pressures and should be, so the load is exactly that of the datum. Moves it at least by
  // `nearest`, to where the first point leaves its end.
  constexpr double release(const State& now, double missing, double nearest, double cap) {
    return loads_.leave(now.datum, blur * now.depth, now.load, missing, nearest, std::abs(missing) <= few * cap);
  }

 private:
  static constexpr double usual_excess = 2, elongated_excess = 10;       // largest correction of the trees' slope, either way
  static constexpr double settled_residual = 5e-2;                       // residual below which the free set changes little
  static constexpr double overloaded = 10;                               // relative imbalance: the datum may then fall by more
  static constexpr double most_fall = 0.5, most_fall_overloaded = 0.95;  // of the penetration in a step
  static constexpr double least_stiffening = 1e-2, most_stiffening = 4;  // correction of the deflection's slope
  static constexpr double least_slope = 1e-4;                            // of the deflection that is missing
  static constexpr double most_share = 0.99;  // of the deflection under a load: the added mean makes up less
  static constexpr double few = 2;            // points whose caps make up the missing load: then the nearest one is released
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  bool elongated_;
  KnownLoads loads_;
  NewtonSlope excess_;                                         // slope of the load over the trees' slope
  NewtonSlope stiffening_{least_stiffening, most_stiffening};  // correction of the datum's slope by approach
};

}  // namespace rc
