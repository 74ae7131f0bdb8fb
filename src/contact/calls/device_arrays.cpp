#include "contact/calls/device_arrays.h"

#include <algorithm>

#include "contact/problem.h"
#include "core/error.h"

namespace rc {

namespace {

// The memory of a device in which an array of the caller lies.
class Device {
 public:
  Device(const GridProblem& problem, const char* name, const char* array)
      : problem_(problem), backend_(problem.options.context->backend(name)) {
    if (!backend_.fetch || !backend_.store)
      fail(RC_ERR_INCOMPATIBLE, array, ".memory = \"", name,
           "\": this backend has no device with a memory of its own; name one that has (\"cuda\"), or null for arrays in "
           "the host's memory");
  }

  void fetch(void* to, const void* from, std::size_t bytes) const {
    clear_message();
    raise_if_failed(backend_.fetch(&problem_.host, &problem_.options, to, from, static_cast<std::int64_t>(bytes)),
                    "copying from the device");
  }
  void store(void* to, const void* from, std::size_t bytes) const {
    clear_message();
    raise_if_failed(backend_.store(&problem_.host, &problem_.options, to, from, static_cast<std::int64_t>(bytes)),
                    "copying to the device");
  }

 private:
  const GridProblem& problem_;
  const rc_backend& backend_;
};

bool refers_to(const StepSurface& surface, const HostCopies& copies) {
  const void *const gap = surface.gap().array().data, *const mask = surface.mask().data();
  return (gap && gap == copies.gap.get()) || (mask && mask == copies.mask.get());
}

template <class... Arrays> bool any_on_device(const Arrays&... arrays) { return (... || (arrays.memory != nullptr)); }

}  // namespace

OnHost::OnHost(GridProblem& problem, HeldCopies& held, const rc_step& given, const Outputs& wanted, bool judged)
    : step(given), outputs(wanted), problem_(problem), held_(held), judged_(judged) {
  if (!any_on_device(step.undeformed_gap, step.mask, step.p0, outputs.p.array, outputs.gap.array)) return;
  held_.push_back(std::make_unique<HostCopies>());
  HostCopies& copies = *held_.back();
  try {
    bring(step.undeformed_gap, sizeof(double), copies.gap, "rc_step.undeformed_gap");
    bring(step.mask, sizeof(std::uint8_t), copies.mask, "rc_step.mask");
    bring(step.p0, sizeof(double), copies.p0, "rc_step.p0");
    bring(outputs.p.array, sizeof(double), copies.p, "rc_result.p", judged_);
    bring(outputs.gap.array, sizeof(double), copies.deformed, "rc_result.gap", false);
    lend(given);
  } catch (...) {
    leave();
    throw;
  }
}

// Replaces an array on a device by a copy on the host, or by room for one.
template <class Array>
void OnHost::bring(Array& array, std::size_t native, std::unique_ptr<std::byte[]>& copy, const char* name, bool given) {
  if (!array.memory) return;
  const Device device(problem_, array.memory, name);
  if (array.data) {
    const std::size_t bytes = static_cast<std::size_t>(problem_.own_points()) * bytes_of_value(array, native);
    copy = std::make_unique_for_overwrite<std::byte[]>(bytes);
    if (given) device.fetch(copy.get(), array.data, bytes);
    array.data = copy.get();
  }
  array.memory = nullptr;
}

// The contact borrows the copies, and its solvers the gap on the device.
void OnHost::lend(const rc_step& given) {
  const auto is_copy = [](const rc_const_array& array) { return !array.data || array.memory; };
  if (is_copy(given.undeformed_gap) && is_copy(given.mask)) step.borrow = 1;
  if (!given.undeformed_gap.memory || !given.undeformed_gap.data) return;
  const auto n = static_cast<std::size_t>(problem_.own_points());
  problem_.gap_on_device = {given.undeformed_gap.data, GapValues(step.undeformed_gap, n), given.undeformed_gap.memory};
  lent_ = given.borrow == 0;
}

void OnHost::give(const Outputs& to) const {
  const auto store = [&](const rc_array& on_device, const rc_array& here, const char* name) {
    if (on_device.memory && on_device.data)
      Device(problem_, on_device.memory, name)
          .store(on_device.data, here.data,
                 static_cast<std::size_t>(problem_.own_points()) * bytes_of_value(here, sizeof(double)));
  };
  if (!judged_) store(to.p.array, outputs.p.array, "rc_result.p");
  store(to.gap.array, outputs.gap.array, "rc_result.gap");
}

void OnHost::leave() {
  if (GapOnDevice& there = problem_.gap_on_device; lent_ || !there.is_of(problem_.surface.gap())) there = {};
  std::erase_if(held_, [&](const auto& copies) { return !refers_to(problem_.surface, *copies); });
  if (held_.empty()) return;
  HostCopies& kept = *held_.back();
  for (std::unique_ptr<std::byte[]>* const each : {&kept.p0, &kept.p, &kept.deformed}) each->reset();
}

}  // namespace rc
