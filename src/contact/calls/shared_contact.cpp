#include "contact/calls/shared_contact.h"

#include <algorithm>
#include <utility>

#include "contact/calls/agreement.h"
#include "contact/calls/history.h"
#include "core/error.h"
#include "core/grid.h"

namespace rc {

namespace {

constexpr std::int64_t least_shared_side = 32;

// What a contact on rows cannot do yet is refused by the option that asks for it.
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
  if (!solved_alike(system)) check_options(options);
  return system;
}

// A rank without rows gives no arrays; these stand for them and are neither read nor written.
template <class Value> Value* stand_in() {
  static const Value value{};
  return const_cast<Value*>(&value);
}

// As rank 0, which has rows, has them.
struct Given {
  bool gap, gap_single, mask, p0, p, p_single, deformed, deformed_single;
};

void stand_in_for(const Given& given, rc_step& step, Outputs& outputs) {
  step.undeformed_gap = given.gap ? stand_in<double>() : nullptr;
  step.undeformed_gap_single = given.gap_single ? stand_in<float>() : nullptr;
  step.mask = given.mask ? stand_in<std::uint8_t>() : nullptr;
  step.p0 = given.p0 ? stand_in<double>() : nullptr;
  outputs.p = {given.p ? stand_in<double>() : nullptr, given.p_single ? stand_in<float>() : nullptr};
  outputs.gap = {given.deformed ? stand_in<double>() : nullptr, given.deformed_single ? stand_in<float>() : nullptr};
}

Given given_by(const rc_step& step, const Outputs& outputs) {
  return {step.undeformed_gap != nullptr,
          step.undeformed_gap_single != nullptr,
          step.mask != nullptr,
          step.p0 != nullptr,
          outputs.p.in_double != nullptr,
          outputs.p.in_single != nullptr,
          outputs.gap.in_double != nullptr,
          outputs.gap.in_single != nullptr};
}

}  // namespace

bool solved_alike(const rc_system& system) { return std::min(system.nx, system.ny) < least_shared_side; }

SharedContact::SharedContact(const Ranks& ranks, const rc_system& system, const rc_options& options)
    : ranks_(ranks.on(checked(system, options).ny, !solved_alike(system))), alike_(solved_alike(system)) {
  contact_ = std::make_unique<Contact>(system, options, alike_ ? Company::repeated() : Company::by_rows(ranks_));
}

template <class Value> const Value* SharedContact::gathered(const Value* mine, std::vector<Value>& all) const {
  if (!mine) return nullptr;
  on_all(&ranks_, [&] { all.resize(static_cast<std::size_t>(ranks_.all_rows() * columns())); });
  ranks_.gather_rows(mine, columns(), all.data());
  return all.data();
}

Numbers SharedContact::run_alike(const rc_step& step, const Outputs& outputs, Action action) {
  std::vector<double> gap, p0, p, deformed;
  std::vector<float> gap_single, p_single, deformed_single;
  std::vector<std::uint8_t> mask;
  rc_step whole = step;
  whole.borrow = 0;
  whole.undeformed_gap = gathered(step.undeformed_gap, gap);
  whole.undeformed_gap_single = gathered(step.undeformed_gap_single, gap_single);
  whole.mask = gathered(step.mask, mask);
  whole.p0 = gathered(step.p0, p0);
  if (action == &Contact::certify) {
    gathered(outputs.p.in_double, p);
    gathered(outputs.p.in_single, p_single);
  }
  Numbers numbers;
  on_all(&ranks_, [&] {
    const auto room = [&]<class Value>(const Value* wanted, std::vector<Value>& of) -> Value* {
      if (!wanted) return nullptr;
      of.resize(static_cast<std::size_t>(ranks_.all_rows() * columns()));
      return of.data();
    };
    const Outputs all{{room(outputs.p.in_double, p), room(outputs.p.in_single, p_single)},
                      {room(outputs.gap.in_double, deformed), room(outputs.gap.in_single, deformed_single)}};
    numbers = (*contact_.*action)(whole, all);
  });
  const std::string message = last_message();
  const auto rows = [&]<class Value>(Value* to, const std::vector<Value>& of) {
    if (to) std::copy_n(of.data() + ranks_.first_row() * columns(), own_points(), to);
  };
  if (action != &Contact::certify) {
    rows(outputs.p.in_double, p);
    rows(outputs.p.in_single, p_single);
  }
  rows(outputs.gap.in_double, deformed);
  rows(outputs.gap.in_single, deformed_single);
  set_message(message.c_str());
  return numbers;
}

Numbers SharedContact::run(const rc_step& step, const Outputs& outputs, Action action) {
  check_agreement(ranks_, facts_of(step, outputs), ranks_.rows() > 0);
  const Given given = ranks_.of_each(given_by(step, outputs)).front();
  rc_step asked = step;
  Outputs to = outputs;
  if (ranks_.rows() == 0) stand_in_for(given, asked, to);
  return alike_ ? run_alike(asked, to, action) : (*contact_.*action)(asked, to);
}

rc_status SharedContact::run(const rc_history& path, std::int64_t& completed) {
  rc_history today = path;
  check_agreement(ranks_, facts_of(today), ranks_.rows() > 0);
  const std::vector<char> has_mask = ranks_.of_each(static_cast<char>(today.mask != nullptr)),
                          has_gap = ranks_.of_each(static_cast<char>(today.undeformed_gap != nullptr));
  const std::int32_t want_gap = ranks_.of_each(today.want_gap).front();
  if (ranks_.rows() == 0) {
    today.undeformed_gap = has_gap.front() != 0 ? stand_in<double>() : nullptr;
    today.mask = has_mask.front() != 0 ? stand_in<std::uint8_t>() : nullptr;
    today.want_gap = want_gap;
  }
  // The caller's function sees this rank's rows; one that ends the path ends it everywhere.
  struct Told {
    const SharedContact& self;
    const rc_history& path;
  } told{*this, today};
  rc_history inner = today;
  if (today.fn) {
    inner.user = &told;
    inner.fn = [](std::int64_t step, const rc_result* result, void* user) -> std::int32_t {
      const Told& of = *static_cast<const Told*>(user);
      rc_result rows = *result;
      if (of.self.alike_) {
        const std::int64_t before = of.self.ranks_.first_row() * of.self.columns();
        rows.p += before;
        if (rows.gap) rows.gap += before;
      }
      return of.self.ranks_.any(of.path.fn(step, &rows, of.path.user) != 0) ? 1 : 0;
    };
  }
  std::vector<double> gap;
  std::vector<std::uint8_t> mask;
  if (alike_) {
    inner.undeformed_gap = gathered(today.undeformed_gap, gap);
    inner.mask = gathered(today.mask, mask);
  }
  return rc::solve_history(*contact_, inner, completed);
}

}  // namespace rc
