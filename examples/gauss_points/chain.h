// A row of masses, coupled by springs, that fall onto rough patches: a small stand-in for a finite element code. Each mass has a
// contact law, as a Gauss point has.
#pragma once

#include <vector>

#include "contact_law.h"

struct Chain {
  double mass = 1, spring = 1;             // of every mass; between neighbours
  double push = 0;                         // force on every mass, towards the patches
  std::vector<double> position, velocity;  // > 0: into the patch; as many as laws
};

struct ChainStep {
  double time = 0;
  int newton_iterations = 0;
  double contact_force = 0;  // of all points
  int tabulated = 0;         // points of which it is by the law
  double residual = 0;       // the largest unbalanced force
  std::vector<double> position;
};

// Steps of length dt by Newmark's average acceleration; Newton's method with the laws' tangents in every step.
std::vector<ChainStep> run(Chain chain, std::vector<ContactLaw>& laws, double dt, int steps, int threads);
