// The contents of an rc_options handle: values, and the context whose schema they follow.
#pragma once

#include <memory>

#include "core/options.h"
#include "registry/context.h"

struct rc_options {
  std::shared_ptr<rc::Context> context;
  rc::OptionSet values;

  std::int64_t integer(std::string_view key) const { return values.integer(context->option(key)); }
  double real(std::string_view key) const { return values.real(context->option(key)); }
  const std::string& text(std::string_view key) const { return values.text(context->option(key)); }
  void set(std::string_view key, const rc::OptionValue& value) { values.set(context->option(key), value); }
};
