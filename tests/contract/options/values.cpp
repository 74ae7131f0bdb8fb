#include "values.h"

#include <roughcontact/registry.h>

#include <cstdio>

namespace options {

namespace {

std::string text_of(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string whole(double value) { return std::to_string(static_cast<std::int64_t>(value)); }

std::vector<std::string> parts(const std::string& choices) {
  std::vector<std::string> found{""};
  for (const char c : choices) {
    if (c == '|') found.emplace_back();
    if (c != '|') found.back() += c;
  }
  return found;
}

std::vector<std::string> names(rc_context* context, std::int32_t kind) {
  std::vector<std::string> found;
  for (std::int64_t i = 0; i < rc_component_count(context, kind); ++i) {
    rc_component component = RC_COMPONENT_INIT;
    if (rc_component_describe(context, kind, i, &component) == RC_OK) found.emplace_back(component.name);
  }
  return found;
}

}  // namespace

rc_context* make_context() {
  rc_context* context = nullptr;
  return rc_context_create(0, RC_PLUGINS, nullptr, nullptr, &context) == RC_OK ? context : nullptr;
}

std::vector<Option> all_options(rc_context* context) {
  std::vector<Option> found;
  for (std::int64_t i = 0, n = rc_component_count(context, RC_COMPONENT_OPTION); i < n; ++i) {
    rc_component spec = RC_COMPONENT_INIT;
    if (rc_component_describe(context, RC_COMPONENT_OPTION, i, &spec) != RC_OK) continue;
    found.push_back({spec.name, spec.default_value, spec.choices ? spec.choices : "", spec.type, spec.minimum, spec.maximum});
  }
  return found;
}

Names all_names(rc_context* context) {
  return {names(context, RC_COMPONENT_BACKEND), names(context, RC_COMPONENT_SOLVER), names(context, RC_COMPONENT_KERNEL)};
}

Values values_of(const Option& option, const Names& names) {
  if (option.type == RC_TYPE_INT)
    return {{whole(option.minimum), option.default_value, whole(option.maximum)},
            {whole(option.minimum - 1), whole(option.maximum + 1), "1.5", "many", ""}};
  if (option.type == RC_TYPE_REAL)
    return {{text_of(option.minimum), option.default_value, text_of(option.maximum)},
            {text_of(option.minimum - 1), text_of(2 * option.maximum), "nan", "inf", "much", ""}};
  Values values;
  if (!option.choices.empty()) return {parts(option.choices), {"nonsense", ""}};
  values.inside = {option.default_value, "", "auto", "none", "nonsense", "a,b", ",", std::string(10000, 'x')};
  for (const auto* list : {&names.backends, &names.solvers, &names.kernels})
    values.inside.insert(values.inside.end(), list->begin(), list->end());
  return values;
}

}  // namespace options
