#include "core/options.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/error.h"
#include "core/first_size.h"

namespace rc {

OptionSpec::OptionSpec(const rc_component& spec)
    : key(spec.name),
      default_value(spec.default_value),
      help(spec.summary),
      choices(spec.choices ? split(spec.choices, '|') : std::vector<std::string>()),
      choices_text(spec.choices ? spec.choices : ""),
      type(spec.type),
      fixed(spec.fixed != 0),
      minimum(spec.minimum),
      maximum(spec.maximum),
      parsed_default(parsed_value(*this, default_value)) {}

const OptionSpec* Schema::find(std::string_view key) const {
  const auto it = std::find_if(specs_.begin(), specs_.end(), [&](const OptionSpec& spec) { return spec.key == key; });
  return it == specs_.end() ? nullptr : &*it;
}

std::vector<std::string> Schema::keys() const {
  std::vector<std::string> result;
  for (const OptionSpec& spec : specs_) result.push_back(spec.key);
  return result;
}

OptionSpec checked_spec(const rc_component& spec, std::string_view component) {
  const std::string prefix = join(component, ".");
  if (spec.struct_size < first_size<rc_component> || !spec.name || std::strncmp(spec.name, prefix.c_str(), prefix.size()) != 0)
    fail(RC_ERR_PLUGIN, "component \"", component, "\" declares the option \"", spec.name ? spec.name : "",
         "\"; its keys must start with \"", prefix, "\"");
  if (!spec.default_value || !spec.summary || spec.type < RC_TYPE_INT || spec.type > RC_TYPE_TEXT)
    fail(RC_ERR_PLUGIN, "option \"", spec.name, "\" lacks a default, a summary or a type");
  try {
    return OptionSpec(spec);
  } catch (const Error& error) {
    if (error.code() != RC_ERR_OPTION) throw;
    fail(RC_ERR_PLUGIN, "component \"", component, "\": the default of an option does not fit: ", error.what());
  }
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
  if (spec.type == RC_TYPE_INT && std::holds_alternative<double>(value)) {
    constexpr double beyond = 9223372036854775808.0;  // 2^63
    const double number = std::get<double>(value);
    if (number == std::trunc(number)) {
      check_range(spec, number);
      if (number >= -beyond && number < beyond) return static_cast<std::int64_t>(number);
    }
    fail(RC_ERR_OPTION, "option \"", spec.key, "\" takes an integer, not ", number);
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

std::string OptionSet::text_of(const OptionSpec& spec) const {
  const OptionValue& value = get(spec);
  if (const auto* number = std::get_if<std::int64_t>(&value)) return join(*number);
  if (const auto* number = std::get_if<double>(&value)) return exact(*number);
  return std::get<std::string>(value);
}

const OptionValue& OptionSet::get(const OptionSpec& spec) const {
  const auto it = values_.find(spec.key);
  return it != values_.end() ? it->second : spec.parsed_default;
}

}  // namespace rc
