#include "contact/calls/many.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "contact/choice.h"
#include "core/certificate_terms.h"
#include "core/error.h"
#include "core/large_memory.h"

namespace rc {

namespace {

// Pressures of one call: enough to be worth it, few enough for a stop to be seen soon and for 256 MiB of memory.
constexpr std::int64_t least_together = std::int64_t{1} << 22, most_together = std::int64_t{1} << 25;

bool any_floats(const rc_batch& batch) {
  return batch.undeformed_gap.type == RC_SINGLE || batch.p0.type == RC_SINGLE || batch.p.type == RC_SINGLE;
}

// Whether the call wants outputs that rc_many_answer does not have.
bool asks_for_more(const GridProblem& problem, const rc_batch& batch) {
  const rc_options& options = problem.options;
  return batch.virgin != 0 || batch.fn || batch.columns.mean_gap.data || batch.columns.energy.data ||
         options.integer(RC_OPT_STIFFNESS) != 0 || options.integer(RC_OPT_BOUNDS) != 0 || problem.goal.error > 0 ||
         !options.text(RC_OPT_CERTIFY_BACKEND).empty() || options.text(RC_OPT_WARMUP) != "none";
}

}  // namespace

std::optional<ManySolve> ManySolve::of(const GridProblem& problem, const rc_batch& batch, std::int64_t threads) {
  const std::int64_t points = problem.system.points();
  if (batch.n < 2 || batch.steps < 1 || batch.control == RC_CONTROL_AREA || !problem.system.halfspace() ||
      !problem.system.creep.empty() || any_floats(batch) || asks_for_more(problem, batch))
    return std::nullopt;
  ManySolve many(problem, batch);
  try {
    const StepFacts facts{.control = batch.control,
                          .candidates = points,
                          .box = points,
                          .tol = problem.options.real(RC_OPT_TOL),
                          .at_once = batch.n,
                          .threads = threads};
    const Choice choice = choose(problem.options, problem.system, facts);
    many.solver_ = choice.solver;
    many.backend_ = choice.backend->name;
  } catch (const Error&) {
    return std::nullopt;  // each contact says what is missing
  }
  if (!many.solver_->solve_many) return std::nullopt;
  many.grid_ = grid_of(problem);
  many.grid_.mask = nullptr;
  Request question = many.request(0, 0);
  const rc_status status = many.solver_->solve_many(&problem.host, &question, &problem.options);
  clear_message();
  if (status != RC_OK) return std::nullopt;
  const std::int64_t share = (batch.n + threads - 1) / threads;
  const std::int64_t values = batch.steps > most_together / points ? most_together : batch.steps * points;  // of a contact
  many.at_once_ = std::max<std::int64_t>(1, std::clamp(share, least_together / values, most_together / values));
  return many;
}

ManySolve::Request ManySolve::request(std::int64_t first, std::int64_t n) const {
  const System& system = problem_.system;
  Request request{};
  request.struct_size = sizeof(rc_many);
  request.grid = &grid_;
  request.n = n;
  request.steps = batch_.steps;
  request.control = batch_.control;
  request.warm_start = batch_.warm_start;
  request.backend = backend_.c_str();
  request.targets = values_of<double>(batch_.targets) + first * batch_.target_stride;
  request.target_stride = batch_.target_stride;
  request.undeformed_gap = values_of<double>(batch_.undeformed_gap) + first * batch_.undeformed_gap_stride;
  request.undeformed_gap_stride = batch_.undeformed_gap_stride;
  request.mask = values_of<std::uint8_t>(from_value(batch_.mask, first * batch_.mask_stride, sizeof(std::uint8_t)));
  request.mask_stride = batch_.mask_stride;
  request.p0 = values_of<double>(from_value(batch_.p0, first * system.points(), sizeof(double)));
  request.length_per_pressure = system.length_per_pressure;
  request.hardness = system.hardness;
  request.least_deflection = system.bounds.least_deflection * system.length_per_pressure;
  request.tol = problem_.options.real(RC_OPT_TOL);
  request.max_iterations = problem_.options.integer(RC_OPT_MAX_ITER);
  request.problem = &problem_;
  request.coefficients = [](const rc_many* many, std::int64_t mx, std::int64_t my, double* out) {
    const System& of = static_cast<const Request*>(many)->problem->system;
    const Host& host = static_cast<const Request*>(many)->problem->host;
    return host.coefficients(&host, &of.unit, of.kernel.name.c_str(), mx, my, out);
  };
  return request;
}

ManyAnswers ManySolve::solved(std::int64_t first, std::int64_t last) const {
  ManyAnswers answers;
  const std::int64_t slots = (last - first) * batch_.steps;
  try {
    answers.all.resize(static_cast<std::size_t>(slots));
    answers.p = large_vector<double>(static_cast<std::size_t>(slots * problem_.system.points()));
  } catch (const std::bad_alloc&) {
    log(first, last, "out of memory");
    return {};
  }
  Request asked = request(first, last - first);
  asked.answers = answers.all.data();
  asked.p = answers.p.data();
  const rc_status status = solver_->solve_many(&problem_.host, &asked, &problem_.options);
  if (status != RC_OK) log(first, last, last_message());
  clear_message();
  if (status == RC_OK) answers.contacts = std::clamp<std::int64_t>(asked.done, 0, last - first);
  return answers;
}

void ManySolve::log(std::int64_t first, std::int64_t last, const char* why) const {
  const std::string text =
      join("solver \"", solver_->name, "\": contacts ", first, " .. ", last - 1, " are solved one at a time: ", why);
  problem_.host.log(&problem_.host, RC_LOG_WARNING, text.c_str());
}

Numbers ManySolve::numbers(const rc_many_answer& answer, std::int64_t i, std::int64_t k) const {
  const double target = values_of<double>(batch_.targets)[i * batch_.target_stride + k];
  const bool by_load = batch_.control == RC_CONTROL_LOAD;
  Numbers numbers;
  numbers.totals.sum = answer.sum;
  numbers.totals.contacts = answer.contacts;
  numbers.approach = by_load ? answer.lowest + answer.compression : target;
  const double control = by_load ? load_imbalance(numbers.load(problem_.system), target) : 0;
  numbers.certificate = {answer.primal, answer.dual, answer.complementarity, control};
  numbers.work.iterations = answer.iterations;
  numbers.work.products = answer.products;
  return numbers;
}

}  // namespace rc
