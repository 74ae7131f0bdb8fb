// A scene, the library's answers to its steps, and the exact ones.
#pragma once

#include <roughcontact/history.h>

#include <memory>

#include "oracle.h"
#include "random.h"
#include "support/contact.h"

namespace scenes {

struct StepAnswer {
  rc_status status = RC_ERR_INTERNAL;
  rc_result result{};
  Field p, gap;
  Field indentation;        // before the step; empty: none
  Field indentation_after;  // empty without a hardness
  std::string message;
};

using Handle = std::unique_ptr<rc_contact, pairs::DestroyContact>;

/** For rc_contact_restore: after answer k. before: the answer before it pressed the same surface. */
rc_state state_after(const std::vector<StepAnswer>& answers, std::size_t k, const Surface& surface, bool before);

/** Owns what a system points to. */
class Case {
 public:
  explicit Case(std::uint64_t seed, bool reduced);
  Case(const Case&) = delete;
  Case& operator=(const Case&) = delete;

  /** If set, every scene is solved by this pair that can be. */
  static std::optional<pairs::Pair> only;

  const Scene& scene() const { return scene_; }
  const Influence& h() const { return h_; }
  const rc_system& system() const { return system_; }
  const pairs::Pair& pair() const { return pair_; }
  /** The name of the case in a message of failure. */
  std::string words() const;

  pairs::Options options(const pairs::Settings& changed = {}) const;
  Handle open(const pairs::Settings& changed = {}) const;
  rc_step step(const Step& step) const;
  /** By rc_contact_solve. */
  StepAnswer solve(rc_contact* contact, const Step& step) const;
  StepAnswer solve(rc_contact* contact, const rc_step& step) const;
  /** The answers to all steps in order, up to the first that is not certified. */
  std::vector<StepAnswer> solve_all(rc_contact* contact) const;

  const std::vector<StepAnswer>& answers() const { return answers_; }
  /** At the approach of answer k, with the surface that it pressed. `tied`: see exact_at. */
  const Exact& exact(std::size_t k, bool tied = false) const;
  Exact exact_of(const StepAnswer& answer, const Surface& surface, bool tied) const;
  const Surface& surface(std::size_t k) const { return scene_.surfaces[scene_.steps[k].surface]; }
  Real cap() const;

 private:
  Scene scene_;
  rc_system system_;
  Influence h_;
  pairs::Pair pair_;
  pairs::Settings solver_options_;
  std::vector<StepAnswer> answers_;
  mutable std::vector<std::optional<Exact>> exact_, tied_;
};

/** The length that certified gaps are relative to, see docs/development/derivation.md. */
Real residual_scale(const Scene& scene, const Surface& surface, const StepAnswer& answer, double target);

/** The prescribed load, if one is prescribed. */
double load_of(const Scene& scene, double target);

/** By how much the library's H p, computed in double precision, may be off. */
Real product_noise(const Case& c, const Surface& surface, const StepAnswer& answer);

}  // namespace scenes
