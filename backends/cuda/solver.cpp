#include "solver.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "history.h"
#include "machine.h"
#include "names.h"
#include "session.h"
#include "solvers/haar_cg/starts.h"
#include "trees.h"
#include "trees/tree_inputs.h"

namespace rc_cuda {

namespace {

// Whether the caller has the gap there.
bool on_this_device(const rc_grid& grid) {
  return grid.gap_on_device.data && grid.gap_on_device.memory == std::string_view(names::backend);
}

// The unknowns in their bounding box: the cells of the machine.
class Cells {
 public:
  Cells(const rc::Problem& problem) : problem_(problem) {
    const rc_grid& grid = *problem.grid();
    const rc_domain domain{sizeof domain, problem.size(), grid.index, 0};
    box_ = rc_common::bounding_box(domain, grid.nx, grid.ny);
    place_ = rc_common::places_in(box_, domain, grid.nx);
  }

  const rc_common::Box& box() const { return box_; }
  Window window() const { return {box_.nx, box_.ny}; }
  Index count() const { return box_.points(); }

  void upload_state(Device& device, std::uint8_t* to) const {
    if (place_.empty()) return device.each(count(), Fill<std::uint8_t>{to, is_unknown});
    std::vector<std::uint8_t> state(static_cast<std::size_t>(count()), 0);
    for (const Index at : place_) state[static_cast<std::size_t>(at)] = is_unknown;
    device.upload(to, state.data(), state.size());
  }

  // spare: memory of the device for as many doubles.
  void upload_penetration(Device& device, double* to, double* spare) const {
    const rc_grid& grid = *problem_.grid();
    // Cells that are no unknowns may have any value.
    const bool there = !problem_.u() && on_this_device(grid);
    if (there || (!problem_.u() && place_.empty() && count() == grid.nx * grid.ny)) {
      const double length = problem_.length_unit();
      problem_.gap().visit([&](const auto* gap) {
        using Value = std::remove_const_t<std::remove_pointer_t<decltype(gap)>>;
        if (!there) device.upload(spare, gap, static_cast<std::size_t>(count()) * sizeof(Value));
        const auto* const first = static_cast<const Value*>(there ? device.found(grid.gap_on_device.data) : spare);
        device.each(count(), Penetration<Value>{first + box_.y * grid.nx + box_.x, to, grid.approach, length, box_.nx, grid.nx});
      });
      return;
    }
    if (problem_.u() && place_.empty())
      return device.upload(to, problem_.u(), static_cast<std::size_t>(count()) * sizeof(double));
    std::vector<double> u(static_cast<std::size_t>(count()));
    for (Index i = 0; i < problem_.size(); ++i) u[static_cast<std::size_t>(at(i))] = problem_.penetration(i);
    device.upload(to, u.data(), u.size() * sizeof(double));
  }

  void upload_pressures(Device& device, const double* p, double* to) const {
    if (place_.empty()) return device.upload(to, p, static_cast<std::size_t>(count()) * sizeof(double));
    std::vector<double> all(static_cast<std::size_t>(count()));
    for (Index i = 0; i < problem_.size(); ++i) all[static_cast<std::size_t>(at(i))] = p[i];
    device.upload(to, all.data(), all.size() * sizeof(double));
  }

  void download_pressures(Device& device, const double* from, double* p) const {
    if (place_.empty()) return device.download(p, from, static_cast<std::size_t>(count()) * sizeof(double));
    std::vector<double> all(static_cast<std::size_t>(count()));
    device.download(all.data(), from, all.size() * sizeof(double));
    for (Index i = 0; i < problem_.size(); ++i) p[i] = all[static_cast<std::size_t>(at(i))];
  }

 private:
  Index at(Index i) const { return place_.empty() ? i : place_[static_cast<std::size_t>(i)]; }

  const rc::Problem& problem_;
  rc_common::Box box_;
  std::vector<Index> place_;  // of each unknown in the box; empty: in order
};

// Products that the machine made and the core does not know of.
template <class M> class Count {
 public:
  Count(const rc_problem& problem, const M& machine) : problem_(problem), machine_(machine) {}
  ~Count() { tell(); }
  Count(const Count&) = delete;
  Count& operator=(const Count&) = delete;
  void tell() {
    problem_.multiplied(&problem_, machine_.products() - told_);
    told_ = machine_.products();
  }

 private:
  const rc_problem& problem_;
  const M& machine_;
  Index told_ = 0;
};

// from_history: p is as the core gave it.
template <class R>
rc_status iterate(const rc_host* host, const rc_problem& given, const rc_options* options, const rc::Problem& problem,
                  bool from_history, double* p, double& d) {
  const rc_grid& grid = *problem.grid();
  const Settings settings(host, options);
  const auto coefficients = [&](Index mx, Index my, double* out) {
    roughcontact::check(given.coefficients(&given, mx, my, out));
  };
  const rc::TreeInputs inputs = rc::tree_inputs(grid, problem.size(), [&](Index mx, Index my, std::vector<double>& out) {
    out.resize(static_cast<std::size_t>(mx * my));
    coefficients(mx, my, out.data());
  });
  const Cells cells(problem);
  const Window box = cells.window();
  Trees trees(inputs.cells.mx, inputs.cells.my, inputs.table);

  Borrowed engine(host, settings, given.team);
  Device& device = engine->device();
  const Torus torus = grid.boundary == RC_BOUNDARY_PERIODIC ? periodic_torus(grid.nx, grid.ny) : free_torus(box.nx, box.ny);
  const std::shared_ptr<const Spectrum> spectrum = spectrum_for(host, settings, *engine, torus, grid.nx, grid.ny, coefficients);
  using M = DeviceMachine<R, WholeDevice>;
  engine->plan<R>(torus, box, box);
  engine->plan<double>(torus, box, box);
  History history(given, settings.index);
  const Rooms rooms{torus.bytes<double>(), M::bytes(cells.count(), trees.bytes())};
  if (history.bytes() > 0 && !engine->has_room(rooms, spectrum->bytes() + history.bytes(), settings.limit)) history.give_way();
  engine->make_room(rooms, spectrum->bytes() + history.bytes(), settings.limit,
                    "a solve over " + std::to_string(box.nx) + "x" + std::to_string(box.ny) + " points");
  const typename M::Memory memory = M::place(engine->vectors(), cells.count(), trees.bytes());
  trees.place(device, memory.trees);
  cells.upload_state(device, memory.state);
  cells.upload_penetration(device, memory.u, memory.spare);
  const Start start{cells.box(), problem.pressure_unit(), problem.cap(), memory.p};
  if (!from_history || !history.write(device, start)) cells.upload_pressures(device, p, memory.p);

  WholeDevice whole(*engine, *spectrum, box, given.zero_mode);
  M machine(whole, cells.count(), problem.cap(), memory, trees.passes());
  Count count(given, machine);
  const rc::HaarTask task = rc::task_of(problem, inputs);
  const auto poll = [&](std::int64_t steps, double residual) {
    count.tell();
    problem.poll(steps, residual);
    return true;
  };
  rc_status status = RC_OK;
  try {
    const rc::HaarOutcome outcome = rc::HaarIteration(machine, task, poll).run(d);
    if (outcome.ending == rc::HaarEnding::not_finite) fail(RC_ERR_NUMERIC, "the operator returned values that are not finite");
    if (problem.load_control()) d = outcome.approach;
    if (outcome.ending != rc::HaarEnding::solved) status = RC_STOP_STALLED;
  } catch (const roughcontact::Failure& stop) {
    if (stop.code < 0) throw;
    status = stop.code;
  }
  // A stop may come between a step and its cut.
  device.each(cells.count(), Convert{memory.p, 1, problem.cap()});
  if (status == RC_OK) history.keep(device, start, engine->bytes() + spectrum->bytes(), settings.limit);
  cells.download_pressures(device, memory.p, p);
  engine.give_back();
  return status;
}

}  // namespace

rc_status solve(const rc_host* host, const rc_problem* given, const rc_options* options, double* p, double* d) {
  return roughcontact::guard(host, component, [&] {
    const rc::Problem problem(*host, *given, *options);
    const std::span<double> pressures(p, static_cast<std::size_t>(given->n));
    const char* const coarse_solver = problem.option_int("haar-cg.nested") != 0 ? names::solver : nullptr;
    const bool warm = rc::serves(problem, coarse_solver, pressures);
    if (!warm) rc::start_haar_cg(problem, {coarse_solver, true}, pressures, *d);
    const bool mixed = problem.option_text("haar-cg.products") == "mixed";
    const auto iterate_in = mixed ? iterate<float> : iterate<double>;
    rc_status status = iterate_in(host, *given, options, problem, warm, p, *d);
    if (status == RC_STOP_STALLED && !problem.load_control() && problem.has_subset()) {
      problem.note(std::string(names::solver) + " stalled; nnls completed the step");
      status = problem.by_nnls(p);
    }
    roughcontact::check(status);
  });
}

}  // namespace rc_cuda
