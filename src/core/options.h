// Options: keys with a declared schema. A value is checked when it is set, so a solve never meets a bad one.
#pragma once

#include <deque>
#include <map>
#include <roughcontact/plugin.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rc {

using OptionValue = std::variant<std::int64_t, double, std::string>;

struct OptionSpec {
  explicit OptionSpec(const rc_component& spec);  // throws Error(RC_ERR_OPTION) where the default does not fit

  std::string key, default_value, help;
  std::vector<std::string> choices;  // text only; empty: any text
  std::string choices_text;
  int type;
  bool fixed;
  double minimum, maximum;
  OptionValue parsed_default;
};

using roughcontact::int_option, roughcontact::real_option, roughcontact::text_option;

// The declared keys. Grows as components are loaded; entries never move.
class Schema {
 public:
  void add(const OptionSpec& spec) { specs_.push_back(spec); }
  void shrink(std::size_t size) { specs_.erase(specs_.begin() + static_cast<std::ptrdiff_t>(size), specs_.end()); }
  const OptionSpec* find(std::string_view key) const;
  std::size_t size() const { return specs_.size(); }
  const OptionSpec& operator[](std::size_t i) const { return specs_[i]; }
  std::vector<std::string> keys() const;

 private:
  std::deque<OptionSpec> specs_;
};

// The core's own keys.
std::vector<OptionSpec> core_options();

// Checks a component's description of an option; throws Error(RC_ERR_PLUGIN).
OptionSpec checked_spec(const rc_component& spec, std::string_view component);

// Converts and checks; throws Error(RC_ERR_OPTION).
OptionValue checked_value(const OptionSpec& spec, const OptionValue& value);
OptionValue parsed_value(const OptionSpec& spec, std::string_view text);

// Values that differ from the defaults.
class OptionSet {
 public:
  void set(const OptionSpec& spec, const OptionValue& value);
  // The value, or the default. The reference lives until the key is set again.
  const OptionValue& get(const OptionSpec& spec) const;
  std::int64_t integer(const OptionSpec& spec) const { return std::get<std::int64_t>(get(spec)); }
  double real(const OptionSpec& spec) const { return std::get<double>(get(spec)); }
  std::string text_of(const OptionSpec& spec) const;  // the value of an option of any type; numbers are exact
  const std::string& text(const OptionSpec& spec) const { return std::get<std::string>(get(spec)); }

 private:
  std::map<std::string, OptionValue, std::less<>> values_;
};

}  // namespace rc
