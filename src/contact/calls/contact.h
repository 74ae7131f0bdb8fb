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
#include "contact/grids/goal/accuracy_goal.h"
#include "registry/options_handle.h"

namespace rc {

class Contact {
 public:
  Contact(const rc_system& system, const rc_options& options, const Company& company = {});

  const GridProblem& problem() const { return grid_.problem(); }
  const GridContact& grid() const { return grid_; }
  void set_options(const rc_options& options);
  void on_progress(const ProgressCallback& progress) { grid_.on_progress(progress); }

  // These two take arrays on a device, too.
  Numbers solve(const rc_step& step, const Outputs& outputs);
  Numbers certify(const rc_step& step, const Outputs& outputs);
  Numbers retrace(const rc_step& step, double compression, const Outputs& outputs) {
    return grid_.retrace(step, compression, outputs);
  }
  // Of the last step's answer; model_nx = 0: it has none.
  const rc_accuracy& accuracy() const { return accuracy_; }

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
  Step begin(const rc_step& step);
  Numbers solve_begun(const Step& step, const Outputs& outputs);
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
  rc_accuracy accuracy_ = RC_ACCURACY_INIT;
  std::string explanation_;
  std::atomic<std::thread::id> user_;  // none: the contact is free
};

}  // namespace rc
