#include "surface/input.h"

#include "formats/error.h"
#include "formats/registry.h"
#include "platform/files.h"
#include "text.h"

namespace cli {

Request make_request(const GivenWords& words, std::int32_t call, const rc_map* maps, std::int64_t n_maps) {
  std::vector<rc_given> given = words.of_request();
  std::erase_if(given, [&](const rc_given& each) {
    for (std::int64_t k = 0; k < n_maps; ++k)
      if (std::string_view(maps[k].word) == each.word) return true;
    return false;
  });
  rc_request_spec spec = RC_REQUEST_SPEC_INIT;
  spec.call = call;
  spec.spelling = RC_SPELLING_OPTION;
  spec.words = given.data();
  spec.n_words = std::ssize(given);
  spec.maps = maps;
  spec.n_maps = n_maps;
  rc_request* request = nullptr;
  if (rc_request_create(&spec, &request) != RC_OK) {
    rc::formats::silence_hdf5();  // else it prints when the command ends after a damaged file
    throw Error(rc_request_last_error());
  }
  return {request, Destroy<rc_request_destroy>{}};
}

rc_problem_view problem_of(const Request& request) {
  rc_problem_view view = RC_PROBLEM_VIEW_INIT;
  if (rc_request_problem(request.get(), &view) != RC_OK) throw Error(rc_request_last_error());
  return view;
}

std::string SurfaceInput::preparation() const {
  std::string text;
  if (!against.empty()) text += ", against " + rc_platform::path_of(against).filename().string();
  if (removed != "none") text += ", " + removed + " removed";
  if (missing > 0) {
    text += rc::formats::format(", %lld missing point%s %s", static_cast<long long>(missing), missing == 1 ? "" : "s",
                                missing_rule == "fill" ? "filled" : "excluded");
  }
  if (!shape.empty()) text += ", shape " + shape;
  for (const auto& [word, value] : words)
    if (word == "layer" || word == "creep" || word == "relaxation") text += ", " + word + " " + value;
  return text;
}

std::string SurfaceInput::assumptions() const {
  std::string text;
  for (const std::string& each : assumed) text += (text.empty() ? "" : "; ") + each;
  return text;
}

SurfaceInput input_of(const GivenWords& words, Request request) {
  SurfaceInput input;
  const rc_problem_view view = problem_of(request);
  const rc_system& system = view.system;
  input.file = words.surface;
  for (std::size_t k = 0; k < words.texts.size(); ++k)
    if (words.texts[k]) input.words.emplace_back(all_words()[k].name, *words.texts[k]);
  input.format = view.format;
  input.against = words["against"].value_or("");
  input.shape = words["shape"].value_or("");
  input.removed = words["remove"].value_or("none");
  input.missing_rule = words["missing"].value_or("reject");
  input.missing = view.missing;
  input.mask = view.mask;
  input.surface = {system.nx, system.ny, system.hx, system.hy, {}, {}};
  if (view.heights) input.surface.heights = {view.heights, static_cast<std::size_t>(system.nx * system.ny)};
  if (view.periodic >= 0) input.surface.periodic = view.periodic == 1;
  for (std::int64_t k = 0; k < rc_request_remark_count(request.get()); ++k) {
    rc_remark remark = RC_REMARK_INIT;
    if (rc_request_remark(request.get(), k, &remark) != RC_OK) throw Error(rc_request_last_error());
    const std::string text = remark.text;
    input.assumed.push_back(text);
    const bool seen = remark.code == RC_REMARK_MISSING || remark.code == RC_REMARK_PITCH || remark.code == RC_REMARK_ENDS;
    if (seen && remark.severity == RC_FACT) continue;  // in the first line
    input.notes.push_back((remark.severity == RC_DOUBTFUL ? "remark: " : "note: ") + text);
  }
  input.request = std::move(request);
  return input;
}

}  // namespace cli
