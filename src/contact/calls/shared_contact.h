// A contact that ranks share by rows. On small grids every rank solves all of it alike; on others a Contact works on the rows.
#pragma once

#include <roughcontact/ranks.h>

#include <memory>
#include <vector>

#include "contact/calls/contact.h"
#include "core/ranks.h"

namespace rc {

class SharedContact {
 public:
  // All ranks make one at the same time, alike, with a system and options that they agree on.
  SharedContact(const Ranks& ranks, const rc_system& system, const rc_options& options);

  const Ranks& ranks() const { return ranks_; }
  rc_status solve(const rc_step& step, rc_result& result) {
    return together([&] { return run(step, result, &Contact::solve); });
  }
  rc_status certify(const rc_step& step, rc_result& result) {
    return together([&] { return run(step, result, &Contact::certify); });
  }
  rc_status solve_history(const rc_history& path, std::int64_t& completed) {
    return together([&] { return run(path, completed); });
  }

 private:
  using Action = rc_status (Contact::*)(const rc_step&, rc_result&);

  std::int64_t columns() const { return contact_->work().system.given.nx; }
  std::size_t own_points() const { return static_cast<std::size_t>(ranks_.rows() * columns()); }
  template <class Body> rc_status together(const Body& body) const {
    rc_status status = RC_OK;
    ranks_.alike([&] { status = body(); });
    return status;
  }
  rc_status run(const rc_step& step, rc_result& result, Action action);
  rc_status run(const rc_history& path, std::int64_t& completed);
  rc_status run_alike(const rc_step& step, rc_result& result, Action action);
  template <class Value> const Value* gathered(const Value* mine, std::vector<Value>& all) const;

  Ranks ranks_;
  bool alike_;
  std::unique_ptr<Contact> contact_;
};

// Whether every rank solves all of such a system.
bool solved_alike(const rc_system& system);

}  // namespace rc
