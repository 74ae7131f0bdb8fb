// The passes of the preconditioner of haar-cg over its two trees: launches of a device, or loops of a block of its threads.
#pragma once

#include "kernels/trees.h"

namespace rc_cuda {

struct TreePasses {
  const Level* levels[2];  // of each tree, where the code that makes the passes reads them
  Summit summit;
  const Patterns* table;
  float least_top;  // of the surplus: least coupling of the whole with itself

  // state [cells]: which of them are in the free set. surplus: by how much every entry of the table exceeds that of the operator.
  template <class Place> RC_CALLED constexpr void set_up(Place& place, const std::uint8_t* state, double surplus) const {
    on_level(place, 0, SolveFinest{state, table});
    for (int level = 1; level < summit.first; ++level) on_level(place, level, Solve{});
    place.together(SolveSummit{summit, static_cast<float>(surplus), least_top});
  }

  // z = M g on the free set, 0 elsewhere; without g: z = M 1. keeps_sum: z = M (g - level), the level such that the sum of z is
  // 0.
  template <class R, class Place>
  RC_CALLED constexpr Preconditioned apply(Place& place, const R* g, const std::uint8_t* state, R* z, const R* q,
                                           bool keeps_sum) const {
    on_level(place, 0, UpFinest<R>{state, table, g});
    for (int level = 1; level < summit.first; ++level) on_level(place, level, Up{});
    place.together(ApplySummit{summit, keeps_sum});
    for (int level = summit.first; level-- > 1;) on_level(place, level, Down{});
    const Level& finest = levels[0][0];
    const DownFinest<R> last{{finest, levels[1][0]}, state, table, summit.level_of_w, g, q, z};
    return place.template reduce<Preconditioned>(finest.mx * finest.my, last);
  }

 private:
  template <class Place, class F> constexpr void on_level(Place& place, int level, const F& f) const {
    const OnLevel<F> work{{levels[0][level], levels[1][level]}, f};
    place.each(work.level[0].blocks() + work.level[1].blocks(), work);
  }
};

}  // namespace rc_cuda
