// A budget: the table of contributions and what follows from it.
#pragma once

#include <roughcontact/budget.h>

#include <array>
#include <string>
#include <vector>

#include "request/budget/solves.h"
#include "request/budget/sources.h"

namespace rc::request {

struct Contribution {
  double standard = 0, shift = 0, first_order = std::numeric_limits<double>::quiet_NaN(),
         sampled = std::numeric_limits<double>::quiet_NaN();
  double freedom = std::numeric_limits<double>::infinity();

  double variance() const { return std::isnan(standard) ? 0 : standard * standard + shift * shift; }
};
using Row = std::array<Contribution, of::count>;

struct Combined {
  double standard, freedom, coverage;
  std::int64_t dominant;
  std::string sentence;
};

// The change of every quantity from its value, by each source in order.
std::vector<Row> rows_of(const rc_request_spec& spec, const rc_budget_spec& budget, const rc_request& base,
                         const Sources& sources, Outcome& value);

// A quantity; without units its unit is "".
struct Named {
  std::string name, unit;
};
// further: of rc_budget_spec.value.
std::array<Named, of::count> quantity_names(bool si, const Named& further);

// The combined uncertainty of one quantity from the contributions of all sources.
Combined combine(std::size_t quantity, const Named& named, double value, const std::vector<Row>& rows, const Sources& sources);

}  // namespace rc::request

struct rc_budget {
  rc::request::Sources sources;
  rc::request::Outcome value;
  std::vector<rc::request::Row> rows;
  std::array<rc::request::Named, rc::request::of::count> names;
  std::vector<rc::request::Combined> combined;  // of the quantities that there are
};
