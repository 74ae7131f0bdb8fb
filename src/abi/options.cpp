// rc_options_*
#include "abi/guard.h"
#include "abi/handles.h"
#include "abi/sized_struct.h"

namespace {

using namespace rc;

template <class Body> rc_status with_spec(const char* where, const rc_options* options, const char* key, const Body& body) {
  return guard(where, [&] {
    if (!options || !key) fail(RC_ERR_ARGUMENT, options ? "key" : "options", " is null");
    body(options->context->option(key));
    return RC_OK;
  });
}

template <class Type> rc_status get(const char* where, const rc_options* options, const char* key, Type* out) {
  return with_spec(where, options, key, [&](const OptionSpec& spec) {
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    const Type* value = std::get_if<Type>(&options->values.get(spec));
    if (!value) fail(RC_ERR_OPTION, "option \"", key, "\" has another type");
    *out = *value;
  });
}

}  // namespace

extern "C" {

rc_status rc_options_create(rc_context* context, rc_options** out) {
  return guard("rc_options_create", [&] {
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    *out = nullptr;
    *out = new rc_options{context_of(context), {}};
    return RC_OK;
  });
}

rc_status rc_options_copy(const rc_options* options, rc_options** out) {
  return guard("rc_options_copy", [&] {
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    *out = nullptr;
    if (!options) fail(RC_ERR_ARGUMENT, "options is null");
    *out = new rc_options(*options);
    return RC_OK;
  });
}

void rc_options_destroy(rc_options* options) { delete options; }

rc_status rc_options_set_int(rc_options* options, const char* key, int64_t value) {
  return with_spec("rc_options_set_int", options, key, [&](const OptionSpec& spec) { options->values.set(spec, value); });
}
rc_status rc_options_set_real(rc_options* options, const char* key, double value) {
  return with_spec("rc_options_set_real", options, key, [&](const OptionSpec& spec) { options->values.set(spec, value); });
}
rc_status rc_options_set_text(rc_options* options, const char* key, const char* value) {
  return with_spec("rc_options_set_text", options, key, [&](const OptionSpec& spec) {
    if (!value) fail(RC_ERR_ARGUMENT, "value is null");
    options->values.set(spec, std::string(value));
  });
}
rc_status rc_options_parse(rc_options* options, const char* key, const char* text) {
  return with_spec("rc_options_parse", options, key, [&](const OptionSpec& spec) {
    if (!text) fail(RC_ERR_ARGUMENT, "text is null");
    options->values.set(spec, parsed_value(spec, text));
  });
}

rc_status rc_options_get_int(const rc_options* options, const char* key, int64_t* out) {
  return get("rc_options_get_int", options, key, out);
}
rc_status rc_options_get_real(const rc_options* options, const char* key, double* out) {
  return get("rc_options_get_real", options, key, out);
}
rc_status rc_options_get_text(const rc_options* options, const char* key, const char** out) {
  return with_spec("rc_options_get_text", options, key, [&](const OptionSpec& spec) {
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    const std::string* value = std::get_if<std::string>(&options->values.get(spec));
    if (!value) fail(RC_ERR_OPTION, "option \"", key, "\" has another type");
    *out = value->c_str();
  });
}

int64_t rc_options_count(rc_context* context) {
  int64_t count = 0;
  guard("rc_options_count", [&] {
    count = static_cast<int64_t>(context_of(context)->options().size());
    return RC_OK;
  });
  return count;
}

rc_status rc_options_describe(rc_context* context, int64_t i, rc_option_spec* out) {
  return guard("rc_options_describe", [&] {
    check_size(out, "rc_option_spec");
    const auto all = context_of(context)->options();
    if (i < 0 || i >= static_cast<int64_t>(all.size()))
      fail(RC_ERR_ARGUMENT, "i = ", i, ": there are ", all.size(), " options, numbered from 0");
    const OptionSpec& spec = *all[static_cast<std::size_t>(i)];
    write(out, rc_option_spec{sizeof(rc_option_spec), spec.key.c_str(), spec.default_value.c_str(),
                              spec.choices.empty() ? nullptr : spec.choices_text.c_str(), spec.help.c_str(), spec.type,
                              spec.fixed ? 1 : 0, spec.minimum, spec.maximum});
    return RC_OK;
  });
}

}  // extern "C"
