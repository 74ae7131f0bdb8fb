// The core's services for one backend under test: options by their declared defaults, influence coefficients of the library.
#pragma once

#include <roughcontact/plugin.h>

#include <atomic>
#include <map>
#include <mutex>
#include <string>

#include "core/thread_team.h"
#include "support/unshared.h"

namespace contract {

class StandInHost : public rc_host {
 public:
  // The options of `backend` and the core's that backends may ask for are known.
  explicit StandInHost(const rc_backend& backend);
  StandInHost(const StandInHost&) = delete;
  StandInHost& operator=(const StandInHost&) = delete;

  void set(const std::string& key, const std::string& value) { options_.at(key) = value; }
  // What coefficients() and symbol() answer; RC_OK: the values.
  void answer_with(rc_status status) { answer_ = status; }

  const rc_options* options() const { return reinterpret_cast<const rc_options*>(&options_); }
  // What operators that do not bring their own team use.
  const rc_team* alone() const { return &alone_; }
  std::int64_t threads() const { return std::stoll(options_.at("threads")); }
  // The message of the last fail() in this thread.
  static const std::string& message();

 private:
  static const StandInHost& self(const rc_host* host) { return *static_cast<const StandInHost*>(host); }
  static rc_status value(const rc_options* options, const char* key, const std::string*& out);

  std::map<std::string, std::string> options_;
  rc::ThreadTeam alone_{1};
  std::atomic<rc_status> answer_{RC_OK};
  mutable support::Unshared objects_;
  mutable std::mutex lock_;  // one for all resources
};

// The kernel that systems of this boundary use.
const char* kernel_name(std::int32_t boundary);

}  // namespace contract
