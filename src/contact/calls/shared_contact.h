// A contact that ranks share by rows. On small grids every rank solves all of it; on others a Contact works on the rows.
#pragma once

#include <roughcontact/ranks.h>

#include <memory>
#include <vector>

#include "contact/calls/contact.h"
#include "core/ranks.h"

namespace rc {

class SharedContact {
  template <class Body> auto together(const Body& body) const {
    decltype(body()) answer{};
    ranks_.together([&] { answer = body(); });
    return answer;
  }

 public:
  // All ranks make one at the same time, with a system and options that they agree on.
  SharedContact(const Ranks& ranks, const rc_system& system, const rc_options& options);

  const Ranks& ranks() const { return ranks_; }
  const System& system() const { return contact_->system(); }
  Watcher& watcher() { return contact_->watcher(); }
  Numbers solve(const rc_step& step, const Outputs& outputs) {
    return together([&] { return run(step, outputs, false); });
  }
  Numbers certify(const rc_step& step, const Outputs& outputs) {
    return together([&] { return run(step, outputs, true); });
  }
  rc_status solve_history(const rc_history& path, std::int64_t& completed) {
    return together([&] { return run(path, completed); });
  }

 private:
  std::int64_t columns() const { return contact_->problem().system.given.nx; }
  std::size_t own_points() const { return static_cast<std::size_t>(ranks_.rows() * columns()); }
  // judged: the pressures are given.
  Numbers run(const rc_step& step, const Outputs& outputs, bool judged);
  rc_status run(const rc_history& path, std::int64_t& completed);
  Numbers run_whole(const rc_step& step, const Outputs& outputs, bool judged);
  Numbers run_here(const rc_step& step, const Outputs& outputs, bool judged);
  // The rows of all ranks, in `all`. native: bytes of a value of RC_NATIVE.
  rc_const_array gathered(const rc_const_array& mine, std::size_t native, std::vector<std::byte>& all) const;

  Ranks ranks_;
  bool each_solves_all_;
  std::unique_ptr<Contact> contact_;
};

// Whether every rank solves all of such a system.
bool each_solves_all(const rc_system& system);

}  // namespace rc
