// What a handle holds: the contact on the given grid, the accuracy goal with its coarser grids, and whether a thread is using it.
#pragma once

#include <roughcontact/derivatives.h>
#include <roughcontact/history.h>

#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <thread>

#include "contact/calls/device_arrays.h"
#include "contact/grid_contact.h"
#include "contact/grids/goal/accuracy_goal.h"
#include "registry/options_handle.h"

namespace rc {

class Contact {
 public:
  // ranks: null, or those that share the grid by rows; see Workspace.
  Contact(const rc_system& system, const rc_options& options, const Ranks* ranks = nullptr);
  // From here on other ranks do the same, each with all points.
  void stay_alike() { grid_.work().passes_over = false; }

  const Workspace& work() const { return grid_.work(); }
  const Memory& memory() const { return grid_.memory(); }
  void set_options(const rc_options& options);
  void on_progress(const ProgressCallback& progress) { grid_.on_progress(progress); }

  // These two take arrays on a device, too.
  rc_status solve(const rc_step& step, rc_result& result);
  rc_status certify(const rc_step& step, rc_result& result);
  rc_status retrace(const rc_step& step, double compression, rc_result& result) {
    return grid_.retrace(step, compression, result);
  }

  // Derivatives of the last step. Throw Error(ARGUMENT) where it did not return RC_OK.
  rc_status gradient(rc_gradient& gradient);
  rc_status tangent(rc_tangent& tangent);

  // Why "auto" chose what it did in the last step on the given grid; "" where no step has needed a solver.
  const std::string& explain();

  void reset();
  // Afterwards the next answer has the bits of a new contact's. Facts that are the same for all contacts of the system stay.
  void forget();
  void write_indentation(std::span<double> to) const { grid_.write_indentation(to); }
  // Restores the state after the steps described, which this contact or another has solved. Throws Error(ARGUMENT).
  void restore(const rc_state& state);

  void cancel() { grid_.cancel(); }
  // While it lives, a cancellation ends the running solve or the next one. Its destructor clears the cancellation.
  class Cancellation {
   public:
    explicit Cancellation(Contact& contact) : contact_(contact) {}
    ~Cancellation() { contact_.grid_.clear_cancellation(); }
    Cancellation(const Cancellation&) = delete;
    Cancellation& operator=(const Cancellation&) = delete;
    bool requested() const { return contact_.grid_.cancelled(); }

   private:
    Contact& contact_;
  };
  // One step of a history, within a Cancellation.
  void begin(const rc_step& step);
  rc_status solve_begun(const rc_step& step, rc_result& result);
  // Sets option stiffness. Returns what it was.
  std::int64_t ask_stiffness(std::int64_t wanted);

  // True for the one thread that may use the contact now.
  bool try_enter() {
    std::thread::id nobody;
    return user_.compare_exchange_strong(nobody, std::this_thread::get_id(), std::memory_order_acquire);
  }
  void leave() { user_.store({}, std::memory_order_release); }
  // Whether this thread has entered: it is in a callback of the contact's.
  bool inside() const { return user_.load(std::memory_order_relaxed) == std::this_thread::get_id(); }

 private:
  void drop_copies();

  HeldCopies held_;  // outlives what refers to it
  GridContact grid_;
  AccuracyGoal goal_;
  std::string explanation_;
  std::atomic<std::thread::id> user_;  // none: the contact is free
};

}  // namespace rc
