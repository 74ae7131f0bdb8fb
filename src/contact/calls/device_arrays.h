// Arrays that a step has in the memory of a device. The contact works on the host, with copies of them.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "grid/gap_values.h"

namespace rc {

class Workspace;

// A gap that a contact has a copy of, where solvers of that device can read it.
struct GapOnDevice {
  const void* at = nullptr;  // null: there is none
  GapValues copy;
  std::string memory;  // the backend's name

  bool is_of(const GapValues& gap) const { return at && copy.is_array_of(gap); }
};

// Copies of one step's arrays; null where there are none.
struct HostCopies {
  std::unique_ptr<double[]> gap, p0, p, deformed;
  std::unique_ptr<float[]> gap_single, p_single, deformed_single;
  std::unique_ptr<std::uint8_t[]> mask;
};

// Those that a contact's surface refers to, and those of the step that is being solved.
using HeldCopies = std::vector<std::unique_ptr<HostCopies>>;

// A step and its result with all arrays on the host, for the time of one call.
class OnHost {
 public:
  // judged: the result's pressures are given. held and the workspace must outlive it. Throws Error where there is no such device,
  // or it fails.
  OnHost(Workspace& work, HeldCopies& held, const rc_step& given, const rc_result& result, bool judged);
  ~OnHost() { leave(); }
  OnHost(const OnHost&) = delete;
  OnHost& operator=(const OnHost&) = delete;

  // The answer in the caller's struct, and its arrays where the caller wants them.
  void give(rc_result& to) const;

  rc_step step;
  rc_result result;

 private:
  void fetch(const rc_step& given);
  void make_room(const rc_result& wanted);
  void leave();  // keeps what the surface refers to

  Workspace& work_;
  HeldCopies& held_;
  const bool judged_;
  bool lent_ = false;  // the device's gap is there for this call alone
};

}  // namespace rc
