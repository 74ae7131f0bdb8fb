#include "measured_surface.h"

#include <roughcontact/surface.h>

#include <filesystem>
#include <stdexcept>

#include "formats/surface.h"
#include "rough_surface.h"

namespace failures {

MeasuredSurface read_measured(const std::string& file) {
  rc::formats::Surface surface = rc::formats::read_surface(file, {});
  return {std::filesystem::path(file).stem().string(),
          surface.nx,
          surface.ny,
          surface.hx.value_or(1),
          surface.hy.value_or(1),
          std::move(surface.heights)};
}

Scene scene_of(const MeasuredSurface& surface) {
  Scene scene;
  scene.name = surface.name;
  scene.system.nx = surface.nx;
  scene.system.ny = surface.ny;
  scene.system.hx = surface.hx;
  scene.system.hy = surface.hy;
  scene.gap = gap_below_highest(surface.heights);
  scene.approach = mean_of(scene.gap) / 2;
  return scene;
}

CmrVerdict cmr_verdict(const Scene& scene, std::int32_t halvings) {
  Field heights;
  heights.reserve(scene.gap.size());
  for (const double value : scene.gap) heights.push_back(-value);
  rc_surface_map map = RC_SURFACE_MAP_INIT;
  map.nx = scene.system.nx;
  map.ny = scene.system.ny;
  map.hx = scene.system.hx;
  map.hy = scene.system.hy;
  map.heights = heights.data();
  rc_surface_cmr advice{};
  advice.struct_size = sizeof advice;
  if (rc_surface_cmr_advice(&map, halvings, scene.approach, &advice) != RC_OK) throw std::runtime_error(rc_surface_last_error());
  return {advice.trustworthy != 0, advice.unresolved};
}

}  // namespace failures
