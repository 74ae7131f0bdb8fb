// The operators of one grid, made when a step first needs them and kept for the next: one for each backend.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "contact/monitor.h"
#include "contact/problem.h"
#include "operator/operator.h"

namespace rc {

class Operators {
 public:
  // The problem must outlive them.
  explicit Operators(const GridProblem& problem) : problem_(problem) {}

  // This backend's operator, bound to that trial set.
  Operator& bound(const rc_backend& backend, const TrialSet& trial);
  void drop(const char* backend) { made_.erase(backend); }
  // Factors depend on the order in which points came, transforms on earlier, larger boxes. After this the next answer has the
  // bits of a first one.
  void forget();
  // A step is over: what operators keep for products only is freed, or lent to other contacts.
  void rest();
  Spent spent() const;
  // Dimensionless influence coefficients. The last table is kept, because solvers ask for the same one at every step.
  rc_status coefficients(std::int64_t mx, std::int64_t my, double* out);
  // From here on the operators of this process's rows on the same grid make each product, all processes together.
  void multiply_by(Operators& rows) { rows_ = &rows; }
  bool multiply_by_rows() const { return rows_ != nullptr; }

 private:
  // Free systems: by all threads. False if that is not possible, or some value is refused: out is then to be filled anew.
  bool coefficients_by_team(std::int64_t mx, std::int64_t my, double* out) const;

  struct Table {
    std::int64_t mx = 0, my = 0;
    std::shared_ptr<const std::vector<double>> values;  // shared by contacts of one context with the same system
  };

  const GridProblem& problem_;
  Operators* rows_ = nullptr;
  std::map<std::string, std::unique_ptr<Operator>> made_;
  double setup_seconds_ = 0;
  Table table_;
};

// Its destructor says to the operators that no product follows soon.
class Rest {
 public:
  explicit Rest(const GridProblem& problem) : operators_(problem.operators()) {}
  ~Rest() { operators_.rest(); }
  Rest(const Rest&) = delete;
  Rest& operator=(const Rest&) = delete;

 private:
  Operators& operators_;
};

}  // namespace rc
