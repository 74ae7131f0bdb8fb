// Steps of a history that lie near each other: the contact set changes by a few points, so its inverse is kept from step to step,
// and Newton's method takes the place of the iteration.
//
// A step p += H_CC^-1 (u + datum - H p)_C solves for the contact set C at hand (a primal-dual active set method: Hintermüller,
// Ito & Kunisch 2003); C then loses the points whose pressure would be negative and gains those that overlap. Each step's
// product, in double precision, tells the residual. That of the start is known, where pressures go
// on along the line through two steps whose products are kept.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "solvers/haar_cg/near/contact_inverse.h"
#include "solvers/problem.h"

namespace rc {

class NearSteps {
 public:
  // Takes over what the last step has kept.
  explicit NearSteps(const Problem& problem);

  // Solves from p and, by load, from the approach d, where the inverse is there or now worth its making. False: p, d are a start
  // for something else.
  bool solve(std::span<double> p, double& d);
  // Keeps of the answer p what the next step needs.
  void keep(std::span<const double> p);

 private:
  struct Kept {
    std::size_t contacts = 0;  // of the last step
    int near = 0;              // steps in succession that changed these little
    std::unique_ptr<ContactInverse> inverse;
    std::vector<double> p, product;  // [pressure] and H p [length] of every point of the grid; empty: not known
  };
  struct State;

  bool know_product(std::span<const double> p, std::vector<double>& product) const;
  bool make_inverse(std::span<const double> p);
  bool inverse_made(std::span<const double> p);
  bool change_set(State& state, std::span<double> p);
  void correct(const State& state, std::span<double> p);

  const Problem& problem_;
  const std::size_t most_;  // points that an inverse is kept for; 0: nothing is kept
  Kept kept_;
  std::vector<double> product_;  // H p of the answer
};

}  // namespace rc
