// Runs of neighbouring points, which passes visit or leave out as a whole.
#pragma once

#include <cstdint>

namespace rc {

constexpr std::int64_t run_points = 16;  // of a run

// Idle: none of a run's points is in the free set. Still: and the direction t is 0 there; left: t may be something else.
enum class RunState : std::uint8_t { busy, left, still };

}  // namespace rc
