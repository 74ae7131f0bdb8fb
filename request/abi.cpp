// The exported functions: they check arguments, call, and write results.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "abi/sized_struct.h"
#include "request/guard.h"
#include "request/request.h"

namespace rc::request {

namespace {

void write_word(const Word& word, rc_word* out) {
  rc_word described = RC_WORD_INIT;
  described.name = word.name.data();
  described.group = word.group.data();
  described.form = word.form.data();
  described.help = word.help.data();
  described.choices = word.choices.data();
  described.example = word.example.data();
  described.why_not = word.calls == every_call ? "" : word.why_not.data();
  described.kind = word.kind;
  described.most = word.most;
  described.calls = word.calls;
  write(out, described);
}

void check_spec(const rc_request_spec& spec) {
  const bool one = spec.call > 0 && (spec.call & (spec.call - 1)) == 0;
  if (!one || spec.call > RC_CALL_ROWS) fail(RC_ERR_ARGUMENT, "rc_request_spec.call = ", spec.call, " is not one RC_CALL_*");
  check_switch(spec.numbers, "rc_request_spec.numbers");
  if (spec.spelling < RC_SPELLING_PLAIN || spec.spelling > RC_SPELLING_FIELD)
    fail(RC_ERR_ARGUMENT, "rc_request_spec.spelling = ", spec.spelling, " is not one of RC_SPELLING_*");
  check_reserved(spec.reserved, "rc_request_spec.reserved");
  if (spec.n_words < 0 || (spec.n_words > 0 && !spec.words)) fail(RC_ERR_ARGUMENT, "rc_request_spec.words is null");
  if (spec.n_maps < 0 || (spec.n_maps > 0 && !spec.maps)) fail(RC_ERR_ARGUMENT, "rc_request_spec.maps is null");
  if (spec.n_maps > 0) check_size(spec.maps, "rc_map");
}

void take_system(const rc_system& system, const Words& words, rc_request& request) {
  std::string twice;
  for (const char* const word :
       {"pitch", "unit", "modulus", "E", "nu", "E2", "nu2", "hardness", "creep", "relaxation", "boundary"})
    if (words.find(word)) twice += (twice.empty() ? "" : ", ") + words.spelt(word);
  if (!twice.empty()) fail(RC_ERR_ARGUMENT, twice, " and system are both given; the system has them");
  request.view.system = system;
}

void remark_on_units(const Words& words, const Units& units, rc_request& request) {
  if (!units.si || units.bare.name || units.lengths.empty()) return;
  request.remarks.push_back(
      {RC_REMARK_UNIT, RC_ASSUMED, "unit",
       join("lengths without a unit are taken in m (", units.lengths, "); ", words.spelt("unit"), " names another")});
}

}  // namespace

std::unique_ptr<rc_request> made(const rc_request_spec& spec, const Variation& variation) {
  check_spec(spec);
  auto request = std::make_unique<rc_request>();
  const Words words{spec, variation};
  request->spelling = words.spelling;
  Units units;
  units.si = spec.numbers == RC_NUMBERS_SI;
  if (const Given* const unit = words.find("unit")) {
    units.bare = {unit->text, length_unit(words.spelt("unit"), unit->text)};
    units.si = true;
  }
  for (const Given& given : words.all()) {
    if (given.word && given.word->kind != RC_WORD_OPTION) continue;
    request->options.emplace_back(given.name, given.text ? given.text : exact(given.numbers.front()));
  }
  rc_problem_view& view = request->view;
  view.system = RC_SYSTEM_INIT;
  if (spec.system) {
    take_system(*spec.system, words, *request);
  } else if (spec.call != RC_CALL_ANALYZE) {
    set_elasticity(words, units, *request);
  }
  set_layer(words, units, *request);
  set_creep(words, *request);
  set_flow(words, units, *request);
  set_loading(words, units, !spec.system && spec.call != RC_CALL_ANALYZE, *request);
  set_surface(spec, words, units, variation, *request);
  remark_on_units(words, units, *request);
  if (!spec.system) set_boundary(words, *request);
  view.metres = units.bare.metres;
  if (!request->maps.empty()) {
    const Map& map = request->maps.front();
    view.heights = map.z;
    view.mask = map.mask;
    view.maps = map.maps;
    if (map.has_unit) view.metres = map.unit;
  }
  view.loading = request->loading.empty() ? nullptr : request->loading.c_str();
  view.targets = request->targets.data();
  view.n = std::ssize(request->targets);
  view.times = request->times.empty() ? nullptr : request->times.data();
  view.n_times = std::ssize(request->times);
  view.si = units.si ? 1 : 0;
  view.format = request->format.c_str();
  return request;
}

namespace {

// The note, with the words that help against what it doubts.
std::string with_words(const Spelling& spelling, std::string note) {
  const std::pair<std::string_view, std::string> helps[] = {
      {"level them", join(" with ", spelling.value("remove", "plane"))},
      {"the map for a spike", join(", which ", spelling.value("despike", "10"), " takes out")}};
  for (const auto& [doubt, help] : helps)
    if (const auto place = note.find(doubt); place != note.npos) note.insert(place + doubt.size(), help);
  return note;
}

rc_smooth smooth_of(const rc_request& request, double load) {
  rc_smooth found = RC_SMOOTH_INIT;
  smooth_contact(*request.shape, request.view.system, load, request.view.si == 1, found);
  return found;
}

}  // namespace

}  // namespace rc::request

using namespace rc;           // NOLINT: this file is the bridge
using namespace rc::request;  // NOLINT

const char* rc_request_last_error(void) {
  const char* const message = own_message<rc::request::Library>;
  return *message == ':' ? message + 2 : message;
}

int64_t rc_word_count(void) { return std::ssize(all_words()); }

rc_status rc_word_describe(int64_t index, rc_word* out) {
  return rc::request::guard([&] {
    check_size(out, "rc_word");
    if (index < 0 || index >= rc_word_count()) fail(RC_ERR_ARGUMENT, "index = ", index, " is not in 0 .. ", rc_word_count() - 1);
    write_word(all_words()[static_cast<std::size_t>(index)], out);
  });
}

rc_status rc_request_create(const rc_request_spec* spec, rc_request** out) {
  return rc::request::guard([&] {
    const rc_request_spec defaults = RC_REQUEST_SPEC_INIT;
    const rc_request_spec given = read(spec, "rc_request_spec", defaults);
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    *out = made(given, {}).release();
  });
}

void rc_request_destroy(rc_request* request) { delete request; }

rc_status rc_request_problem(const rc_request* request, rc_problem_view* out) {
  return rc::request::guard([&] {
    if (!request) fail(RC_ERR_ARGUMENT, "request is null");
    check_size(out, "rc_problem_view");
    write(out, request->view);
  });
}

rc_status rc_request_options(const rc_request* request, rc_options* into) {
  return rc::request::guard([&] {
    if (!request || !into) fail(RC_ERR_ARGUMENT, request ? "into is null" : "request is null");
    for (const auto& [key, text] : request->options) {
      const rc_status status = rc_options_set_text(into, key.c_str(), text.c_str());
      if (status == RC_OK) continue;
      const std::string_view message = rc_last_error();
      fail(status, message.substr(message.find(": ") + 2));
    }
  });
}

int64_t rc_request_option_count(const rc_request* request) { return request ? std::ssize(request->options) : 0; }

rc_status rc_request_option(const rc_request* request, int64_t index, const char** key, const char** text) {
  return rc::request::guard([&] {
    if (!request) fail(RC_ERR_ARGUMENT, "request is null");
    if (!key || !text) fail(RC_ERR_ARGUMENT, key ? "text is null" : "key is null");
    const std::int64_t count = rc_request_option_count(request);
    if (index < 0 || index >= count) fail(RC_ERR_ARGUMENT, "index = ", index, " is not below ", count);
    const auto& [name, value] = request->options[static_cast<std::size_t>(index)];
    *key = name.c_str();
    *text = value.c_str();
  });
}

int64_t rc_request_remark_count(const rc_request* request) { return request ? std::ssize(request->remarks) : 0; }

rc_status rc_request_remark(const rc_request* request, int64_t index, rc_remark* out) {
  return rc::request::guard([&] {
    if (!request) fail(RC_ERR_ARGUMENT, "request is null");
    check_size(out, "rc_remark");
    const std::int64_t count = rc_request_remark_count(request);
    if (index < 0 || index >= count) fail(RC_ERR_ARGUMENT, "index = ", index, " is not below ", count);
    const rc_request::Remark& found = request->remarks[static_cast<std::size_t>(index)];
    rc_remark remark = RC_REMARK_INIT;
    remark.code = found.code;
    remark.severity = found.severity;
    remark.word = found.word.c_str();
    remark.text = found.text.c_str();
    std::ranges::copy(found.number, remark.number);
    write(out, remark);
  });
}

rc_status rc_request_smooth(const rc_request* request, double load, rc_smooth* out) {
  return rc::request::guard([&] {
    if (!request) fail(RC_ERR_ARGUMENT, "request is null");
    check_size(out, "rc_smooth");
    if (!request->shape) fail(RC_ERR_ARGUMENT, "no shape was named");
    const rc_system& s = request->view.system;
    if (s.op != RC_OPERATOR_HALFSPACE || request->layered || s.creep_terms > 0)
      fail(RC_ERR_ARGUMENT, "the system is no homogeneous elastic half-space");
    if (!(load >= 0) || !std::isfinite(load)) fail(RC_ERR_ARGUMENT, "load = ", load, " must be 0 or more, and finite");
    write(out, smooth_of(*request, load));
  });
}

rc_status rc_request_note(const rc_request* request, const char* note, double load, size_t size, char* text) {
  return rc::request::guard([&] {
    if (!request || !note || !text || size == 0) fail(RC_ERR_ARGUMENT, "request, note or text is null, or size 0");
    std::string all = with_words(request->spelling, note);
    const rc_system& system = request->view.system;
    const bool hertz = system.op == RC_OPERATOR_HALFSPACE && !request->layered && system.creep_terms == 0;
    if (request->shape && hertz && load > 0) {
      const std::string remark = smooth_of(*request, load).remark;
      all += (all.empty() || remark.empty() ? "" : "; ") + remark;
    }
    std::snprintf(text, size, "%s", all.c_str());
  });
}
