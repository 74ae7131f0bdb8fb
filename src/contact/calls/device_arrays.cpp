#include "contact/calls/device_arrays.h"

#include <algorithm>
#include <span>

#include "contact/problem.h"
#include "core/error.h"

namespace rc {

namespace {

class Device {
 public:
  Device(const GridProblem& problem, const char* name, const char* member)
      : problem_(problem), backend_(problem.options.context->backend(name)) {
    if (!backend_.fetch || !backend_.store)
      fail(RC_ERR_INCOMPATIBLE, member, " = \"", name,
           "\": this backend has no device with a memory of its own; name one that has (\"cuda\"), or null for arrays in "
           "the host's memory");
  }

  template <class Value> const Value* copied(const Value* from, std::unique_ptr<Value[]>& to) const {
    if (!from) return nullptr;
    to = room<Value>();
    clear_message();
    raise_if_failed(backend_.fetch(&problem_.host, &problem_.options, to.get(), from, bytes<Value>()), "copying from the device");
    return to.get();
  }
  template <class Value> std::unique_ptr<Value[]> room() const {
    return std::make_unique_for_overwrite<Value[]>(static_cast<std::size_t>(problem_.own_points()));
  }
  template <class Value> void store(Value* to, const Value* from) const {
    if (!to) return;
    clear_message();
    raise_if_failed(backend_.store(&problem_.host, &problem_.options, to, from, bytes<Value>()), "copying to the device");
  }

 private:
  template <class Value> std::int64_t bytes() const { return problem_.own_points() * static_cast<std::int64_t>(sizeof(Value)); }

  const GridProblem& problem_;
  const rc_backend& backend_;
};

bool refers_to(const StepSurface& surface, const HostCopies& copies) {
  const GapValues& gap = surface.gap();
  return (gap.in_double() && gap.in_double() == copies.gap.get()) ||
         (gap.in_single() && gap.in_single() == copies.gap_single.get()) ||
         (surface.mask() && surface.mask() == copies.mask.get());
}

}  // namespace

OnHost::OnHost(GridProblem& problem, HeldCopies& held, const rc_step& given, const Outputs& wanted, bool judged)
    : step(given), outputs(wanted), problem_(problem), held_(held), judged_(judged) {
  if (!step.memory && !outputs.memory) return;
  held_.push_back(std::make_unique<HostCopies>());
  try {
    if (step.memory) fetch(given);
    if (outputs.memory) make_room(wanted);
  } catch (...) {
    leave();
    throw;
  }
}

void OnHost::fetch(const rc_step& given) {
  const Device device(problem_, given.memory, "rc_step.memory");
  HostCopies& copies = *held_.back();
  step.undeformed_gap = device.copied(given.undeformed_gap, copies.gap);
  step.undeformed_gap_single = device.copied(given.undeformed_gap_single, copies.gap_single);
  step.mask = device.copied(given.mask, copies.mask);
  step.p0 = device.copied(given.p0, copies.p0);
  step.borrow = 1;
  if (!given.undeformed_gap && !given.undeformed_gap_single) return;
  const auto n = static_cast<std::size_t>(problem_.own_points());
  const bool single = given.undeformed_gap == nullptr;
  problem_.gap_on_device = {single ? static_cast<const void*>(given.undeformed_gap_single) : given.undeformed_gap,
                            single ? GapValues(std::span<const float>(copies.gap_single.get(), n))
                                   : GapValues(std::span<const double>(copies.gap.get(), n)),
                            given.memory};
  lent_ = given.borrow == 0;
}

void OnHost::make_room(const Outputs& wanted) {
  const Device device(problem_, wanted.memory, "rc_result.memory");
  HostCopies& copies = *held_.back();
  const auto room = [&]<class Value>(Value*& to, std::unique_ptr<Value[]>& of, bool given) {
    if (!to) return;
    if (given)
      device.copied<Value>(to, of);
    else
      of = device.room<Value>();
    to = of.get();
  };
  room(outputs.p.in_double, copies.p, judged_);
  room(outputs.p.in_single, copies.p_single, judged_);
  room(outputs.gap.in_double, copies.deformed, false);
  room(outputs.gap.in_single, copies.deformed_single, false);
}

void OnHost::give(const Outputs& to) const {
  if (!to.memory) return;
  const Device device(problem_, to.memory, "rc_result.memory");
  const auto store = [&](const OutputArray& there, const OutputArray& here) {
    device.store(there.in_double, here.in_double);
    device.store(there.in_single, here.in_single);
  };
  if (!judged_) store(to.p, outputs.p);
  store(to.gap, outputs.gap);
}

void OnHost::leave() {
  if (GapOnDevice& there = problem_.gap_on_device; lent_ || !there.is_of(problem_.surface.gap())) there = {};
  std::erase_if(held_, [&](const auto& copies) { return !refers_to(problem_.surface, *copies); });
  if (held_.empty()) return;
  HostCopies& kept = *held_.back();
  for (std::unique_ptr<double[]>* const each : {&kept.p0, &kept.p, &kept.deformed}) each->reset();
  for (std::unique_ptr<float[]>* const each : {&kept.p_single, &kept.deformed_single}) each->reset();
}

}  // namespace rc
