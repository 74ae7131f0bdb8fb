#include "contact/calls/many_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <random>
#include <span>
#include <vector>

#include "core/certificate_terms.h"
#include "core/error.h"
#include "core/grid.h"
#include "core/limits.h"

namespace rc {

namespace {

// One contact of every `block` is computed anew, and at least `least_anew` of a call.
constexpr std::size_t block = 64, least_anew = 8;
// Residuals computed anew may differ by this share of tol from those reported. Answers that report more than near_tol times tol
// are all computed anew, so that this difference cannot lift one above tol.
constexpr double allowed_share = 0.25, near_tol = 0.5;

struct Sums {
  double sum = 0, absolute = 0, largest = 0, least = 0;
  std::int64_t contacts = 0;
  bool outside = false;  // some masked point carries pressure
};

Sums sums_of(std::span<const double> p, const std::uint8_t* mask) {
  Sums all;
  for (std::size_t i = 0; i < p.size(); ++i) {
    all.sum += p[i];
    all.absolute += std::abs(p[i]);
    all.largest = std::max(all.largest, std::abs(p[i]));
    all.least = std::min(all.least, p[i]);
    all.contacts += p[i] > 0;
    all.outside = all.outside || (mask && mask[i] == 0 && p[i] != 0);
  }
  return all;
}

class Check {
 public:
  Check(const rc_batch& batch, ManyAnswers& answers, std::int64_t first, Contact& contact)
      : batch_(batch),
        answers_(answers),
        first_(first),
        contact_(contact),
        system_(contact.problem().system),
        tol_(contact.problem().options.real(RC_OPT_TOL)) {}

  // Throws Error(NUMERIC) with the first answer that is not as reported.
  void run(std::span<const std::int64_t> solved) {
    for (const std::int64_t i : solved) compare_pressures(i);
    for (const std::int64_t i : sample(solved)) compute_anew(i);
  }

 private:
  template <class... Parts> [[noreturn]] void refuse(std::int64_t i, std::int64_t k, const Parts&... parts) const {
    fail(RC_ERR_NUMERIC, "contact ", first_ + i, ", step ", k, ": ", parts...);
  }
  const rc_many_answer& answer(std::int64_t i, std::int64_t k) const {
    return answers_.all[static_cast<std::size_t>(i * batch_.steps + k)];
  }
  std::span<double> pressures(std::int64_t i, std::int64_t k) const {
    const auto n = static_cast<std::size_t>(system_.points());
    return std::span(answers_.p).subspan(static_cast<std::size_t>(i * batch_.steps + k) * n, n);
  }
  const double* gap(std::int64_t i) const {
    return values_of<double>(batch_.undeformed_gap) + (first_ + i) * batch_.undeformed_gap_stride;
  }
  const std::uint8_t* mask(std::int64_t i) const {
    return values_of<std::uint8_t>(from_value(batch_.mask, (first_ + i) * batch_.mask_stride, sizeof(std::uint8_t)));
  }
  double target(std::int64_t i, std::int64_t k) const {
    return values_of<double>(batch_.targets)[(first_ + i) * batch_.target_stride + k];
  }
  bool by_load() const { return batch_.control == RC_CONTROL_LOAD; }

  double lowest_gap(std::int64_t i) const {
    double lowest = std::numeric_limits<double>::infinity();
    for (std::int64_t m = 0; m < system_.points(); ++m) {
      if (mask(i) && mask(i)[m] == 0) continue;
      if (!std::isfinite(gap(i)[m])) refuse(i, 0, "the gap at ", place(m, system_.given.nx), " is not finite");
      lowest = std::min(lowest, gap(i)[m]);
    }
    return lowest;
  }

  void compare_pressures(std::int64_t i) const {
    const double lowest = lowest_gap(i);
    for (std::int64_t k = 0; k < batch_.steps; ++k) {
      const rc_many_answer& reported = answer(i, k);
      const Sums found = sums_of(pressures(i, k), mask(i));
      for (const double residual : {reported.primal, reported.dual, reported.complementarity})
        if (!(residual <= tol_)) refuse(i, k, "a residual is reported as ", residual, ", above tol = ", tol_);
      if (!std::isfinite(found.absolute) || !std::isfinite(target(i, k))) refuse(i, k, "pressures or target are not finite");
      if (found.outside) refuse(i, k, "a masked point carries pressure");
      if (const double primal = primal_violation(found.least, found.largest, system_.hardness); !(primal <= tol_))
        refuse(i, k, "kkt_primal is ", primal, ", the lowest pressure ", found.least, ", the highest ", found.largest);
      if (found.contacts != reported.contacts)
        refuse(i, k, found.contacts, " points carry pressure, reported as ", reported.contacts);
      const double rounding = (static_cast<double>(system_.points()) + 8) * epsilon * found.absolute;
      if (!(std::abs(found.sum - reported.sum) <= rounding))
        refuse(i, k, "the sum of the pressures is ", found.sum, ", reported as ", reported.sum);
      if (by_load())
        if (const double control = load_imbalance(found.sum * system_.cell_area(), target(i, k)); !(control <= tol_))
          refuse(i, k, "kkt_control is ", control);
      // Later steps of a contact with a hardness have an indentation in their gap.
      if ((k == 0 || !system_.capped()) && !(std::abs(reported.lowest - lowest) <= 4 * epsilon * std::abs(lowest)))
        refuse(i, k, "the lowest gap is ", lowest, ", reported as ", reported.lowest);
      if (!std::isfinite(reported.lowest + reported.compression)) refuse(i, k, "the approach is not finite");
    }
  }

  bool near(std::int64_t i) const {
    for (std::int64_t k = 0; k < batch_.steps; ++k)
      if (const rc_many_answer& reported = answer(i, k); std::max(reported.dual, reported.complementarity) > near_tol * tol_)
        return true;
    return false;
  }

  // One of each of k parts. If a share f of the answers is wrong, all of these are right with a probability of (1 - f)^k at most.
  std::vector<std::int64_t> sample(std::span<const std::int64_t> solved) const {
    std::random_device random;  // read after the solver has answered
    const std::size_t parts = std::max((solved.size() + block - 1) / block, std::min(solved.size(), least_anew));
    std::vector<std::int64_t> chosen;
    for (std::size_t k = 0; k < parts; ++k) {
      const std::size_t begin = solved.size() * k / parts;
      const std::span<const std::int64_t> part = solved.subspan(begin, solved.size() * (k + 1) / parts - begin);
      const std::int64_t any = part[std::uniform_int_distribution<std::size_t>(0, part.size() - 1)(random)];
      for (const std::int64_t i : part)
        if (i == any || near(i)) chosen.push_back(i);
    }
    return chosen;
  }

  // All steps, because each leaves an indentation to the next where there is a hardness.
  void compute_anew(std::int64_t i) {
    contact_.forget(Forgotten::surface);
    for (std::int64_t k = 0; k < batch_.steps; ++k) {
      const rc_many_answer& reported = answer(i, k);
      rc_step step = RC_STEP_INIT;
      step.control = batch_.control;
      step.target = target(i, k);
      if (k == 0) {
        step.undeformed_gap.data = gap(i);
        step.mask.data = mask(i);
        step.borrow = 1;
      }
      Numbers found;
      try {
        found = contact_.certify(step, {{pressures(i, k).data()}, {}}, reported.compression);
      } catch (const Error& error) {
        refuse(i, k, error.what());
      }
      const auto differs = [&](const char* name, double value, double as_reported) {
        if (!(value <= tol_ && std::abs(value - as_reported) <= allowed_share * tol_))
          refuse(i, k, name, " is ", value, ", reported as ", as_reported, ", tol is ", tol_);
      };
      differs("kkt_dual", found.certificate.dual, reported.dual);
      differs("kkt_complementarity", found.certificate.complementarity, reported.complementarity);
      const double rounding = 8 * epsilon * std::abs(reported.lowest), approach = reported.lowest + reported.compression;
      if (by_load() && !(std::abs(found.approach - approach) <= allowed_share * tol_ * reported.compression + rounding))
        refuse(i, k, "the approach is ", found.approach, ", reported as ", approach);
    }
  }

  const rc_batch& batch_;
  ManyAnswers& answers_;
  const std::int64_t first_;
  Contact& contact_;
  const System& system_;
  const double tol_;
};

}  // namespace

std::string refusal(const rc_batch& batch, ManyAnswers& answers, std::span<const std::int64_t> solved, std::int64_t first,
                    Contact& contact) {
  try {
    Check(batch, answers, first, contact).run(solved);
    clear_message();
    return {};
  } catch (const Error& error) {
    return error.what();
  } catch (const std::bad_alloc&) {
    return "out of memory";
  }
}

}  // namespace rc
