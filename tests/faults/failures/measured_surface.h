// Surfaces from files, and the library's verdict on whether a cascade finds their contacts.
#pragma once

#include <string>

#include "failure_scenes.h"

namespace failures {

struct MeasuredSurface {
  std::string name;
  std::int64_t nx = 0, ny = 0;
  double hx = 1, hy = 1;
  Field heights;
};

// Any format that the command reads; throws.
MeasuredSurface read_measured(const std::string& file);

// Approach half of the height of the highest point above the mean.
Scene scene_of(const MeasuredSurface& surface);

struct CmrVerdict {
  bool trustworthy = false;
  double unresolved = 0;
};
CmrVerdict cmr_verdict(const Scene& scene, std::int32_t halvings);

}  // namespace failures
