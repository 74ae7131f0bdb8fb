// One contact, many calls: steps, paths, batches, certificates, restored copies, other options, resets and cancellations in any
// order. Each answer is checked as if it stood alone, on the gap with the plastic indentation that the certified steps before it
// have left; after a reset it has the bits of a new contact's.
#include <roughcontact/history.h>

#include <algorithm>
#include <bit>
#include <memory>

#include "indentation.h"
#include "oracle.h"
#include "require.h"

namespace {

using fuzz::Answer, fuzz::Bytes, fuzz::Indentation, fuzz::Oracle, fuzz::Problem, fuzz::Reals, fuzz::require, fuzz::Scene,
    fuzz::Step;

constexpr int most_calls = 8;
constexpr std::int64_t history = 2;  // steps of a path

// A result that a path or a batch shows, as an answer.
void check_shown(const Oracle& oracle, Indentation& indentation, const Problem& problem, const rc_result& shown) {
  Answer answer(static_cast<std::size_t>(shown.points));
  std::copy_n(static_cast<double*>(shown.p.data), shown.points, answer.p.begin());
  std::copy_n(static_cast<double*>(shown.gap.data), shown.points, answer.gap.begin());
  answer.result = shown;
  answer.status = shown.status;
  answer.explained = shown.status != RC_OK && shown.status != RC_WITHIN_GOAL;
  oracle.check(indentation.seen(problem), answer);
  indentation.commit(answer);
}

struct Shown {
  const Oracle& oracle;
  Problem problem;
  const double* targets;
  std::vector<Indentation> indentation;  // of each contact
};

std::int32_t of_path(std::int64_t step, const rc_result* result, void* user) {
  Shown& shown = *static_cast<Shown*>(user);
  shown.problem.target = shown.targets[step];
  check_shown(shown.oracle, shown.indentation.front(), shown.problem, *result);
  return 0;
}

std::int32_t of_batch(std::int64_t contact, std::int64_t step, const rc_result* result, void* user) {
  Shown& shown = *static_cast<Shown*>(user);
  Problem problem = shown.problem;
  problem.target = shown.targets[contact * history + step];
  check_shown(shown.oracle, shown.indentation[static_cast<std::size_t>(contact)], problem, *result);
  return 0;
}

class Sequence {
 public:
  Sequence(Bytes& bytes, Scene& scene)
      : bytes_(bytes), scene_(scene), oracle_(scene), options_(fuzz::make_options(scene)), indentation_(scene) {
    if (rc_contact_create(&scene.system, options_, &contact_) != RC_OK) contact_ = nullptr;
  }
  ~Sequence() {
    rc_contact_destroy(contact_);
    rc_options_destroy(options_);
  }
  Sequence(const Sequence&) = delete;
  Sequence& operator=(const Sequence&) = delete;

  void run() {
    for (int call = 0; contact_ && call < most_calls && !bytes_.empty(); ++call) {
      switch (bytes_.below(16)) {
        case 7:
          certify();
          break;
        case 8:
          path();
          break;
        case 9:
          batch();
          break;
        case 10:
          rc_contact_reset(contact_);
          forget();
          break;
        case 11:
          set_option();
          break;
        case 12:
          rc_contact_cancel(contact_);
          cancelled_ = true;
          break;
        case 13:
          as_a_new_one();
          break;
        case 14:
          restored();
          break;
        case 15:
          look();
          break;
        default:
          solve();
      }
      indentation_.require_of(contact_);
    }
  }

 private:
  // All steps are kept, because the contact may borrow their arrays.
  Step& next_step() {
    steps_.push_back(std::make_unique<Step>());
    Step& step = *steps_.back();
    fuzz::read_step(bytes_, scene_, {last_.load, last_.approach}, gap_ != nullptr, step);
    return step;
  }

  Problem problem_of(const rc_step& step) const {
    // A mask alone is a new mask for the gap of the step before. Without mask and gap both are those of the step before.
    return {step.undeformed_gap.data ? fuzz::gap_of(step) : gap_,
            step.mask.data || step.undeformed_gap.data ? fuzz::mask_of(step) : mask_, step.control, step.target};
  }

  // After a step that failed, at once or later, it is not known which gap the contact has.
  void took(const Problem& problem, rc_status status) {
    gap_ = status >= 0 ? problem.gap : nullptr;
    mask_ = status >= 0 ? problem.mask : nullptr;
  }

  // A certificate leaves a cancellation to the next step that is solved.
  void solved(const Problem& problem, rc_status status) {
    cancelled_ = cancelled_ && status < 0;
    took(problem, status);
  }

  void forget() {
    gap_ = nullptr;
    mask_ = nullptr;
    last_p_.clear();
    indentation_.forget();
  }

  void solve() {
    const rc_step& step = next_step().given;
    const Problem problem = problem_of(step);
    Answer answer(scene_.points());
    answer.took(rc_contact_solve(contact_, &step, &answer.result));
    oracle_.check(indentation_.seen(problem), answer);
    indentation_.commit(answer);
    solved(problem, answer.status);
    if (answer.status != RC_OK) return;
    last_ = answer.result;
    last_p_ = answer.p;
    last_problem_ = problem;
  }

  void certify() {
    const rc_step& step = next_step().given;
    const Problem problem = problem_of(step);
    Answer answer(scene_.points());
    answer.given = true;
    const Reals untouched = answer.gap;
    answer.p.assign(scene_.points(), 0.0);
    if (last_p_.size() == answer.p.size()) answer.p = last_p_;
    const int change = bytes_.whole();
    if (change != 0) answer.p[static_cast<std::size_t>(change & 63) % answer.p.size()] *= change / 64.0;
    for (std::size_t i = 0; problem.mask && i < answer.p.size(); ++i)
      if (problem.mask[i] == 0) answer.p[i] = 0;
    const Reals given = answer.p;
    answer.took(rc_contact_certify(contact_, &step, &answer.result));
    const auto same = [](double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); };
    require(std::ranges::equal(given, answer.p, same), "certifying leaves the pressures as they are");
    require(answer.status >= 0 || std::ranges::equal(untouched, answer.gap, same), "a failed certificate writes no gap");
    if (answer.status >= 0) oracle_.check(indentation_.seen(problem), answer);
    took(problem, answer.status);
  }

  void path() {
    const Step& step = next_step();
    const Problem problem = problem_of(step.given);
    const double targets[history] = {step.given.target, step.given.target * (1 + bytes_.whole() / 256.0)};
    rc_history path = RC_HISTORY_INIT;
    path.control = step.given.control;
    path.warm_start = step.given.warm_start;
    path.n = history;
    path.targets = RC_IN(targets);
    path.undeformed_gap = step.given.undeformed_gap;
    path.mask = step.given.mask;
    Shown shown{oracle_, problem, targets, {indentation_}};
    path.fn = of_path;
    path.user = &shown;
    const rc_status status = rc_contact_solve_history(contact_, &path);
    require(path.completed >= 0 && path.completed <= history, "completed steps are some of the path's");
    require((status == RC_OK || status == RC_WITHIN_GOAL) == (path.completed == history) || status == RC_STOP_CANCELLED,
            "a path that ends well is complete");
    indentation_ = shown.indentation.front();
    solved(problem, status);
    last_p_.clear();
  }

  void batch() {
    steps_.push_back(std::make_unique<Step>());
    Step& step = *steps_.back();
    fuzz::read_step(bytes_, scene_, {}, false, step);
    double targets[2 * history];
    for (double& target : targets) target = step.given.target * (1 + bytes_.whole() / 256.0);
    rc_batch batch = RC_BATCH_INIT;
    batch.control = step.given.control;
    batch.n = 2;
    batch.steps = history;
    batch.targets = RC_IN(targets);
    batch.undeformed_gap = RC_IN(step.undeformed_gap.data());
    batch.undeformed_gap_stride = RC_BATCH_SHARED;
    batch.mask = step.given.mask;
    batch.mask_stride = RC_BATCH_SHARED;
    const Problem problem{step.undeformed_gap.data(), fuzz::mask_of(step.given), step.given.control, 0};
    Shown shown{oracle_, problem, targets, {2, Indentation(scene_)}};
    batch.fn = of_batch;
    batch.user = &shown;
    const rc_status status = rc_batch_solve(&scene_.system, options_, &batch);
    require(batch.written == 0 || batch.written == 2, "a batch is written or refused");
    require(status != RC_OK || batch.certified == 2, "a batch that ends well is certified");
  }

  void set_option() {
    const std::string line{bytes_.until('\n')};
    const auto equals = line.find('=');
    if (equals == std::string::npos || line.starts_with(RC_OPT_THREADS)) return;
    const std::string key = line.substr(0, equals), value = line.substr(equals + 1);
    rc_options_set_text(options_, key.c_str(), value.c_str());
    scene_.options.emplace_back(key, value);
    const rc_status status = rc_contact_set_options(contact_, options_);
    require(status <= 0 && status != RC_ERR_INTERNAL && status != RC_ERR_BUSY, "options are taken or refused");
  }

  // After a reset a cold step has the bits of a new contact's.
  void as_a_new_one() {
    rc_contact* other = nullptr;
    if (rc_contact_create(&scene_.system, options_, &other) != RC_OK) return;
    if (rc_contact_set_options(contact_, options_) == RC_OK) {
      rc_contact_reset(contact_);
      forget();
      steps_.push_back(std::make_unique<Step>());
      Step& step = *steps_.back();
      fuzz::read_step(bytes_, scene_, {}, false, step);
      const Problem problem = problem_of(step.given);
      scene_.fails_at = 0;
      Answer here(scene_.points()), there(scene_.points());
      here.took(rc_contact_solve(contact_, &step.given, &here.result));
      there.took(rc_contact_solve(other, &step.given, &there.result));
      oracle_.check(problem, here);
      oracle_.check(problem, there);
      indentation_.commit(here);
      double limit = 0;
      const bool timed = rc_options_get_number(options_, RC_OPT_TIME_LIMIT, &limit) == RC_OK && limit > 0;
      // A step that is stopped before it begins may still have a certified start.
      if (!cancelled_ && !timed) {
        require(here.status == there.status, "after a reset a step ends as in a new contact");
        require(here.status < 0 || here.p == there.p, "after a reset a step has the bits of a new contact's");
      }
      solved(problem, here.status);
    }
    rc_contact_destroy(other);
  }

  // A new contact goes on from the last answer.
  void restored() {
    if (last_p_.empty() || gap_ != last_problem_.gap) return;
    rc_contact* other = nullptr;
    if (rc_contact_create(&scene_.system, options_, &other) != RC_OK) return;
    rc_state state = RC_STATE_INIT;
    state.undeformed_gap = RC_IN(last_problem_.gap);
    state.mask = RC_IN(last_problem_.mask);
    state.p = RC_IN(last_p_.data());
    state.approach = last_.approach;
    state.load = last_.load;
    state.indentation = RC_IN(scene_.system.hardness > 0 ? indentation_.depth() : nullptr);
    require(rc_contact_restore(other, &state) == RC_OK, "an answer can be restored");
    Indentation indentation = indentation_;
    indentation.require_of(other);
    steps_.push_back(std::make_unique<Step>());
    Step& step = *steps_.back();
    fuzz::read_step(bytes_, scene_, {last_.load, last_.approach}, true, step);
    Problem problem = problem_of(step.given);
    if (!step.given.undeformed_gap.data && !step.given.mask.data) problem.mask = last_problem_.mask;
    Answer answer(scene_.points());
    answer.took(rc_contact_solve(other, &step.given, &answer.result));
    oracle_.check(indentation.seen(problem), answer);
    indentation.commit(answer);
    indentation.require_of(other);
    rc_contact_destroy(other);
  }

  void look() {
    std::int64_t n = -1, first = -1;
    require(rc_contact_points(contact_, 1, RC_OUT(&first), {}, &n) == RC_OK, "a contact tells its points");
    require(n >= 0 && n <= static_cast<std::int64_t>(scene_.points()), "points in contact are some of the grid's");
    if (!last_p_.empty()) require(n == last_.contacts, "the points in contact are those of the last certified step");
    rc_level level = RC_LEVEL_INIT;
    rc_contact_level(contact_, bytes_.whole(), &level);
  }

  Bytes& bytes_;
  Scene& scene_;
  const Oracle oracle_;
  rc_options* options_;
  rc_contact* contact_ = nullptr;
  std::vector<std::unique_ptr<Step>> steps_;
  const double* gap_ = nullptr;  // the contact's; null: none, or not known
  const std::uint8_t* mask_ = nullptr;
  bool cancelled_ = false;  // and no step has begun since
  rc_result last_{};        // of the last certified step, with its pressures; none after a path
  Reals last_p_;
  Problem last_problem_{};
  Indentation indentation_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  Scene scene;
  fuzz::read_scene(bytes, scene);
  Sequence(bytes, scene).run();
  return 0;
}
