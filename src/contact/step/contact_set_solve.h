// A x = b on the contact set C of a half-space, A = H[C,C] + mean() 11', for operators that multiply but cannot factor: conjugate
// gradients with the trees of haar-cg.
#pragma once

#include <roughcontact/plugin.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "operator/operator.h"
#include "solvers/haar_cg/tree_inputs.h"
#include "solvers/haar_cg/tree_pair.h"

namespace rc {

class ContactSetSolve {
 public:
  // set: ascending positions in the operator's trial set. grid: the operator's, without an index. lowest: a bound from below of
  // the eigenvalues of H, > 0; where it is periodic, of those of all waves but the mean. `op` and `team` must outlive it.
  ContactSetSolve(Operator& op, std::span<const std::int64_t> set, rc_grid grid, double lowest, const rc_team& team,
                  const Coefficients& coefficients);

  // 0 but where the grid is periodic: a periodic operator may lack a mean, and hardly resists one where nearly all points touch.
  double mean() const { return mean_; }

  // enough(form, error): whether form = b'A^-1 b is known well enough; it is too small, by less than `error`, but for round-off.
  // The same error bounds that of x, squared, in the norm of the energy.
  using Enough = std::function<bool(double form, double error)>;
  // x: answer out. RC_STOP_STALLED where round-off keeps the error above what is enough, or a status with which a product ended.
  // Throws where H is not positive definite (NUMERIC).
  rc_status operator()(std::span<const double> b, const Enough& enough, std::span<double> x, double& form);

 private:
  rc_status multiply(const std::vector<double>& t, std::vector<double>& q);

  Operator& op_;
  const rc_team& team_;
  std::vector<std::int64_t> set_;
  double mean_ = 0, lowest_ = 0;  // lowest_: bound of the eigenvalues of A
  std::optional<HaarTreePair> trees_;
  std::unique_ptr<std::byte[]> memory_;  // of the trees
  std::vector<std::uint8_t> active_;
  std::vector<double> spread_, product_;  // on the trial set
};

}  // namespace rc
