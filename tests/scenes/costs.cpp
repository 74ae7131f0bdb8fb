// The number of products with H that an answer takes, against that of polonsky-keer.
#include <array>

#include "property.h"

namespace scenes {

namespace {

// Solvers made for rough surfaces on square grids take hardly more products than plain conjugate gradients, also on thin grids,
// long cells and single peaks. A scene of more than `most_ratio` times as many is undecidable: a few in a hundred may be.
class Products final : public Property {
 public:
  std::string ask(const Case& c) override {
    const Scene& scene = c.scene();
    if (!scene.halfspace() || scene.semi_periodic() || scene.hard()) return "not elastic, free or periodic";
    if (scene.points() < 64) return "few points";
    if (scene.control == RC_CONTROL_AREA) return "control by area";
    if (!scene.steps.front().p0.empty()) return "a start is given";
    rc_contact* made = nullptr;
    pairs::Settings settings = scene.settings;
    settings.insert(settings.end(), {{"bounds", "0"}, {"stiffness", "0"}});
    const pairs::Pair plain{"polonsky-keer", "fft"}, own{"haar-cg", "fft"};
    for (const auto& [pair, products] : {std::pair{plain, &plain_}, {own, &own_}}) {
      if (rc_contact_create(&c.system(), pairs::make_options(pair, scene.kernel, settings).get(), &made) != RC_OK)
        return "refused";
      const Handle contact(made);
      const StepAnswer answer = c.solve(contact.get(), scene.steps.front());
      if (answer.status != RC_OK) return "not certified by " + pair.name();
      *products = answer.result.products;
    }
    return "";
  }
  Verdict judge(const Case&) const override {
    const double ratio = static_cast<double>(own_) / static_cast<double>(plain_);
    need(own_ <= few || ratio <= most_ever, std::to_string(own_) + " products, polonsky-keer takes " + std::to_string(plain_));
    return own_ <= few || ratio <= most_ratio ? Verdict::held : Verdict::undecidable;
  }
  bool spoil(const Case&, Random&) override {
    own_ = few + 1 + static_cast<std::int64_t>(2 * most_ever * static_cast<double>(plain_));
    return true;
  }

 private:
  static constexpr double most_ratio = 1.5, most_ever = 4.5;
  static constexpr std::int64_t few = 40;  // a wave pressed flat takes plain iterations five
  std::int64_t own_ = 0, plain_ = 0;
};

constexpr std::array kinds_of_costs{Kind{"products", 1, 0, 0.015, 0.02, made<Products>}};

}  // namespace

std::span<const Kind> properties_of_costs() { return kinds_of_costs; }

}  // namespace scenes
