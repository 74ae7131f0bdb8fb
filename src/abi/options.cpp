// rc_options_*
#include "abi/guard.h"
#include "abi/handles.h"

namespace {

using namespace rc;

template <class Body> rc_status with_spec(const char* where, const rc_options* options, const char* key, const Body& body) {
  return guard(where, [&] {
    if (!options || !key) fail(RC_ERR_ARGUMENT, options ? "key" : "options", " is null");
    body(options->context->option(key));
    return RC_OK;
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

rc_status rc_options_set_number(rc_options* options, const char* key, double value) {
  return with_spec("rc_options_set_number", options, key, [&](const OptionSpec& spec) { options->values.set(spec, value); });
}

rc_status rc_options_set_text(rc_options* options, const char* key, const char* text) {
  return with_spec("rc_options_set_text", options, key, [&](const OptionSpec& spec) {
    if (!text) fail(RC_ERR_ARGUMENT, "text is null");
    options->values.set(spec, parsed_value(spec, text));
  });
}

rc_status rc_options_get_number(const rc_options* options, const char* key, double* out) {
  return with_spec("rc_options_get_number", options, key, [&](const OptionSpec& spec) {
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    if (spec.type == RC_TYPE_TEXT) fail(RC_ERR_OPTION, "option \"", key, "\" is a text; use rc_options_get_text");
    *out = spec.type == RC_TYPE_INT ? static_cast<double>(options->values.integer(spec)) : options->values.real(spec);
  });
}

rc_status rc_options_get_text(const rc_options* options, const char* key, const char** out) {
  return with_spec("rc_options_get_text", options, key, [&](const OptionSpec& spec) {
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    if (spec.type != RC_TYPE_TEXT) fail(RC_ERR_OPTION, "option \"", key, "\" is a number; use rc_options_get_number");
    *out = options->values.text(spec).c_str();
  });
}

}  // extern "C"
