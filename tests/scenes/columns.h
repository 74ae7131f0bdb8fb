// The numbers of a history's or batch's steps, as arrays of their own.
#pragma once

#include <roughcontact/history.h>

#include "case.h"

namespace scenes {

struct Columns {
  static constexpr std::size_t approach = 1, mean_gap = 3;  // in `reals`
  explicit Columns(std::size_t steps);

  /** Leaves out some of the columns. The stiffness is asked for with its interval, if at all. */
  void leave_out(Random& random);
  /** Options of a single step that computes the same columns: the factor of a stiffness may serve the next step. */
  pairs::Settings options(const Scene& scene) const;
  /** Points a request's columns at these arrays from step `first` on, those that are wanted. */
  rc_columns request(std::size_t first = 0);
  /** The same numbers from an answer of rc_contact_solve. */
  void take(std::size_t k, const StepAnswer& answer);
  /** Fails unless steps first, first+1, ... of `all` have the same bits as these, where they are wanted. */
  void need_same(const Columns& all, std::size_t first, const std::string& what) const;

  std::vector<bool> wanted;  // each of `reals`
  std::vector<Field> reals;  // in the order of rc_columns
  std::vector<std::int64_t> iterations, products;
  std::vector<rc_status> status;
};

/** What a history's fn sees, in order. */
struct Pressures {
  std::size_t points;
  std::vector<Field> steps, gaps;
  std::vector<rc_result> results;
  rc_contact* contact = nullptr;
  std::size_t end = 0;  // fn ends the history after so many steps
};

/** By rc_contact_solve_history, with all columns. cut: fn ends it after so many steps, and another call goes on there. */
rc_status follow(const Case& c, rc_contact* contact, const Field& targets, const Surface& surface, Columns& columns,
                 Pressures& pressures, std::size_t cut = 0, bool virgin = false);

}  // namespace scenes
