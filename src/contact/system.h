// A checked system, and the dimensionless system that components see.
#pragma once

#include <roughcontact/roughcontact.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "contact/surface/prony.h"
#include "kernel/semi_periodic.h"
#include "registry/system_kernel.h"

namespace rc {

// A kernel's promises for a system, and the values that check them: SystemKernel::bounds.
struct Promises {
  KernelBounds bounds;
  double most = 0;  // periodic: the largest eigenvalue but the mean's
  double self = 0;  // free boundaries: the coefficient at offset 0, of a kernel that is not built in
};

struct ChosenKernel {
  std::string name;  // "" without a half-space
  std::string key;   // what a component can see of the half-space; where it is the same, they may share objects
  std::shared_ptr<const SystemKernel> influence;  // null without a half-space
  std::shared_ptr<const Promises> promises;       // of built-in kernels shared in the context
};

// Bounds of the dimensionless operator.
struct OperatorBounds {
  double lambda_min = 0;           // of the eigenvalues, from below; 0: none is known
  double lambda_wave = 0;          // periodic: the same without the mean's eigenvalue, which is 0
  double lambda_most = 0;          // periodic: the largest eigenvalue but the mean's
  double galerkin_share = 0;       // not periodic: x'Hx is at least this times that of the kernel galerkin
  double least_deflection = 0.25;  // of a cell under unit pressure
};

struct System {
  rc_system given;  // as the caller described it, but without creep
  rc_system unit;   // HALFSPACE: modulus 1 and cells of unit area; else as given
  ChosenKernel kernel = {};
  OperatorBounds bounds = {};
  double length_per_pressure = 1;  // H [length per pressure] = this times the dimensionless operator
  double operator_scale = 1;       // products of `unit` divided by this are dimensionless
  bool positive = true;            // H has no negative entries, so points with gap >= d carry no pressure
  double hardness = std::numeric_limits<double>::infinity();  // [pressure] the largest; infinite: nothing is plastic
  std::vector<PronyTerm> creep = {};                          // empty: none

  std::int64_t points() const { return given.nx * given.ny; }
  double cell_area() const { return given.hx * given.hy; }
  bool capped() const { return hardness < std::numeric_limits<double>::infinity(); }
  bool halfspace() const { return given.op == RC_OPERATOR_HALFSPACE; }
  bool periodic() const { return halfspace() && given.boundary == RC_BOUNDARY_PERIODIC; }
  bool semi_periodic() const { return halfspace() && kernel::semi_periodic(given.boundary); }
  // So that a conductance follows from a stiffness.
  bool homogeneous() const { return halfspace() && creep.empty() && kernel.influence->has(RC_KERNEL_HOMOGENEOUS); }
  const char* boundary() const { return periodic() ? "periodic" : semi_periodic() ? "semi-periodic" : "free"; }
  // Periodic: the eigenvalue of the longest wave on a half-space. An axis of one point has no waves.
  double half_space_wave() const;
  std::uint64_t needed_caps() const;
};

// A half-space with free edges, for functions that take its numbers one by one.
inline rc_system free_half_space(std::int64_t nx, std::int64_t ny, double hx, double hy, double modulus) {
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = nx;
  system.ny = ny;
  system.hx = hx;
  system.hy = hy;
  system.modulus = modulus;
  return system;
}

// Throws Error(ARGUMENT, SHAPE, OPTION, INCOMPATIBLE, EXTERNAL, NUMERIC, PLUGIN). With `probe`, a caller's matrix is read, a
// caller's product is tried once, and the kernel is asked for its promises.
System checked_system(const rc_system& system, const rc_options& options, bool probe);

}  // namespace rc
