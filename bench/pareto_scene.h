// Scenes of the comparison of speed with accuracy: surfaces that grids of several cell sizes show, of unit width and modulus.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "library.h"
#include "scene.h"

namespace bench {

// What theory says of one contact. Pressures are asked for on n x n cells; no function where theory has none.
struct KnownContact {
  double target = 0, load = 0, area = 0;  // target: approach, or load in load control
  std::function<Field(std::int64_t n)> pressure;
};

struct ParetoScene {
  std::string name;
  std::int64_t n = 0;  // points a side of the grid that methods are compared on; the finest has 4n
  std::int32_t boundary = RC_BOUNDARY_FREE, control = RC_CONTROL_DISPLACEMENT;
  double aspect = 1;  // hy/hx
  double most_contact = 1;
  bool full = false;                       // full contact alone
  std::function<Field(std::int64_t)> gap;  // on n/2, n, 2n and 4n points a side
  // For a share of the cells in contact; none where the approach has to be searched and the finest grid is the truth.
  std::function<KnownContact(double contact)> known;

  rc_system system(std::int64_t points) const;
};

// hertz; wave and waves, sinusoidal in one direction and in two, periodic; punch; self-affine; rmd-0.3 and the like, random
// midpoint displacement by Hurst exponent; the measured ones.
std::vector<std::string> pareto_scene_names();
// Whether the name is of scenes that seeds make different.
bool is_random_scene(const std::string& name);

// n: of the scenes that are not measured, a power of two. folder: where measured surfaces lie. None, with the reason, where the
// surface is not there; throws for a name that is not known. seed: of the random ones.
struct FoundScene {
  std::optional<ParetoScene> scene;
  std::string missing;
};
FoundScene make_pareto_scene(const std::string& name, std::int64_t n, const std::string& folder, std::uint64_t seed = 1);

}  // namespace bench
