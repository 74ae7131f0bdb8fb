#include "scene.h"

#include <algorithm>
#include <cstring>

namespace errors {

namespace {
constexpr double poison = 12345.678;
}

Answer& answer() {
  static Answer one;
  return one;
}

void Answer::prepare() {
  p_.assign(points, poison);
  gap_.assign(points, poison);
  std::memset(static_cast<void*>(&result_), 0x5a, sizeof result_);
  result_.struct_size = sizeof result_;
  result_.p = {p_.data(), RC_NATIVE, 0, nullptr};
  result_.gap = {gap_.data(), RC_NATIVE, 0, nullptr};
  std::memcpy(static_cast<void*>(&before_), &result_, sizeof result_);
}

bool Answer::untouched() const {
  const auto poisoned = [](double value) { return value == poison; };
  return std::memcmp(&before_, &result_, sizeof result_) == 0 && std::all_of(p_.begin(), p_.end(), poisoned) &&
         std::all_of(gap_.begin(), gap_.end(), poisoned);
}

Scene::Scene() : gap(points) {
  for (std::size_t i = 0; i < gap.size(); ++i) gap[i] = 0.125 * static_cast<double>(i);
  system.nx = system.ny = side;
  step.control = RC_CONTROL_APPROACH;
  step.target = 0.55;
  step.undeformed_gap.data = gap.data();
}

Scene callback_scene(std::int32_t (*apply)(const double*, double*, std::int64_t, void*), void* user) {
  Scene scene;
  scene.system.op = RC_OPERATOR_CALLBACK;
  scene.system.apply = apply;
  scene.system.user = user;
  return scene;
}

OptionsHandle options_with(std::initializer_list<std::pair<const char*, const char*>> settings) {
  rc_options* options = nullptr;
  assert_int_equal(rc_options_create(nullptr, &options), RC_OK);
  for (const auto& [key, value] : settings) assert_int_equal(rc_options_set_text(options, key, value), RC_OK);
  return OptionsHandle(options);
}

rc_status create(const Scene& scene, const rc_options* options) {
  rc_contact* contact = reinterpret_cast<rc_contact*>(answer().result());
  const rc_status status = rc_contact_create(&scene.system, options, &contact);
  if (status < 0) assert_null(contact);
  rc_contact_destroy(contact);
  return status;
}

ContactHandle made(const Scene& scene, const rc_options* options) {
  rc_contact* contact = nullptr;
  assert_int_equal(rc_contact_create(&scene.system, options, &contact), RC_OK);
  return ContactHandle(contact);
}

rc_exchange one_rank() {
  rc_exchange alone = RC_EXCHANGE_INIT;
  alone.gather = [](void*, const void* mine, const std::int64_t* bytes, void* all) -> const char* {
    std::memmove(all, mine, static_cast<std::size_t>(*bytes));
    return nullptr;
  };
  alone.transpose = [](void*, const void*, const std::int64_t*, void*, const std::int64_t*) -> const char* { return "unused"; };
  alone.shift = [](void*, std::int64_t, const void*, std::int64_t, std::int64_t, void*, std::int64_t) -> const char* {
    return "unused";
  };
  return alone;
}

ContactHandle shared(const Scene& scene) {
  const rc_exchange exchange = one_rank();
  rc_contact* contact = nullptr;
  assert_int_equal(rc_ranks_contact_create(&exchange, &scene.system, nullptr, &contact), RC_OK);
  return ContactHandle(contact);
}

rc_status solve(const Scene& scene, const rc_options* options) {
  return rc_solve(&scene.system, &scene.step, options, answer().result());
}
rc_status solve(rc_contact* contact, const Scene& scene) { return rc_contact_solve(contact, &scene.step, answer().result()); }

}  // namespace errors
