// All that the calls of the table take: valid, until the words of a row spoil it.
#pragma once

#include <roughcontact/analysis.h>
#include <roughcontact/derivatives.h>
#include <roughcontact/history.h>
#include <roughcontact/law.h>
#include <roughcontact/plugin.h>

#include <deque>
#include <string>
#include <typeindex>
#include <vector>

#include "scene.h"

namespace errors {

// Numbers, structs and arrays, without pointers into themselves: a call that fails must leave all bytes as they were.
struct Memory {
  rc_history history;
  rc_batch batch;
  rc_state state;
  rc_gradient gradient;
  rc_tangent tangent;
  rc_area area;
  rc_patches patches;
  rc_histogram histogram;
  rc_result found;
  rc_law_spec law_spec;
  rc_law_export_spec law_export_spec;
  rc_law_slip_state slip, slipped;
  rc_const_array from;
  rc_array to;
  rc_plugin plugin;
  double gaps[3 * points], p[points], p0[points], by_p[points], by_gap[points], change[points], heights[points];
  double targets[3], batch_targets[6], H[4], u[2];
  double load[6], out[points], dp[points], dgap[points], w[points];  // for outputs
  std::uint8_t mask[points];
  std::int64_t label[points], counts[4];
  std::int32_t contact_crosses, gap_crosses;
  std::int64_t n, ld, max_iter, levels, room, i, written, fails_at, nan_at;
  std::int32_t kind, flags;
  double tol, radius, approach, rho1, rho2, x, along, number;
  const char *kernel, *solver, *backend, *key, *text;
  // A kernel of deflections that decay, but for one value and what it promises.
  std::int64_t at_x, at_y;
  double value, lowest, share;
  std::uint64_t caps;
};

class World {
 public:
  World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  // "system.nx=0", "gap[3]=nan", "mask=0", "options.solver=nnls", "dense", "callback=diagonal"
  void set(const std::string& word);
  void begin_call() { products = 0, before_ = memory; }
  void check_untouched() const;
  OptionsHandle options() const;
  OptionsHandle options_of(rc_context* context) const;

  Scene scene;
  Memory memory{};
  std::vector<double> start;  // what the direct routines change
  std::int64_t products = 0;  // of the callback

 private:
  struct Place {
    void* at;
    std::type_index type;
    std::size_t count;
  };
  template <class T> void place(const char* name, T& value);
  void store(const Place& place, const std::string& value);
  Place find(const std::string& path);

  std::vector<std::pair<std::string, Place>> places_;
  std::vector<std::pair<std::string, std::string>> options_;
  std::deque<std::string> texts_;
  Memory before_{};
};

}  // namespace errors
