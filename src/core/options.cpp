#include "core/options.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/error.h"

namespace rc {

void Schema::add(const OptionSpec& spec) {
  OptionSpec copy = spec;
  copy.parsed_default = parsed_value(spec, spec.default_value);
  specs_.push_back(std::move(copy));
}

const OptionSpec* Schema::find(std::string_view key) const {
  const auto it = std::find_if(specs_.begin(), specs_.end(), [&](const OptionSpec& spec) { return spec.key == key; });
  return it == specs_.end() ? nullptr : &*it;
}

std::vector<std::string> Schema::keys() const {
  std::vector<std::string> result;
  for (const OptionSpec& spec : specs_) result.push_back(spec.key);
  return result;
}

namespace {

// Size of rc_option_spec when it was first released. A literal, so that it does not follow today's size.
constexpr std::size_t first_spec_size = 64;

}  // namespace

OptionSpec checked_spec(const rc_option_spec& spec, std::string_view component) {
  const std::string prefix = join(component, ".");
  if (spec.struct_size < first_spec_size || !spec.key || std::strncmp(spec.key, prefix.c_str(), prefix.size()) != 0)
    fail(RC_ERR_PLUGIN, "component \"", component, "\" declares the option \"", spec.key ? spec.key : "",
         "\"; its keys must start with \"", prefix, "\"");
  if (!spec.default_value || !spec.help || spec.type < RC_TYPE_INT || spec.type > RC_TYPE_TEXT)
    fail(RC_ERR_PLUGIN, "option \"", spec.key, "\" lacks a default, a help text or a type");
  OptionSpec copy{spec.key,  spec.default_value, spec.help,    {},          spec.choices ? spec.choices : "",
                  spec.type, spec.fixed != 0,    spec.minimum, spec.maximum};
  if (spec.choices) copy.choices = split(spec.choices, '|');
  try {
    parsed_value(copy, copy.default_value);
  } catch (const Error& error) {
    if (error.code() != RC_ERR_OPTION) throw;
    fail(RC_ERR_PLUGIN, "component \"", component, "\": the default of an option does not fit: ", error.what());
  }
  return copy;
}

namespace {

const char* type_name(int type) { return type == RC_TYPE_INT ? "an integer" : type == RC_TYPE_REAL ? "a real number" : "a text"; }

void check_range(const OptionSpec& spec, double value) {
  if (!(value >= spec.minimum && value <= spec.maximum))
    fail(RC_ERR_OPTION, "option \"", spec.key, "\" = ", value, " is outside ", spec.minimum, " .. ", spec.maximum);
}

}  // namespace

OptionValue checked_value(const OptionSpec& spec, const OptionValue& value) {
  if (spec.type == RC_TYPE_INT && std::holds_alternative<std::int64_t>(value)) {
    check_range(spec, static_cast<double>(std::get<std::int64_t>(value)));
    return value;
  }
  if (spec.type == RC_TYPE_REAL && !std::holds_alternative<std::string>(value)) {
    const double real =
        std::holds_alternative<double>(value) ? std::get<double>(value) : static_cast<double>(std::get<std::int64_t>(value));
    check_range(spec, real);
    return real;
  }
  if (spec.type == RC_TYPE_TEXT && std::holds_alternative<std::string>(value)) {
    const std::string& text = std::get<std::string>(value);
    if (!spec.choices.empty() && std::find(spec.choices.begin(), spec.choices.end(), text) == spec.choices.end())
      fail(RC_ERR_OPTION, "option \"", spec.key, "\" = \"", text, "\" is none of ", spec.choices_text,
           suggestion(text, spec.choices));
    return value;
  }
  fail(RC_ERR_OPTION, "option \"", spec.key, "\" takes ", type_name(spec.type));
}

OptionValue parsed_value(const OptionSpec& spec, std::string_view text) {
  if (spec.type == RC_TYPE_INT) {
    if (const auto value = parse_int(text)) return checked_value(spec, std::int64_t{*value});
  } else if (spec.type == RC_TYPE_REAL) {
    if (const auto value = parse_real(text)) return checked_value(spec, *value);
  } else {
    return checked_value(spec, std::string(text));
  }
  fail(RC_ERR_OPTION, "option \"", spec.key, "\" takes ", type_name(spec.type), ", not \"", text, "\"");
}

void OptionSet::set(const OptionSpec& spec, const OptionValue& value) { values_[spec.key] = checked_value(spec, value); }

const OptionValue& OptionSet::get(const OptionSpec& spec) const {
  const auto it = values_.find(spec.key);
  return it != values_.end() ? it->second : spec.parsed_default;
}

}  // namespace rc
