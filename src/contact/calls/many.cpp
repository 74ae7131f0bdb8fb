#include "contact/calls/many.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "contact/step/choice.h"
#include "core/certificate_terms.h"
#include "core/error.h"
#include "core/large_memory.h"

namespace rc {

namespace {

// Pressures of one call: enough to be worth it, few enough for a stop to be seen soon and for 256 MiB of memory.
constexpr std::int64_t least_together = std::int64_t{1} << 22, most_together = std::int64_t{1} << 25;

// What answers of many have no place for.
bool asks_for_more(const Workspace& work, const rc_batch& batch) {
  const rc_options& options = work.options;
  return batch.fn || batch.stiffness || options.integer(RC_OPT_STIFFNESS) != 0 || work.goal.error > 0 ||
         !options.text(RC_OPT_CERTIFY_BACKEND).empty() || options.text(RC_OPT_WARMUP) != "none";
}

}  // namespace

std::optional<ManySolve> ManySolve::of(const Workspace& work, const rc_batch& batch, std::int64_t threads) {
  const std::int64_t points = work.system.points();
  if (batch.n < 2 || batch.steps < 1 || !work.system.halfspace() || asks_for_more(work, batch)) return std::nullopt;
  ManySolve many(work, batch);
  try {
    const StepFacts facts{.control = batch.control,
                          .candidates = points,
                          .box = points,
                          .tol = work.options.real(RC_OPT_TOL),
                          .at_once = batch.n,
                          .threads = threads};
    const Choice choice = choose(work.options, work.system, facts);
    many.solver_ = choice.solver;
    many.backend_ = choice.backend->name;
  } catch (const Error&) {
    return std::nullopt;  // each contact says what is missing
  }
  if (!many.solver_->solve_many) return std::nullopt;
  many.grid_ = work.grid();
  many.grid_.mask = nullptr;
  Request question = many.request(0, 0);
  const rc_status status = many.solver_->solve_many(&work.host, &question, &work.options);
  clear_message();
  if (status != RC_OK) return std::nullopt;
  const std::int64_t share = (batch.n + threads - 1) / threads;
  const std::int64_t values = batch.steps > most_together / points ? most_together : batch.steps * points;  // of a contact
  many.at_once_ = std::max<std::int64_t>(1, std::clamp(share, least_together / values, most_together / values));
  return many;
}

ManySolve::Request ManySolve::request(std::int64_t first, std::int64_t n) const {
  const System& system = work_.system;
  Request request{};
  request.struct_size = sizeof(rc_many);
  request.grid = &grid_;
  request.n = n;
  request.steps = batch_.steps;
  request.control = batch_.control;
  request.warm_start = batch_.warm_start;
  request.backend = backend_.c_str();
  request.targets = batch_.targets + first * batch_.target_stride;
  request.target_stride = batch_.target_stride;
  request.undeformed_gap = batch_.undeformed_gap + first * batch_.undeformed_gap_stride;
  request.undeformed_gap_stride = batch_.undeformed_gap_stride;
  request.mask = batch_.mask ? batch_.mask + first * batch_.mask_stride : nullptr;
  request.mask_stride = batch_.mask_stride;
  request.p0 = batch_.p0 ? batch_.p0 + first * system.points() : nullptr;
  request.length_per_pressure = system.length_per_pressure;
  request.hardness = system.hardness;
  request.least_deflection = system.least_deflection * system.length_per_pressure;
  request.tol = work_.options.real(RC_OPT_TOL);
  request.max_iterations = work_.options.integer(RC_OPT_MAX_ITER);
  request.work = &work_;
  request.coefficients = [](const rc_many* many, std::int64_t mx, std::int64_t my, double* out) {
    const System& of = static_cast<const Request*>(many)->work->system;
    const Host& host = static_cast<const Request*>(many)->work->host;
    return host.coefficients(&host, &of.unit, of.kernel.c_str(), mx, my, out);
  };
  return request;
}

ManyAnswers ManySolve::solved(std::int64_t first, std::int64_t last) const {
  ManyAnswers answers;
  const std::int64_t slots = (last - first) * batch_.steps;
  try {
    answers.all.resize(static_cast<std::size_t>(slots));
    answers.p = large_vector<double>(static_cast<std::size_t>(slots * work_.system.points()));
  } catch (const std::bad_alloc&) {
    log(first, last, "out of memory");
    return {};
  }
  Request asked = request(first, last - first);
  asked.answers = answers.all.data();
  asked.p = answers.p.data();
  const rc_status status = solver_->solve_many(&work_.host, &asked, &work_.options);
  if (status != RC_OK) log(first, last, last_message());
  clear_message();
  if (status == RC_OK) answers.contacts = std::clamp<std::int64_t>(asked.done, 0, last - first);
  return answers;
}

void ManySolve::log(std::int64_t first, std::int64_t last, const char* why) const {
  const std::string text =
      join("solver \"", solver_->name, "\": contacts ", first, " .. ", last - 1, " are solved one at a time: ", why);
  work_.host.log(&work_.host, RC_LOG_WARNING, text.c_str());
}

rc_result ManySolve::result(const rc_many_answer& answer, std::int64_t i, std::int64_t k) const {
  const double target = batch_.targets[i * batch_.target_stride + k], load = answer.sum * work_.system.cell_area();
  const bool by_load = batch_.control == RC_CONTROL_LOAD;
  rc_result result = RC_RESULT_INIT;
  result.status = RC_OK;
  result.load = load;
  result.approach = by_load ? answer.lowest + answer.compression : target;
  result.contact_area = static_cast<double>(answer.contacts) * work_.system.cell_area();
  result.stiffness = result.punch_stiffness = std::numeric_limits<double>::quiet_NaN();
  result.kkt_primal = answer.primal;
  result.kkt_dual = answer.dual;
  result.kkt_complementarity = answer.complementarity;
  result.kkt_control = by_load ? load_imbalance(load, target) : 0;
  result.iterations = answer.iterations;
  result.products = answer.products;
  return result;
}

}  // namespace rc
