// The word layer: the kernel layer and its options.
#include "core/error.h"
#include "request/choices.h"
#include "request/request.h"

namespace rc::request {

namespace {

constexpr std::string_view layer_keys[] = {"t", "E", "nu", "base", "interface"};

// Poisson's ratio of the half-space below a bonded layer; the library has a default.
void set_substrate(const Words& words, rc_request& request) {
  const Given* const nu = words.find("nu");
  if (nu) {
    request.options.emplace_back("layer.substrate_poisson",
                                 nu->text ? std::string(trimmed(nu->text)) : exact(nu->numbers.front()));
    return;
  }
  request.remarks.push_back({RC_REMARK_LAYER, RC_ASSUMED, "nu",
                             join("the half-space below the layer has Poisson's ratio 0.3; ", words.spelt("E"), " and ",
                                  words.spelt("nu"), " name another")});
}

}  // namespace

void set_layer(const Words& words, Units& units, rc_request& request) {
  const Given* const given = words.find("layer");
  if (!given) return;
  const std::string layer = words.spelt("layer");
  const Given *const kernel = words.find("kernel"), *const young = words.find("E");
  if (kernel && !(kernel->text && std::string_view(kernel->text) == "layer"))
    throw Error(words.spelt("kernel"), ": ", kernel->shown(), " has no layer; leave it out");
  if (words.find("E2") || (young && (young->numbers.size() > 1 || (young->text && split(young->text, ',').size() > 1))))
    throw Error(layer, " is pressed by a rigid body: give ", words.spelt("E"), " and ", words.spelt("nu"),
                " of the half-space below the layer only");
  double thickness = 0, modulus = 0, poisson = 0.5 + 1;
  bool rigid = false, sliding = false;
  for (const std::string_view setting : split(given->text, ',')) {
    const auto equals = std::min(setting.find('='), setting.size());
    const std::string_view key = setting.substr(0, equals), value = setting.substr(std::min(equals + 1, setting.size()));
    const std::string where = join(layer, ": ", key);
    switch (choice(layer, key, layer_keys)) {
      case 0: {
        const Quantity found = read_positive(where, value, Dimension::length, units.bare.metres);
        units.see({found});
        if (found.bare) units.add(where);
        thickness = found.si();
        break;
      }
      case 1: {
        const Quantity found = read_positive(where, value, Dimension::pressure);
        units.see({found});
        modulus = found.si();
        break;
      }
      case 2:
        poisson = finite_number(where, value);
        if (!(poisson >= 0 && poisson <= 0.5)) throw Error(where, " = ", value, " is not in 0 .. 0.5");
        break;
      case 3: {
        constexpr std::string_view bases[] = {"half-space", "rigid"};
        rigid = choice(where, value, bases) == 1;
        break;
      }
      default: {
        constexpr std::string_view interfaces[] = {"bonded", "frictionless"};
        sliding = choice(where, value, interfaces) == 1;
      }
    }
  }
  if (!(thickness > 0 && modulus > 0 && poisson <= 0.5))
    throw Error(layer, ": ", given->shown(), " needs t, E and nu, give ", given->word->example);
  if (!kernel) request.options.emplace_back("kernel", "layer");
  request.options.emplace_back("layer.thickness", exact(thickness));
  request.options.emplace_back("layer.modulus", exact(modulus / (1 - poisson * poisson)));
  request.options.emplace_back("layer.poisson", exact(poisson));
  request.options.emplace_back("layer.base", rigid ? "rigid" : "half-space");
  request.options.emplace_back("layer.interface", sliding ? "frictionless" : "bonded");
  if (!rigid && !sliding) set_substrate(words, request);
  request.layered = true;
}

}  // namespace rc::request
