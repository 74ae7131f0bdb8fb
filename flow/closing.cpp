#include "closing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "layout.h"

namespace rc::flow {

namespace {

struct DestroyContact {
  void operator()(rc_contact* contact) const { rc_contact_destroy(contact); }
};

enum class Proof { open, closed, neither };

// The state of a seal at one pressure, and the pressures for which it is proven.
struct State {
  Proof proof;
  double pressure_lower, pressure_upper;  // of the exact solution at the returned approach
  double area_fraction, constriction;
};

int32_t stop_step(const rc_progress*, void*) { return stop_asked<Library>() ? 1 : 0; }

class Press {
 public:
  Press(const rc_system& system, const rc_options* options, const rc_step& step, const rc_flow_spec& spec)
      : system_(system), step_(step), layout_(layout_of(system, spec)) {
    rc_contact* made = nullptr;
    check_core(rc_contact_create(&system, options, &made));
    contact_.reset(made);
    check_core(rc_contact_on_progress(made, stop_step, nullptr, 1));
    const auto n = static_cast<std::size_t>(system.nx * system.ny);
    p_.resize(n);
    gap_.resize(n);
    step_.control = RC_CONTROL_LOAD;
    step_.borrow = 1;
    step_.p0 = {};
  }

  State at(double pressure) {
    stop_if_asked();
    ++steps;
    const double area = system_.hx * system_.hy * static_cast<double>(system_.nx * system_.ny);
    // The plastic indentation of one pressure is not to be that of the next.
    if (steps > 1 && std::isfinite(system_.hardness) && system_.hardness > 0) check_core(rc_contact_reset(contact_.get()));
    step_.target = pressure * area;
    rc_result result = RC_RESULT_INIT;
    result.p.data = p_.data();
    result.gap.data = gap_.data();
    const rc_status status = rc_contact_solve(contact_.get(), &step_, &result);
    stop_if_asked();
    check_core(status);
    const auto* mask = static_cast<const std::uint8_t*>(step_.mask.data);
    const double error = gap_error(system_, nullptr, result, mask);
    if (std::isnan(error)) {
      if (result.contacts ==
          system_.nx * system_.ny)  // in full periodic contact nothing is open; no interval of the load is proven
        return {Proof::closed, pressure, pressure, 1, 0};
      fail(RC_ERR_INCOMPATIBLE, "no bounds are proven at pressure ", pressure,
           ": option bounds must be 1, option accuracy 0, and the system one whose bounds are known");
    }
    Gap gap = layout_.arranged(contact_gap(system_, result, mask, error, true));
    State state{Proof::neither, result.load_lower / area, result.load_upper / area, result.area_fraction, 0};
    if (!find_paths(layout_.grid, gap.most).any()) {
      state.proof = Proof::closed;
    } else if (find_paths(layout_.grid, gap.least).any()) {
      state.proof = Proof::open;
      state.constriction = find_paths(layout_.grid, gap.computed, Find::constriction).constriction;
    }
    return state;
  }

  std::int32_t steps = 0;

 private:
  const rc_system& system_;
  rc_step step_;
  const Layout layout_;
  std::unique_ptr<rc_contact, DestroyContact> contact_;
  std::vector<double> p_, gap_;
};

}  // namespace

rc_flow_closing closing_pressure(const rc_system& system, const rc_options* options, const rc_step& step,
                                 const rc_flow_spec& spec) {
  Press press(system, options, step, spec);
  rc_flow_closing answer = RC_FLOW_CLOSING_INIT;
  constexpr double never = 1e-12;
  const double scale = system.op == RC_OPERATOR_HALFSPACE
                           ? system.modulus
                           : 1 / (largest_deflection(system, options) / std::sqrt(system.hx * system.hy));
  const bool hard = system.hardness > 0 && std::isfinite(system.hardness);
  const double most = hard ? system.hardness * (1 - 1e-9) : scale;
  double open = 0, closed = 0;                // tried pressures
  double open_beyond = 0, closed_before = 0;  // the lowest and highest tried that are neither; 0: none
  const auto take = [&](double pressure) {
    const State state = press.at(pressure);
    if (state.proof == Proof::open) {
      open = pressure;
      answer.lower = state.pressure_lower;
      answer.constriction = state.constriction;
    } else if (state.proof == Proof::closed) {
      closed = pressure;
      answer.upper = state.pressure_upper;
      answer.area_fraction = state.area_fraction;
    } else {
      open_beyond = open_beyond > 0 ? std::min(open_beyond, pressure) : pressure;
      closed_before = std::max(closed_before, pressure);
    }
    return state.proof;
  };
  double pressure = std::min(most, 1e-2 * scale);
  if (take(pressure) == Proof::closed)
    while (open == 0 && pressure > never * scale) take(pressure /= 4);
  while (closed == 0) {
    if (pressure >= most)
      fail(RC_ERR_INFEASIBLE, "the gap is not closed at pressure ", pressure,
           hard ? ", almost the hardness" : ", which is as large as the modulus");
    take(pressure = std::min(most, 2 * pressure));
  }
  if (open == 0 && open_beyond == 0) {
    answer.lower = answer.upper = 0;
  } else {
    while (open == 0 && pressure > never * scale) take(pressure /= 4);
    const auto apart = [&](double a, double b) { return 1 - a / b; };
    for (int tries = 0; tries < 100; ++tries) {
      const double above = open_beyond > 0 ? open_beyond : closed, below = closed_before > 0 ? closed_before : open;
      const double part = open_beyond > 0 ? spec.width / 4 : spec.width / 2;
      if (apart(open, above) > part)
        take(std::sqrt(open * above));
      else if (apart(below, closed) > part)
        take(std::sqrt(below * closed));
      else
        break;
    }
  }
  answer.steps = press.steps;
  answer.status = answer.upper - answer.lower <= spec.width * answer.upper ? RC_OK : RC_STOP_STALLED;
  return answer;
}

}  // namespace rc::flow
