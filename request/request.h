// A request: the words as given, the problem that they mean, and remarks.
#pragma once

#include <roughcontact/request.h>

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "request/maps.h"
#include "request/shapes.h"
#include "request/variation.h"
#include "request/words.h"

struct rc_request {
  rc_problem_view view = RC_PROBLEM_VIEW_INIT;
  std::deque<rc::request::Map> maps;  // whose heights and mask the view has
  std::vector<double> targets, times;
  std::vector<double> creep_ratio, creep_time;  // that the view's system has
  std::string loading, format;
  std::optional<rc::request::Shape> shape;
  rc::request::Spelling spelling;
  std::vector<std::pair<std::string, std::string>> options;
  bool layered = false, against = false, shaped = false;  // whether there is a layer, another body, a shape of the caller

  struct Remark {
    int32_t code, severity;
    std::string word, text;
    double number[3] = {0, 0, 0};
  };
  std::vector<Remark> remarks;
};

namespace rc::request {

// Every bare length and every unit among words and maps.
struct Units {
  BareUnit bare;
  bool si = false;
  std::string lengths;  // without a unit, for the remark: "heights of surface.npy, --pitch"

  void add(const std::string& what) { lengths += (lengths.empty() ? "" : ", ") + what; }
  void see(const std::vector<Quantity>& quantities);
};

// The contact modulus of both bodies, and the hardness. Doubts about them go into the remarks.
void set_elasticity(const Words& words, Units& units, rc_request& request);
void set_layer(const Words& words, Units& units, rc_request& request);
// The words creep and relaxation.
void set_creep(const Words& words, rc_request& request);
// The targets and times of the words steps, time and all that press. needed: whether it is an error if nothing presses.
void set_loading(const Words& words, Units& units, bool needed, rc_request& request);
// The words leak and closing-pressure.
void set_flow(const Words& words, Units& units, rc_request& request);
void set_boundary(const Words& words, rc_request& request);

// Reads the maps and does to them what the words say; sets the grid.
void set_surface(const rc_request_spec& spec, const Words& words, Units& units, const Variation& variation, rc_request& request);

// The request that a specification means, with a change.
std::unique_ptr<rc_request> made(const rc_request_spec& spec, const Variation& variation);

}  // namespace rc::request
