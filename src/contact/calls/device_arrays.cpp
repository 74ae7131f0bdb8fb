#include "contact/calls/device_arrays.h"

#include <algorithm>
#include <span>

#include "contact/workspace.h"
#include "core/error.h"

namespace rc {

namespace {

class Device {
 public:
  Device(const Workspace& work, const char* name, const char* member)
      : work_(work), backend_(work.options.context->backend(name)) {
    if (!backend_.fetch || !backend_.store)
      fail(RC_ERR_INCOMPATIBLE, member, " = \"", name,
           "\": this backend has no device with a memory of its own; name one that has (\"cuda\"), or null for arrays in "
           "the host's memory");
  }

  template <class Value> const Value* copied(const Value* from, std::unique_ptr<Value[]>& to) const {
    if (!from) return nullptr;
    to = room<Value>();
    clear_message();
    raise_if_failed(backend_.fetch(&work_.host, &work_.options, to.get(), from, bytes<Value>()), "copying from the device");
    return to.get();
  }
  template <class Value> std::unique_ptr<Value[]> room() const {
    return std::make_unique_for_overwrite<Value[]>(static_cast<std::size_t>(work_.own_points()));
  }
  template <class Value> void store(Value* to, const Value* from) const {
    if (!to) return;
    clear_message();
    raise_if_failed(backend_.store(&work_.host, &work_.options, to, from, bytes<Value>()), "copying to the device");
  }

 private:
  template <class Value> std::int64_t bytes() const { return work_.own_points() * static_cast<std::int64_t>(sizeof(Value)); }

  const Workspace& work_;
  const rc_backend& backend_;
};

bool refers_to(const StepSurface& surface, const HostCopies& copies) {
  const GapValues& gap = surface.gap();
  return (gap.in_double() && gap.in_double() == copies.gap.get()) ||
         (gap.in_single() && gap.in_single() == copies.gap_single.get()) ||
         (surface.mask() && surface.mask() == copies.mask.get());
}

}  // namespace

OnHost::OnHost(Workspace& work, HeldCopies& held, const rc_step& given, const rc_result& wanted, bool judged)
    : step(given), result(wanted), work_(work), held_(held), judged_(judged) {
  if (!step.memory && !result.memory) return;
  held_.push_back(std::make_unique<HostCopies>());
  try {
    if (step.memory) fetch(given);
    if (result.memory) make_room(wanted);
  } catch (...) {
    leave();
    throw;
  }
}

void OnHost::fetch(const rc_step& given) {
  const Device device(work_, given.memory, "rc_step.memory");
  HostCopies& copies = *held_.back();
  step.undeformed_gap = device.copied(given.undeformed_gap, copies.gap);
  step.undeformed_gap_single = device.copied(given.undeformed_gap_single, copies.gap_single);
  step.mask = device.copied(given.mask, copies.mask);
  step.p0 = device.copied(given.p0, copies.p0);
  step.borrow = 1;
  if (!given.undeformed_gap && !given.undeformed_gap_single) return;
  const auto n = static_cast<std::size_t>(work_.own_points());
  const bool single = given.undeformed_gap == nullptr;
  work_.gap_on_device = {single ? static_cast<const void*>(given.undeformed_gap_single) : given.undeformed_gap,
                         single ? GapValues(std::span<const float>(copies.gap_single.get(), n))
                                : GapValues(std::span<const double>(copies.gap.get(), n)),
                         given.memory};
  lent_ = given.borrow == 0;
}

void OnHost::make_room(const rc_result& wanted) {
  const Device device(work_, wanted.memory, "rc_result.memory");
  HostCopies& copies = *held_.back();
  const auto room = [&]<class Value>(Value*& to, std::unique_ptr<Value[]>& of, bool given) {
    if (!to) return;
    if (given)
      device.copied<Value>(to, of);
    else
      of = device.room<Value>();
    to = of.get();
  };
  room(result.p, copies.p, judged_);
  room(result.p_single, copies.p_single, judged_);
  room(result.gap, copies.deformed, false);
  room(result.gap_single, copies.deformed_single, false);
}

void OnHost::give(rc_result& to) const {
  if (result.memory && result.status >= 0) {
    const Device device(work_, result.memory, "rc_result.memory");
    if (!judged_) {
      device.store(to.p, result.p);
      device.store(to.p_single, result.p_single);
    }
    device.store(to.gap, result.gap);
    device.store(to.gap_single, result.gap_single);
  }
  rc_result answer = result;
  answer.p = to.p;
  answer.p_single = to.p_single;
  answer.gap = to.gap;
  answer.gap_single = to.gap_single;
  to = answer;
}

void OnHost::leave() {
  if (GapOnDevice& there = work_.gap_on_device; lent_ || !there.is_of(work_.surface.gap())) there = {};
  std::erase_if(held_, [&](const auto& copies) { return !refers_to(work_.surface, *copies); });
  if (held_.empty()) return;
  HostCopies& kept = *held_.back();
  for (std::unique_ptr<double[]>* const each : {&kept.p0, &kept.p, &kept.deformed}) each->reset();
  for (std::unique_ptr<float[]>* const each : {&kept.p_single, &kept.deformed_single}) each->reset();
}

}  // namespace rc
