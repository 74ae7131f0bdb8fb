#include "contact/operators.h"

#include <algorithm>
#include <atomic>
#include <roughcontact/plugin.hpp>
#include <utility>

#include "core/error.h"

namespace rc {

Operator& Operators::bound(const rc_backend& backend, const TrialSet& trial) {
  const auto begun = Clock::now();
  const System& system = problem_.system;
  auto it = made_.find(backend.name);
  if (it == made_.end()) {
    auto made = rows_ ? std::make_unique<Operator>(rows_->bound(backend, {rows_->problem_.own_points(), {}}))
                      : std::make_unique<Operator>(backend, problem_.host, system.unit, system.kernel.name, problem_.options,
                                                   problem_.team(), system.operator_scale, problem_.rows());
    it = made_.emplace(backend.name, std::move(made)).first;
  }
  it->second->bind(trial);
  setup_seconds_ += seconds_since(begun);
  return *it->second;
}

void Operators::forget() {
  std::erase_if(made_, [](const auto& entry) { return !entry.second->forget(); });
}

void Operators::rest() {
  for (const auto& [name, op] : made_) op->rest();
}

Spent Operators::spent() const {
  Spent total{0, setup_seconds_};
  for (const auto& [name, op] : made_) total.products += op->products();
  return total;
}

bool Operators::coefficients_by_team(std::int64_t mx, std::int64_t my, double* out) const {
  constexpr std::int64_t values_at_once = 1 << 15;
  const System& system = problem_.system;
  const rc_team& team = problem_.team();
  const Host& host = problem_.host;
  if (system.unit.boundary == RC_BOUNDARY_PERIODIC || team.threads == 1) return false;
  const std::int64_t rows = std::max<std::int64_t>(1, values_at_once / mx);
  std::atomic<bool> all = true;
  roughcontact::for_each(team, (my + rows - 1) / rows, true, [&](std::int64_t item, std::int64_t) {
    const std::int64_t first = item * rows, count = std::min(rows, my - first);
    if (host.window(&host, &system.unit, system.kernel.name.c_str(), 0, first, mx, count, out + first * mx) != RC_OK) all = false;
  });
  return all;
}

rc_status Operators::coefficients(std::int64_t mx, std::int64_t my, double* out) {
  constexpr std::int64_t most = 1 << 14;  // values that are kept
  const System& system = problem_.system;
  const Host& host = problem_.host;
  const auto computed = [&](double* to) {
    return host.coefficients(&host, &system.unit, system.kernel.name.c_str(), mx, my, to);
  };
  if (mx > most / my) return coefficients_by_team(mx, my, out) ? RC_OK : computed(out);
  if (mx != table_.mx || my != table_.my) {
    rc_status status = RC_OK;
    const auto make = [&] {
      auto values = std::make_shared<std::vector<double>>(static_cast<std::size_t>(mx * my));
      status = computed(values->data());
      return status == RC_OK ? values : nullptr;
    };
    const std::string key = join("coefficients ", mx, " ", my, " ", host.identity);
    auto values = problem_.options.context->shared().get<const std::vector<double>>(key, make);
    if (!values) return status;
    table_ = {mx, my, std::move(values)};
  }
  std::copy(table_.values->begin(), table_.values->end(), out);
  return RC_OK;
}

}  // namespace rc
