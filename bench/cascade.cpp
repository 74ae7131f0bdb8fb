#include "cascade.h"

#include <cstdio>

#include "format.h"

namespace bench {

Settings settings_of(const Cascade& cascade, bool certified) {
  return {{"solver", "cmr"},
          {"backend", cascade.backend},
          {"cmr.inner", cascade.inner},
          {"cmr.area", cascade.area},
          {"cmr.radius", formatted("%.17g", cascade.radius)},
          {"cmr.levels", std::to_string(cascade.levels)},
          {"cmr.filter", cascade.filter},
          {"cmr.certified", certified ? "1" : "0"}};
}

CascadeNote cascade_note(const std::string& note) {
  CascadeNote found;
  const auto at = note.find("trial set ");
  if (at == std::string::npos || std::sscanf(note.c_str() + at, "trial set %lld of %lld after %lld rounds, %lld points added",
                                             &found.kept, &found.all, &found.rounds, &found.added) < 3)
    return {};
  return found;
}

}  // namespace bench
