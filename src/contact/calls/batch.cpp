#include "contact/calls/batch.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <limits>
#include <map>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "contact/calls/contact.h"
#include "contact/calls/controls.h"
#include "contact/calls/many.h"
#include "contact/calls/many_check.h"
#include "contact/calls/step_outputs.h"
#include "core/caught.h"
#include "core/host_call.h"
#include "core/limits.h"

namespace rc {

namespace {

constexpr std::size_t most_text = 640;
constexpr std::int64_t most_values = std::numeric_limits<std::int64_t>::max() / static_cast<std::int64_t>(sizeof(double));

// The distance from one contact's values to the next one's.
std::int64_t resolved_stride(std::int64_t stride, std::int64_t values, std::int64_t n, const char* name, const char* least) {
  if (stride == RC_BATCH_SHARED) return 0;
  if (stride != 0 && stride < values)
    fail(RC_ERR_SHAPE, "rc_batch.", name, " = ", stride, " must be 0, RC_BATCH_SHARED (-1) or at least ", least, " = ", values);
  const std::int64_t result = std::max(stride, values);
  if (result > 0 && n > most_values / result)
    fail(RC_ERR_SHAPE, "rc_batch: n = ", n, " contacts of ", result, " values are more than ", most_values, " values");
  return result;
}

// The batch with its strides resolved; it makes the steps and writes the outputs.
struct Request {
  rc_batch given, for_many;  // the latter by load if mean pressures are prescribed
  std::int64_t points;
  std::vector<double> loads;

  Request(const rc_batch& batch, const System& system) : given(batch), points(system.points()) {
    if (given.n < 0) fail(RC_ERR_ARGUMENT, "rc_batch.n = ", given.n, " must be >= 0");
    if (given.steps < 0) fail(RC_ERR_ARGUMENT, "rc_batch.steps = ", given.steps, " must be >= 0");
    check_control(given.control, "rc_batch.control");
    given.target_stride = resolved_stride(given.target_stride, given.steps, given.n, "target_stride", "steps");
    given.undeformed_gap_stride = resolved_stride(given.undeformed_gap_stride, points, given.n, "undeformed_gap_stride", "nx*ny");
    given.mask_stride = resolved_stride(given.mask_stride, points, given.n, "mask_stride", "nx*ny");
    for_many = given;
    if (given.n == 0 || given.steps == 0) return;
    if (given.n > most_values / std::max(given.steps, points))
      fail(RC_ERR_SHAPE, "rc_batch: n = ", given.n, " contacts of ", std::max(given.steps, points), " values are more than ",
           most_values, " values");
    if (!given.targets.data) fail(RC_ERR_ARGUMENT, "rc_batch.targets is null but n = ", given.n, " and steps = ", given.steps);
    if (!given.undeformed_gap.data) fail(RC_ERR_ARGUMENT, "rc_batch.undeformed_gap is null but n = ", given.n);
    if (!system.creep.empty() && !given.times.data)
      fail(RC_ERR_ARGUMENT, "rc_batch.times is null but the system creeps; give the time of each step");
    if (given.control != RC_CONTROL_PRESSURE) return;
    const std::int64_t targets = (given.n - 1) * given.target_stride + given.steps;
    for (std::int64_t i = 0; i < targets; ++i) loads.push_back(values_of<double>(given.targets)[i] * nominal_area(system));
    for_many.control = RC_CONTROL_LOAD;
    for_many.targets = RC_IN(loads.data());
  }
  Request(const Request&) = delete;
  Request& operator=(const Request&) = delete;

  double target(std::int64_t i, std::int64_t k) const { return values_of<double>(given.targets)[i * given.target_stride + k]; }

  rc_step step(std::int64_t i, std::int64_t k) const {
    rc_step step = RC_STEP_INIT;
    step.control = given.control;
    step.warm_start = given.warm_start;
    step.target = target(i, k);
    if (given.times.data) step.time = values_of<double>(given.times)[i * given.target_stride + k];
    if (k > 0) return step;  // later steps keep the surface of the first
    step.undeformed_gap = from_value(given.undeformed_gap, i * given.undeformed_gap_stride, sizeof(double));
    step.mask = from_value(given.mask, i * given.mask_stride, sizeof(std::uint8_t));
    step.borrow = 1;  // the caller's arrays outlive the contacts
    step.p0 = from_value(given.p0, i * points, sizeof(double));
    return step;
  }
  OutputArray pressures(std::int64_t i) const { return OutputArray(from_value(given.p, i * points, sizeof(double))); }

  void write(std::int64_t i, std::int64_t k, const Numbers& numbers, const System& system) const {
    put_numbers(given.columns, i * given.steps + k, numbers, system);
  }
  // Steps from `k` on have no answer.
  void write_none(std::int64_t i, std::int64_t k, rc_status status) const {
    for (std::int64_t at = i * given.steps + k; at < (i + 1) * given.steps; ++at) put_none(given.columns, at, status);
  }
};

// Shared by the threads: the number of the next contacts, the reason for an early end, and the message that the call returns.
class Progress {
 public:
  Progress(const rc_batch& batch, double time_limit)
      : endings_(static_cast<std::size_t>(batch.n), RC_OK),
        tell_(batch.progress),
        user_(batch.user),
        time_limit_(time_limit),
        out_of_time_(join("time_limit = ", time_limit, " s is over")) {}

  std::int64_t next(std::int64_t count) { return next_.fetch_add(count, std::memory_order_relaxed); }

  rc_status stopped() {
    if (stop_asked<ContactLibrary>()) stop_by("the flag of rc_stop_when ended the batch");
    if (time_limit_ > 0 && seconds_since(start_) > time_limit_) stop(RC_STOP_TIME);
    return stop_.load(std::memory_order_relaxed);
  }
  void stop(rc_status why) {
    rc_status none = RC_OK;
    stop_.compare_exchange_strong(none, why, std::memory_order_relaxed);
  }
  // `caller` ends the batch.
  void stop_by(const char* caller) {
    caller_.store(caller, std::memory_order_relaxed);
    stop(RC_STOP_CANCELLED);
  }
  const char* why_stopped() const { return stop_ == RC_STOP_TIME ? out_of_time_.c_str() : caller_.load(); }

  // Adds to the number of steps that have outputs.
  void add(std::int64_t steps) {
    const std::int64_t all = steps_.fetch_add(steps, std::memory_order_relaxed) + steps;
    if (tell_ && stopped() == RC_OK && ask_host(all) != 0) stop_by("rc_batch.progress ended the batch");
  }

  // Contact i ended at step k, not certified. Allocates nothing, because an allocation may be what failed.
  void ended(std::int64_t i, std::int64_t k, double target, rc_status status, const char* message) {
    endings_[static_cast<std::size_t>(i)] = status;
    const std::lock_guard lock(mutex_);
    const bool worse = first_ < 0 || (status < 0) > (first_status_ < 0);
    if (!worse && ((status < 0) < (first_status_ < 0) || i > first_)) return;
    first_ = i;
    first_step_ = k;
    first_target_ = target;
    first_status_ = status;
    std::snprintf(first_message_, sizeof first_message_, "%s", message);
  }

  // Every step of contact i is certified or within its accuracy goal, and some step is the latter.
  void ended_within_goal(std::int64_t i) { endings_[static_cast<std::size_t>(i)] = RC_WITHIN_GOAL; }

  // Call it when all threads have ended.
  BatchOutcome outcome() const {
    BatchOutcome result;
    std::map<rc_status, std::int64_t> counts;
    for (const rc_status status : endings_) ++counts[status];
    result.certified = counts[RC_OK];
    counts.erase(RC_OK);
    const auto n = static_cast<std::int64_t>(endings_.size());
    if (first_ < 0) {
      const std::int64_t within_goal = n - result.certified;
      result.status = stop_ != RC_OK || within_goal == 0 ? stop_.load() : RC_WITHIN_GOAL;
      if (stop_ != RC_OK)
        result.message = join(why_stopped(), "; ", within_goal > 0 ? "" : "all ", result.certified, " contacts are certified");
      if (within_goal > 0)
        result.message +=
            join(result.message.empty() ? "" : ", ", within_goal, " of ", n, " contacts within accuracy on coarser grids");
      return result;
    }
    result.status = first_status_;
    result.first = first_;
    std::string list;
    for (const auto& [status, count] : counts) list += join(list.empty() ? "" : ", ", count, " ", rc_status_name(status));
    result.message = join(n - result.certified, " of ", n, " contacts are not certified (", list, "); first contact ", first_,
                          ", step ", first_step_, ", target ", first_target_, ": ", first_message_);
    return result;
  }

 private:
  std::int32_t ask_host(std::int64_t steps) const {
    const HostsTurn turn;
    return tell_(steps, user_);
  }

  std::vector<rc_status> endings_;
  const rc_batch_progress_fn tell_;  // null: nobody
  void* const user_;
  const double time_limit_;
  const std::string out_of_time_;
  const Clock::time_point start_ = Clock::now();
  std::atomic<std::int64_t> next_{0}, steps_{0};
  std::atomic<const char*> caller_{"rc_batch.fn ended the batch"};
  std::atomic<rc_status> stop_{RC_OK};
  std::mutex mutex_;  // guards the members below
  std::int64_t first_ = -1, first_step_ = 0;
  double first_target_ = 0;
  rc_status first_status_ = RC_OK;
  char first_message_[most_text] = "";
};

// One thread's contact, which solves one history after the other, but for those that a solver takes many of at once.
class Worker {
 public:
  // many: null, or what takes them.
  Worker(std::unique_ptr<Contact> contact, const Request& request, Progress& progress, const ManySolve* many)
      : contact_(std::move(contact)), request_(request), progress_(progress), many_(many) {
    contact_->watcher().progress = {ask, &progress_, 1};
    const rc_options& options = contact_->problem().options;
    contact_->ask({options.integer(RC_OPT_STIFFNESS), options.integer(RC_OPT_BOUNDS), request.given.virgin == 0});
    const auto points = static_cast<std::size_t>(request_.points);
    if (request_.given.fn) p_.resize(points);
    if (request_.given.fn || request_.given.columns.mean_gap.data) gap_.resize(points);
  }

  void work() {
    const std::int64_t at_once = many_ ? many_->at_once() : 1;
    for (std::int64_t i; (i = progress_.next(at_once)) < request_.given.n;) {
      const std::int64_t end = std::min(i + at_once, request_.given.n);
      while (i < end)
        if (many_ && progress_.stopped() == RC_OK)
          i += together(i, end);
        else
          solve_one(i++);
    }
  }

 private:
  static std::int32_t ask(const rc_progress*, void* progress) { return static_cast<Progress*>(progress)->stopped() != RC_OK; }

  // Contacts i .. end-1, or the first of them; returns how many they are. Those that are not solved together, for whatever
  // reason, are solved by themselves.
  std::int64_t together(std::int64_t i, std::int64_t end) {
    ManyAnswers answers = many_->solved(i, end);
    const std::int64_t count = answers.contacts > 0 ? answers.contacts : end - i, steps = request_.given.steps;
    std::vector<std::int64_t> solved, others;
    for (std::int64_t k = 0; k < count; ++k) (k < answers.contacts && answers.solved(k, steps) ? solved : others).push_back(k);
    if (const std::string why = refusal(request_.for_many, answers, solved, i, *contact_); !why.empty()) {
      many_->log(i, i + count, why.c_str());
      others.insert(others.end(), solved.begin(), solved.end());
      std::sort(others.begin(), others.end());
      solved.clear();
    }
    for (const std::int64_t k : solved) take(i + k, answers, k);
    if (!solved.empty()) progress_.add(static_cast<std::int64_t>(solved.size()) * steps);
    answers = {};
    for (const std::int64_t k : others) solve_one(i + k);
    return count;
  }
  // Contact i is number k of these answers.
  void take(std::int64_t i, const ManyAnswers& answers, std::int64_t k) {
    const std::int64_t steps = request_.given.steps, first = k * steps;
    for (std::int64_t step = 0; step < steps; ++step)
      request_.write(i, step, many_->numbers(answers.all[static_cast<std::size_t>(first + step)], i, step), system());
    if (double* const to = values_of<double>(request_.pressures(i).array))
      std::copy_n(answers.p.data() + (first + steps - 1) * request_.points, request_.points, to);
  }

  void solve_one(std::int64_t i) {
    contact_->forget(Forgotten::surface);
    bool within_goal = false;
    for (std::int64_t k = 0; k < request_.given.steps; ++k) {
      if (const rc_status stop = progress_.stopped(); stop != RC_OK) return end(i, k, k, stop, progress_.why_stopped());
      Numbers numbers;
      const Outputs outputs = this->outputs(i);
      const rc_status status = solve(i, k, outputs, numbers);
      if (status >= 0) deliver(i, k, outputs, numbers);
      within_goal = within_goal || status == RC_WITHIN_GOAL;
      if (status != RC_OK && status != RC_WITHIN_GOAL) return end(i, k, status < 0 ? k : k + 1, status, message_);
    }
    if (within_goal) progress_.ended_within_goal(i);
  }

  // History i ends at step k; from step `unanswered` on it has no answers.
  void end(std::int64_t i, std::int64_t k, std::int64_t unanswered, rc_status status, const char* message) {
    request_.write_none(i, unanswered, status);
    progress_.add(request_.given.steps - unanswered);
    progress_.ended(i, k, request_.target(i, k), status, message);
  }

  void deliver(std::int64_t i, std::int64_t k, const Outputs& outputs, const Numbers& numbers) {
    request_.write(i, k, numbers, system());
    if (request_.given.fn && progress_.stopped() == RC_OK) {
      rc_result result = result_with(outputs);
      rc::write(numbers, system(), result);
      if (shown(i, k, result) != 0) progress_.stop_by("rc_batch.fn ended the batch");
    }
    progress_.add(1);
  }

  std::int32_t shown(std::int64_t i, std::int64_t k, const rc_result& result) const {
    const HostsTurn turn;
    return request_.given.fn(i, k, &result, request_.given.user);
  }

  Outputs outputs(std::int64_t i) {
    const OutputArray p = request_.pressures(i);
    return {p.wanted() || p_.empty() ? p : OutputArray(p_.data()), {gap_.empty() ? nullptr : gap_.data()}};
  }

  rc_status solve(std::int64_t i, std::int64_t k, const Outputs& outputs, Numbers& numbers) {
    const auto ended = [&](rc_status status, const char* text) {
      std::snprintf(message_, sizeof message_, "%s", text);
      return status;
    };
    clear_message();
    return caught(
        [&] {
          numbers = contact_->solve(request_.step(i, k), outputs);
          const rc_status status = numbers.status;
          if (status == RC_OK) return status;
          if (const rc_status stop = progress_.stopped(); status == RC_STOP_CANCELLED && stop != RC_OK)
            return ended(numbers.status = stop, progress_.why_stopped());
          return ended(status, last_message()[0] != '\0' ? last_message() : rc_status_text(status));
        },
        ended);
  }

  const System& system() const { return contact_->problem().system; }

  std::unique_ptr<Contact> contact_;
  const Request& request_;
  Progress& progress_;
  const ManySolve* const many_;
  std::vector<double> p_, gap_;
  char message_[most_text] = "";
};

// Helper threads. They are joined even if the calling thread leaves by an exception.
class Helpers {
 public:
  // Starts `count` helpers, or as many as the system allows.
  template <class Body> Helpers(std::int64_t count, Progress& progress, const Body& body) : progress_(progress) {
    threads_.reserve(static_cast<std::size_t>(count));
    const rc_platform::SignalsBlocked helpers_take_no_signals;
    try {
      for (std::int64_t i = 0; i < count; ++i) threads_.emplace_back(body);
    } catch (const std::system_error&) {
    } catch (const std::bad_alloc&) {
    }
  }
  ~Helpers() {
    if (!finished_) progress_.stop(RC_STOP_CANCELLED);
    join();
  }
  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;

  void finish() {
    finished_ = true;
    join();
  }

 private:
  void join() {
    for (std::thread& thread : threads_)
      if (thread.joinable()) thread.join();
  }

  Progress& progress_;
  std::vector<std::thread> threads_;
  bool finished_ = false;
};

}  // namespace

BatchOutcome solve_batch(const rc_system& system, const rc_options& options, const rc_batch& batch) {
  rc_options each = options;
  each.set(RC_OPT_THREADS, std::int64_t{1});
  each.set(RC_OPT_TIME_LIMIT, 0.0);
  const ColumnWants wants = wants_of(batch.columns);
  each.set(RC_OPT_STIFFNESS, std::max(wants.stiffness, options.integer(RC_OPT_STIFFNESS)));
  if (wants.bounds != 0 || !batch.fn) each.set(RC_OPT_BOUNDS, wants.bounds);  // else no output shows them

  const auto contact = [&] { return std::make_unique<Contact>(system, each); };
  std::unique_ptr<Contact> first = contact();  // checks the system and the options
  const Request request(batch, first->problem().system);
  Progress progress(batch, options.real(RC_OPT_TIME_LIMIT));
  const std::int64_t threads = std::clamp<std::int64_t>(batch.n, 1, options.integer(RC_OPT_THREADS));
  const std::optional<ManySolve> many = ManySolve::of(first->problem(), request.for_many, threads);
  const ManySolve* const shared = many ? &*many : nullptr;
  Worker own(std::move(first), request, progress, shared);
  Helpers helpers(threads - 1, progress, [&, flag = stop_flag<ContactLibrary>] {
    stop_flag<ContactLibrary> = flag;
    try {
      Worker(contact(), request, progress, shared).work();
    } catch (const Cancelled&) {
      progress.stop(RC_STOP_CANCELLED);
      throw;
    } catch (...) {
      // No memory for its contact: the others do its share.
    }
  });
  own.work();
  helpers.finish();
  return progress.outcome();
}

}  // namespace rc
