// Arrays that a step has in the memory of a device. The contact works on the host, with copies of them.
#pragma once

#include <roughcontact/plugin.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "contact/surface/outputs.h"

namespace rc {

class GridProblem;

// Copies of one step's arrays; null if there are none.
struct HostCopies {
  std::unique_ptr<std::byte[]> gap, mask, p0, p, deformed;
};

// Copies to which a contact's surface refers, and copies for the running step.
using HeldCopies = std::vector<std::unique_ptr<HostCopies>>;

// A step and its outputs with all arrays on the host, for the time of one call.
class OnHost {
 public:
  // judged: the pressures are given. held and the problem must outlive it. Throws Error if there is no such device,
  // or it fails.
  OnHost(GridProblem& problem, HeldCopies& held, const rc_step& given, const Outputs& outputs, bool judged);
  ~OnHost() { leave(); }
  OnHost(const OnHost&) = delete;
  OnHost& operator=(const OnHost&) = delete;

  // The outputs to where the caller wants them.
  void give(const Outputs& to) const;

  rc_step step;
  Outputs outputs;

 private:
  template <class Array>
  void bring(Array& array, std::size_t native, std::unique_ptr<std::byte[]>& copy, const char* name, bool given = true);
  void lend(const rc_step& given);
  void leave();  // keeps what the surface refers to

  GridProblem& problem_;
  HeldCopies& held_;
  const bool judged_;
  bool lent_ = false;  // the device's gap is there for this call alone
};

}  // namespace rc
