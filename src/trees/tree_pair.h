// The preconditioner: the average of two multilevel trees that cut the surface at different places.
#pragma once

#include <roughcontact/plugin.h>

#include "core/rows.h"
#include "trees/tree.h"

namespace rc {

// Inner products with what has come down: (z, q), (z, g), (t, g).
struct HaarProducts {
  double zq = 0, zg = 0, tg = 0;
};

// The terms from which the slope along z + beta t is computed.
template <class Real> struct HaarSlope {
  const Real* t;
  double along_z = 0, along_t = 0;
};

class HaarTreePair {
 public:
  // finest: factor of the differences inside the finest blocks. ranks: null, or those that share the cells by rows, which must
  // outlive the trees; the vectors below are then of this rank's rows, and have room for a row before the first.
  HaarTreePair(Cells cells, const CouplingTable& table, float finest = 1, const Rows& rows = {});

  // The trees live in the caller's memory. After it has moved, or others have written to it, call set_up() again.
  std::size_t bytes() const { return tree_[0].bytes() + tree_[1].bytes(); }
  void place(std::byte* memory);

  // active [unknowns]: the free set. surplus: by how much every entry of the table exceeds that of the operator.
  void set_up(std::uint8_t* active, float surplus, const rc_team& team);
  // z = M g on the free set, 0 elsewhere; g null: z = M 1. With a level: z = M (g - level), and the level is set so that the sum
  // of z is 0. Returns (z, q), where q is given; then also (z, g) and, on the free set, (t, g), if they are asked for.
  template <class Real>
  double apply(Real* g, const std::uint8_t* active, Real* z, const Real* q, double* level, const rc_team& team,
               HaarSlope<Real>* slope = nullptr);

 private:
  std::size_t shared_levels() const;
  bool worth_sharing(std::size_t level) const;
  void take(const std::uint8_t* active, const rc_team& team);
  std::int64_t before(int tree) const { return tree_[tree].rows_before() * tree_[tree].columns(); }
  // Between ranks: the last row of a finest vector, or of a level's values, to the next rank before its loads go up, and the row
  // before the first back to the previous rank after pressures have come down. Then all learn the first level that they do not
  // share.
  template <class Value> void lend_row(Value* vector) const;
  template <class Real> void take_back_row(Real* z);
  void lend_rows(std::size_t level);
  void return_rows(std::size_t level);
  void join_whole_level(bool clear);
  template <class Real> Real* row() { return reinterpret_cast<Real*>(row_.data()); }
  std::size_t shared_by_ranks() const { return tree_[0].first_whole(); }
  template <class Work> void on_level(std::size_t level, const rc_team& team, const Work& work);
  template <class Work> void on_finest(const rc_team& team, const Work& work);

  HaarTree tree_[2];
  const Ranks* ranks_;
  // At the first level that ranks do not share: each rank's bytes, this rank's values, and all values.
  std::vector<std::int64_t> joined_bytes_;
  std::vector<float> given_, joined_;
  Cells cells_;
  std::int64_t unknowns_;
  std::vector<double> row_;          // room for a row of the finest vectors; none if not every cell exists
  std::vector<std::uint8_t> taken_;  // where not every cell exists: the free set that the trees were built for
};

}  // namespace rc
