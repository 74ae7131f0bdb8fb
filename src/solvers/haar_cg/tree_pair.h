// The preconditioner: the average of two multilevel trees that cut the surface at different places.
#pragma once

#include <roughcontact/plugin.h>

#include "solvers/haar_cg/tree.h"

namespace rc {

class HaarTreePair {
 public:
  // finest: factor of the differences inside the finest blocks.
  HaarTreePair(Cells cells, const CouplingTable& table, float finest = 1);

  // The trees live in the caller's memory. After it has moved, or others have written to it, call set_up() again.
  std::size_t bytes() const { return tree_[0].bytes() + tree_[1].bytes(); }
  void place(std::byte* memory);

  // active [unknowns]: the free set. surplus: by how much every entry of the table exceeds that of the operator.
  void set_up(const std::uint8_t* active, float surplus, const rc_team& team);
  // z = M g on the free set, 0 elsewhere; g null: z = M 1. With a level: z = M (g - level), and the level is set so that the sum
  // of z is 0. Returns (z, q), where q is given.
  template <class Real>
  double apply(const Real* g, const std::uint8_t* active, Real* z, const Real* q, double* level, const rc_team& team);

 private:
  std::size_t shared_levels() const;
  bool worth_sharing(std::size_t level) const;
  void take(const std::uint8_t* active, const rc_team& team);
  template <class Work> void on_level(std::size_t level, const rc_team& team, const Work& work);
  template <class Work> void on_finest(const rc_team& team, const Work& work);

  HaarTree tree_[2];
  Cells cells_;
  std::int64_t unknowns_;
  std::vector<std::uint8_t> taken_;  // where not every cell exists: the free set that the trees were built for
};

}  // namespace rc
