// The contacts of a batch that a solver takes many of in one call.
#pragma once

#include <roughcontact/history.h>
#include <roughcontact/plugin.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "contact/problem.h"
#include "contact/proof/result.h"

namespace rc {

// The solver's answers for the contacts from `first` on; those that are not solved are solved one at a time.
struct ManyAnswers {
  std::vector<rc_many_answer> all;  // [contacts * steps]
  std::vector<double> p;            // [contacts * steps * points]
  std::int64_t contacts = 0;        // 0: the call failed

  // Whether the solver reports that every step of contact i is solved.
  bool solved(std::int64_t i, std::int64_t steps) const {
    const auto begin = all.begin() + i * steps;
    return std::all_of(begin, begin + steps, [](const rc_many_answer& answer) { return answer.solved != 0; });
  }
};

class ManySolve {
 public:
  // None if the options, or what the batch asks for, leave no solver that takes them. problem: of a contact of the batch, which
  // must outlive it; threads: that share the batch.
  static std::optional<ManySolve> of(const GridProblem& problem, const rc_batch& batch, std::int64_t threads);

  std::int64_t at_once() const { return at_once_; }  // contacts of one call
  // Solves contacts first .. last-1, or as many of them as fit. Several threads may call it at the same time.
  ManyAnswers solved(std::int64_t first, std::int64_t last) const;
  // The numbers of step k of contact i, which is solved.
  Numbers numbers(const rc_many_answer& answer, std::int64_t i, std::int64_t k) const;
  // In the context's log: contacts first .. last-1 are solved one at a time.
  void log(std::int64_t first, std::int64_t last, const char* why) const;

 private:
  struct Request : rc_many {
    const GridProblem* problem;
  };

  ManySolve(const GridProblem& problem, const rc_batch& batch) : problem_(problem), batch_(batch) {}
  Request request(std::int64_t first, std::int64_t n) const;

  const GridProblem& problem_;
  const rc_batch& batch_;
  const rc_solver* solver_ = nullptr;
  std::string backend_;
  rc_grid grid_{};
  std::int64_t at_once_ = 0;
};

}  // namespace rc
