#include "contact/calls/shared_contact.h"

#include <algorithm>
#include <utility>

#include "contact/calls/agreement.h"
#include "contact/calls/history.h"
#include "core/array.h"
#include "core/error.h"
#include "core/grid.h"

namespace rc {

namespace {

constexpr std::int64_t least_shared_side = 32;

// Refuses options that contacts on rows do not support.
void check_options(const rc_options& options) {
  const auto refuse = [](const char* key, const std::string& value, const char* what) {
    fail(RC_ERR_INCOMPATIBLE, "option ", key, " = ", value, ": contacts shared by ranks have no ", what,
         "; leave it at its default");
  };
  if (options.real(RC_OPT_ACCURACY) > 0) refuse(RC_OPT_ACCURACY, join(options.real(RC_OPT_ACCURACY)), "accuracy goal");
  if (options.text(RC_OPT_WARMUP) != "none") refuse(RC_OPT_WARMUP, options.text(RC_OPT_WARMUP), "warm-up by another solver");
  if (!options.text(RC_OPT_CERTIFY_BACKEND).empty())
    refuse(RC_OPT_CERTIFY_BACKEND, options.text(RC_OPT_CERTIFY_BACKEND), "second backend");
}

// Before memory is taken, which grows with the rows.
const rc_system& checked(const rc_system& system, const rc_options& options) {
  if (system.op != RC_OPERATOR_HALFSPACE)
    fail(RC_ERR_INCOMPATIBLE, "ranks share half-space grids alone, not a caller's matrix or product");
  check_grid(system);
  if (!each_solves_all(system)) check_options(options);
  return system;
}

// A rank without rows gives no arrays; this stands for them and is neither read nor written.
const double stand_in = 0;

constexpr std::int32_t no_array = -1;
template <class Array> std::int32_t given_type(const Array& array) { return array.data ? array.type : no_array; }
template <class Array> void stand_in_for(Array& array, std::int32_t type) {
  array = {};
  if (type == no_array) return;
  array.data = const_cast<double*>(&stand_in);
  array.type = type;
}

// The types of the arrays that rank 0, which has rows, gives.
struct Given {
  std::int32_t gap, mask, p0, p, deformed;
};

void stand_in_for(const Given& given, rc_step& step, Outputs& outputs) {
  stand_in_for(step.undeformed_gap, given.gap);
  stand_in_for(step.mask, given.mask);
  stand_in_for(step.p0, given.p0);
  stand_in_for(outputs.p.array, given.p);
  stand_in_for(outputs.gap.array, given.deformed);
}

Given given_by(const rc_step& step, const Outputs& outputs) {
  return {given_type(step.undeformed_gap), given_type(step.mask), given_type(step.p0), given_type(outputs.p.array),
          given_type(outputs.gap.array)};
}

// A rank that solves the whole problem by itself has its own clock and flag. If they end its call, this ends the calls of all
// ranks.
void stop_all(rc_status status, const char* message) {
  if (status == RC_STOP_TIME || status == RC_STOP_CANCELLED) fail(status, message);
}

}  // namespace

bool each_solves_all(const rc_system& system) { return std::min(system.nx, system.ny) < least_shared_side; }

SharedContact::SharedContact(const Ranks& ranks, const rc_system& system, const rc_options& options)
    : ranks_(ranks.on(checked(system, options).ny, !each_solves_all(system))), each_solves_all_(each_solves_all(system)) {
  contact_ = std::make_unique<Contact>(system, options, each_solves_all_ ? Company::repeated() : Company(Rows(ranks_)));
}

rc_const_array SharedContact::gathered(const rc_const_array& mine, std::size_t native, std::vector<std::byte>& all) const {
  if (!mine.data) return {};
  const auto bytes = columns() * static_cast<std::int64_t>(bytes_of_value(mine, native));
  on_all(&ranks_, [&] { all.resize(static_cast<std::size_t>(ranks_.all_rows() * bytes)); });
  ranks_.gather_rows(static_cast<const std::byte*>(mine.data), bytes, all.data());
  return {all.data(), mine.type, 0, nullptr};
}

Numbers SharedContact::run_here(const rc_step& step, const Outputs& outputs, bool judged) {
  return judged ? contact_->certify(step, outputs) : contact_->solve(step, outputs);
}

Numbers SharedContact::run_whole(const rc_step& step, const Outputs& outputs, bool judged) {
  std::vector<std::byte> gap, mask, p0, p, deformed;
  rc_step whole = step;
  whole.borrow = 0;
  whole.undeformed_gap = gathered(step.undeformed_gap, sizeof(double), gap);
  whole.mask = gathered(step.mask, sizeof(std::uint8_t), mask);
  whole.p0 = gathered(step.p0, sizeof(double), p0);
  if (judged) gathered(read_only(outputs.p.array), sizeof(double), p);
  const auto row_bytes = [&](const rc_array& array) {
    return static_cast<std::size_t>(columns()) * bytes_of_value(array, sizeof(double));
  };
  Numbers numbers;
  on_all(&ranks_, [&] {
    const auto room = [&](const rc_array& wanted, std::vector<std::byte>& of) {
      rc_array all = wanted;
      if (!wanted.data) return OutputArray();
      of.resize(static_cast<std::size_t>(ranks_.all_rows()) * row_bytes(wanted));
      all.data = of.data();
      return OutputArray(all);
    };
    const Outputs all{room(outputs.p.array, p), room(outputs.gap.array, deformed)};
    numbers = run_here(whole, all, judged);
  });
  const std::string message = last_message();
  const std::vector<rc_status> statuses = ranks_.of_each(numbers.status);
  if (std::ranges::count(statuses, numbers.status) < ranks_.size())
    on_all(&ranks_, [&] { stop_all(numbers.status, message.c_str()); });
  const auto rows = [&](const rc_array& to, const std::vector<std::byte>& of) {
    const std::size_t row = row_bytes(to);
    if (to.data)
      std::copy_n(of.data() + static_cast<std::size_t>(ranks_.first_row()) * row, static_cast<std::size_t>(ranks_.rows()) * row,
                  static_cast<std::byte*>(to.data));
  };
  if (!judged) rows(outputs.p.array, p);
  rows(outputs.gap.array, deformed);
  set_message(message.c_str());
  return numbers;
}

Numbers SharedContact::run(const rc_step& step, const Outputs& outputs, bool judged) {
  check_agreement(ranks_, facts_of(step, outputs), ranks_.rows() > 0);
  const Given given = ranks_.of_each(given_by(step, outputs)).front();
  rc_step asked = step;
  Outputs to = outputs;
  if (ranks_.rows() == 0) stand_in_for(given, asked, to);
  return each_solves_all_ ? run_whole(asked, to, judged) : run_here(asked, to, judged);
}

rc_status SharedContact::run(const rc_history& path, std::int64_t& completed) {
  rc_history asked = path;
  check_agreement(ranks_, facts_of(asked), ranks_.rows() > 0);
  const std::int32_t gap_type = ranks_.of_each(given_type(asked.undeformed_gap)).front(),
                     mask_type = ranks_.of_each(given_type(asked.mask)).front();
  const HistoryWants wants = ranks_.of_each(wants_of(asked)).front();
  if (ranks_.rows() == 0) {
    stand_in_for(asked.undeformed_gap, gap_type);
    stand_in_for(asked.mask, mask_type);
  }
  // The caller's function gets this rank's rows; if it ends the history on one rank, all end it.
  struct CallersFunction {
    const SharedContact& self;
    const rc_history& path;
    bool ended = false;
  } callers{*this, asked};
  rc_history inner = asked;
  if (asked.fn) {
    inner.user = &callers;
    inner.fn = [](std::int64_t step, const rc_result* result, void* user) -> std::int32_t {
      CallersFunction& of = *static_cast<CallersFunction*>(user);
      rc_result rows = *result;
      if (of.self.each_solves_all_) {
        const std::int64_t before = of.self.ranks_.first_row() * of.self.columns();
        rows.p.data = static_cast<double*>(rows.p.data) + before;
        if (rows.gap.data) rows.gap.data = static_cast<double*>(rows.gap.data) + before;
      }
      of.ended = of.self.ranks_.any(of.path.fn(step, &rows, of.path.user) != 0);
      return of.ended ? 1 : 0;
    };
  }
  std::vector<std::byte> gap, mask;
  if (each_solves_all_) {
    inner.undeformed_gap = gathered(inner.undeformed_gap, sizeof(double), gap);
    inner.mask = gathered(inner.mask, sizeof(std::uint8_t), mask);
  }
  const rc_status status = rc::solve_history(*contact_, inner, wants, completed);
  if (each_solves_all_ && !callers.ended) stop_all(status, last_message());
  return status;
}

}  // namespace rc
