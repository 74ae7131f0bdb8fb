// The pressure at which a scene's gap closes, against paths through exact gaps.
#include <roughcontact/flow.h>

#include <array>
#include <optional>

#include "property.h"

namespace scenes {

namespace {

// The pressure that closes the gap: the exact gap a little below its interval has a path, a little above it has none.
class Closing final : public Property {
 public:
  std::string ask(const Case& c) override {
    const Scene& scene = c.scene();
    if (c.system().op == RC_OPERATOR_CALLBACK) return "an own product";
    if (scene.points() > 120) return "many points";
    along_y_ = Random(scene.seed, 902).chance(0.5);
    rc_flow_spec spec = RC_FLOW_SPEC_INIT;
    spec.along = along_y_ ? RC_FLOW_Y : RC_FLOW_X;
    rc_step step = c.step(scene.steps.front());
    step.p0 = rc_const_array{};
    const pairs::Settings fast{{"solver", "auto"}, {"backend", "auto"}, {"tol", "1e-10"}};
    status_ = rc_flow_closing_pressure(&c.system(), c.options(fast).get(), &step, &spec, &found_);
    message_ = rc_flow_last_error();
    if (status_ == RC_ERR_INFEASIBLE) return "open under all loads";
    if (status_ == RC_ERR_INCOMPATIBLE) return "nothing is proven";
    if (status_ < 0 || found_.upper == 0) return status_ < 0 ? "" : "closed without a load";
    open_ = crossing(c, found_.lower * (1 - 1e-4), fast);
    closed_ = crossing(c, found_.upper * (1 + 1e-4), fast);
    return "";
  }

  Verdict judge(const Case&) const override {
    need(status_ >= 0, std::string(rc_status_name(status_)) + ": " + message_);
    need(found_.lower < found_.upper, "the interval is empty");
    need(status_ != RC_OK || found_.upper - found_.lower <= 0.01 * found_.upper * (1 + 1e-12), "wider than RC_OK says");
    if (!open_ && !closed_) return Verdict::undecidable;
    need(!open_ || *open_, "closed below the lower pressure " + number(found_.lower));
    need(!closed_ || !*closed_, "open above the upper pressure " + number(found_.upper));
    return Verdict::held;
  }

  bool spoil(const Case& c, Random& random) override {
    if (status_ < 0 || !open_ || !closed_ || !(found_.lower > 0)) return false;
    const pairs::Settings fast{{"solver", "auto"}, {"backend", "auto"}, {"tol", "1e-10"}};
    if (random.chance(0.5))
      open_ = crossing(c, found_.upper * (1 + 1e-3), fast);
    else
      closed_ = crossing(c, found_.lower * (1 - 1e-3), fast);
    return true;
  }

 private:
  // Whether cells with an exact gap above 0 connect the sides; nothing if the oracle does not know.
  std::optional<bool> crossing(const Case& c, double pressure, const pairs::Settings& settings) const {
    const Scene& scene = c.scene();
    rc_step step = c.step(scene.steps.front());
    step.p0 = rc_const_array{};
    step.control = RC_CONTROL_PRESSURE;
    step.target = pressure;
    const StepAnswer answer = c.solve(c.open(settings).get(), step);
    if (answer.status != RC_OK) return {};
    const Surface& surface = c.surface(0);
    const Exact exact = c.exact_of(answer, surface, true);
    if (exact.worth != Worth::exact) return {};
    const auto nx = static_cast<std::size_t>(scene.system.nx), n = surface.gap.size(), ny = n / nx;
    const bool round = scene.repeats_across(along_y_);
    const auto is_open = [&](std::size_t i) { return surface.included(i) && !(exact.p[i] > 0) && exact.w[i] > 0; };
    std::vector<bool> seen(n);
    std::vector<std::size_t> front;
    const auto visit = [&](std::size_t x, std::size_t y) {
      const std::size_t i = y * nx + x;
      if (!seen[i] && is_open(i)) seen[i] = true, front.push_back(i);
    };
    for (std::size_t k = 0; k < (along_y_ ? nx : ny); ++k) visit(along_y_ ? k : 0, along_y_ ? 0 : k);
    while (!front.empty()) {
      const std::size_t i = front.back(), x = i % nx, y = i / nx;
      front.pop_back();
      if ((along_y_ ? y + 1 == ny : x + 1 == nx)) return true;
      if (x + 1 < nx || (round && along_y_)) visit((x + 1) % nx, y);
      if (x > 0 || (round && along_y_)) visit((x + nx - 1) % nx, y);
      if (y + 1 < ny || (round && !along_y_)) visit(x, (y + 1) % ny);
      if (y > 0 || (round && !along_y_)) visit(x, (y + ny - 1) % ny);
    }
    return false;
  }

  bool along_y_ = false;
  std::optional<bool> open_, closed_;
  rc_flow_closing found_ = RC_FLOW_CLOSING_INIT;
  rc_status status_ = RC_ERR_INTERNAL;
  std::string message_;
};

constexpr std::array kinds_of_closing{Kind{"closing", 8, 3, 0.12, 0.2, made<Closing>}};

}  // namespace

std::span<const Kind> properties_of_closing() { return kinds_of_closing; }

}  // namespace scenes
