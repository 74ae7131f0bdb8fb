#include "world.h"

#include <roughcontact/budget.h>
#include <roughcontact/direct.h>
#include <roughcontact/flow.h>
#include <roughcontact/formats.h>
#include <roughcontact/registry.h>
#include <roughcontact/request.h>
#include <roughcontact/surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <map>

namespace errors {

namespace {

struct Field {
  std::size_t offset;
  std::type_index type;
  std::size_t count;
};
template <class T> Field field(std::size_t offset) {
  using Element = std::remove_all_extents_t<T>;
  using Plain = std::conditional_t<std::is_enum_v<Element>, std::int32_t, Element>;
  return {offset, typeid(Plain), sizeof(T) / sizeof(Element)};
}

const std::map<std::pair<std::type_index, std::string>, Field>& fields() {
  static const std::map<std::pair<std::type_index, std::string>, Field> all = {
#define FIELD(structure, member) {{typeid(structure), #member}, field<decltype(structure::member)>(offsetof(structure, member))},
#include "fields.inc"
#undef FIELD
  };
  return all;
}

const std::map<std::string, std::int64_t>& constants() {
  static const std::map<std::string, std::int64_t> all = {
#define VALUE(name) {#name, static_cast<std::int64_t>(name)},
#include "fields.inc"
#undef VALUE
  };
  return all;
}

std::int32_t diagonal(const double* x, double* y, std::int64_t n, void* user) {
  World& world = *static_cast<World*>(user);
  std::copy(x, x + n, y);
  ++world.products;
  const auto reached = [&](std::int64_t at) { return at > 0 && world.products >= at; };
  if (reached(world.memory.nan_at)) y[n / 2] = nan;
  return reached(world.memory.fails_at);
}
std::int32_t negative(const double* x, double* y, std::int64_t n, void*) {
  std::transform(x, x + n, y, std::negate<>());
  return 0;
}
// Neighbours attract more than a point resists: eigenvalues 3 and -1.
std::int32_t indefinite(const double* x, double* y, std::int64_t n, void*) {
  for (std::int64_t i = 0; i < n; ++i) y[i] = x[i] + 2 * x[i ^ 1];
  return 0;
}
std::int32_t sums(const double* x, double* y, std::int64_t n, void*) {
  double sum = 0;
  for (std::int64_t i = 0; i < n; ++i) sum += x[i];
  for (std::int64_t i = 0; i < n; ++i) y[i] = x[i] + sum;
  return 0;
}

}  // namespace

template <class T> void World::place(const char* name, T& value) {
  const Field all = field<T>(0);
  places_.push_back({name, {&value, all.type, all.count}});
}

World::World() : start(2) {
  Memory& m = memory;
  for (std::size_t i = 0; i < 3 * points; ++i) m.gaps[i] = scene.gap[i % points];
  for (auto* ones : {m.p, m.by_p, m.by_gap, m.change}) std::fill_n(ones, points, 1.0);
  std::fill_n(m.mask, points, std::uint8_t{1});
  std::copy_n(std::initializer_list<double>{0.2, 0.4, 0.55}.begin(), 3, m.targets);
  for (std::size_t i = 0; i < 6; ++i) m.batch_targets[i] = m.targets[i % 2];
  std::copy_n(std::initializer_list<double>{2, 1, 1, 2}.begin(), 4, m.H);
  m.u[0] = m.u[1] = 1;
  for (auto* out : {m.out, m.dp, m.dgap, m.w}) std::fill_n(out, points, untouched);
  std::fill_n(m.load, 6, untouched);
  std::fill_n(m.label, points, -7);
  std::fill_n(m.counts, 4, -7);
  const rc_const_array gap = RC_IN(scene.gap.data()), mask = RC_IN(m.mask);

  m.history = RC_HISTORY_INIT;
  m.history.control = RC_CONTROL_APPROACH;
  m.history.n = 3;
  m.history.targets = RC_IN(m.targets);
  m.history.undeformed_gap = gap;
  m.history.columns.load = RC_OUT(m.load);
  m.history.completed = 99;
  m.batch = RC_BATCH_INIT;
  m.batch.control = RC_CONTROL_APPROACH;
  m.batch.n = 3;
  m.batch.steps = 2;
  m.batch.targets = RC_IN(m.batch_targets);
  m.batch.undeformed_gap = RC_IN(m.gaps);
  m.batch.columns.load = RC_OUT(m.load);
  m.batch.written = 99;
  m.state = RC_STATE_INIT;
  m.state.undeformed_gap = gap;
  m.state.mask = mask;
  m.state.p = RC_IN(m.p0);
  m.gradient = RC_GRADIENT_INIT;
  m.gradient.dJ_dp = RC_IN(m.by_p);
  m.gradient.dJ_dgap = RC_IN(m.by_gap);
  m.gradient.dJ_dundeformed_gap = RC_OUT(m.out);
  m.tangent = RC_TANGENT_INIT;
  m.tangent.dundeformed_gap = RC_IN(m.change);
  m.tangent.dp = RC_OUT(m.dp);
  m.tangent.dgap = RC_OUT(m.dgap);
  m.area = RC_AREA_INIT;
  m.patches = RC_PATCHES_INIT;
  m.patches.room = m.levels = 4;
  m.patches.label = RC_OUT(m.label);
  m.patches.load = RC_OUT(m.out);
  m.histogram = RC_HISTOGRAM_INIT;
  m.histogram.bins = 4;
  m.histogram.counts = RC_OUT(m.counts);
  m.histogram.density = RC_OUT(m.dp);
  m.found = RC_RESULT_INIT;
  m.found.stiffness = 3;
  m.found.homogeneous = 1;
  m.found.p = RC_OUT(m.p0);
  m.law_spec = RC_LAW_SPEC_INIT;
  m.law_spec.undeformed_gap = gap;
  m.law_spec.mask = mask;
  m.law_spec.p_lower = 0.01;
  m.law_spec.p_upper = 0.1;
  m.law_spec.tolerance = 0.05;
  m.law_export_spec = RC_LAW_EXPORT_SPEC_INIT;
  m.law_export_spec.format = RC_LAW_CALCULIX;
  m.slip = m.slipped = RC_LAW_SLIP_STATE_INIT;
  m.slip.mu = m.slip.nu = 0.3;
  m.from = RC_IN(m.p);
  m.to = RC_OUT(m.w);
  m.plugin = {sizeof(rc_plugin), RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR, "mine", "1.0", 0, 0, 0, nullptr, nullptr, nullptr};
  m.n = m.ld = 2;
  m.max_iter = 100;
  m.levels = m.rho1 = 1;
  m.tol = 1e-8;
  m.radius = m.rho2 = 2;
  m.approach = 0.5;
  m.x = 0.1;
  m.kernel = "love";
  m.solver = "nnls";
  m.backend = "callback";
  m.at_x = m.at_y = -1;
  m.caps = RC_KERNEL_FREE | RC_KERNEL_PERIODIC | RC_KERNEL_POSITIVE;

  place("system", scene.system);
  place("step", scene.step);
  place("result", *answer().result());
  places_.push_back({"gap", {scene.gap.data(), typeid(double), points}});
#define PLACE(name) place(#name, m.name)
  PLACE(history), PLACE(batch), PLACE(state), PLACE(gradient), PLACE(tangent), PLACE(patches), PLACE(histogram), PLACE(found);
  PLACE(law_spec), PLACE(law_export_spec), PLACE(slip), PLACE(from), PLACE(to), PLACE(plugin), PLACE(gaps), PLACE(p), PLACE(p0);
  PLACE(by_p), PLACE(by_gap), PLACE(change), PLACE(heights), PLACE(targets), PLACE(batch_targets), PLACE(H), PLACE(u);
  PLACE(mask), PLACE(n), PLACE(ld), PLACE(max_iter), PLACE(levels), PLACE(room), PLACE(i), PLACE(written), PLACE(fails_at);
  PLACE(nan_at), PLACE(kind), PLACE(flags), PLACE(tol), PLACE(radius), PLACE(approach), PLACE(rho1), PLACE(rho2), PLACE(x);
  PLACE(along), PLACE(number), PLACE(kernel), PLACE(solver), PLACE(backend), PLACE(key), PLACE(text), PLACE(at_x), PLACE(at_y);
  PLACE(value), PLACE(lowest), PLACE(share), PLACE(caps);
#undef PLACE
}

World::Place World::find(const std::string& path) {
  const std::size_t bracket = path.find('[');
  std::string rest = path.substr(0, bracket) + '.';
  Place at{nullptr, typeid(void), 0};
  for (std::size_t dot; (dot = rest.find('.')) != std::string::npos; rest.erase(0, dot + 1)) {
    const std::string name = rest.substr(0, dot);
    if (!at.at) {
      const auto found = std::find_if(places_.begin(), places_.end(), [&](const auto& place) { return place.first == name; });
      if (found == places_.end()) fail_msg("%s: nothing has this name", path.c_str());
      at = found->second;
    } else {
      const auto found = fields().find({at.type, name});
      if (found == fields().end()) fail_msg("%s: no such member", path.c_str());
      at = {static_cast<char*>(at.at) + found->second.offset, found->second.type, found->second.count};
    }
  }
  if (bracket == std::string::npos) return at;
  const auto index = std::strtoull(path.c_str() + bracket + 1, nullptr, 10);
  assert_true(index < at.count);
  const std::size_t size = at.type == typeid(std::uint8_t) ? 1 : 8;
  return {static_cast<char*>(at.at) + size * index, at.type, 1};
}

void World::store(const Place& place, const std::string& value) {
  const auto constant = constants().find(value);
  const std::int64_t whole = constant != constants().end() ? constant->second : std::strtoll(value.c_str(), nullptr, 10);
  const auto put = [&](auto number) {
    for (std::size_t i = 0; i < place.count; ++i)
      std::memcpy(static_cast<char*>(place.at) + i * sizeof number, &number, sizeof number);
  };
  const char* const text = texts_.emplace_back(value).c_str();
  if (place.type == typeid(double))
    put(std::strtod(text, nullptr));
  else if (place.type == typeid(std::int64_t))
    put(whole);
  else if (place.type == typeid(std::int32_t))
    put(static_cast<std::int32_t>(whole));
  else if (place.type == typeid(std::uint32_t))
    put(static_cast<std::uint32_t>(whole));
  else if (place.type == typeid(std::uint64_t) || place.type == typeid(std::size_t))
    put(static_cast<std::size_t>(whole));
  else if (place.type == typeid(std::uint8_t))
    put(static_cast<std::uint8_t>(whole));
  else if (place.type == typeid(char))
    std::memcpy(place.at, text, std::min(place.count, value.size() + 1));
  else if (value == "null")
    put(static_cast<void*>(nullptr));
  else if (place.type == typeid(const char*))
    put(text);
  else
    put(find(value).at);  // a pointer to what has this name
}

void World::set(const std::string& word) {
  const std::size_t equals = word.find('=');
  const std::string path = word.substr(0, equals);
  std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
  for (const auto& [escape, letter] : {std::pair("\\_", " "), std::pair("\\n", "\n")})
    for (std::size_t at; (at = value.find(escape)) != std::string::npos;) value.replace(at, 2, letter);
  if (path == "dense") {
    if (value.empty()) value = "1.1,.1,.1,.1,.1,1.1,.1,.1,.1,.1,1.1,.1,.1,.1,.1,1.1";
    scene.dense.clear();
    for (const char* at = value.c_str(); *at;) {
      char* end = nullptr;
      scene.dense.push_back(std::strtod(at, &end));
      at = *end ? end + 1 : end;
    }
    scene.system.op = RC_OPERATOR_DENSE;
    scene.system.dense = scene.dense.data();
    scene.system.nx = scene.system.dense_ld = std::lround(std::sqrt(static_cast<double>(scene.dense.size())));
    scene.system.ny = 1;
  } else if (path == "callback") {
    const std::map<std::string, decltype(rc_system::apply)> all = {
        {"diagonal", diagonal}, {"negative", negative}, {"indefinite", indefinite}, {"sums", sums}, {"null", nullptr}};
    scene.system.op = RC_OPERATOR_CALLBACK;
    scene.system.apply = all.at(value);
    scene.system.user = this;
  } else if (path.rfind("options.", 0) == 0) {
    options_.emplace_back(path.substr(8), value);
  } else {
    store(find(path), value);
    if (path.rfind("mask", 0) == 0) scene.step.mask = RC_IN(memory.mask);
    if (path.rfind("p0", 0) == 0) scene.step.p0 = RC_IN(memory.p0);
  }
}

OptionsHandle World::options_of(rc_context* context) const {
  rc_options* made = nullptr;
  assert_int_equal(rc_options_create(context, &made), RC_OK);
  OptionsHandle options(made);
  for (const auto& [key, value] : options_) assert_int_equal(rc_options_set_text(made, key.c_str(), value.c_str()), RC_OK);
  return options;
}
OptionsHandle World::options() const { return options_of(nullptr); }

void World::check_untouched() const { assert_memory_equal(&memory, &before_, sizeof memory); }

}  // namespace errors
