#include "solvers/haar_cg/near/matrix_loops.h"

#define RC_LOOPS "solvers/haar_cg/near/matrix_loops.inc"
#include "core/vectors/sets.inc"

namespace rc {

MatrixLoops best_matrix_loops() { return RC_BEST(matrix_loops); }

}  // namespace rc
