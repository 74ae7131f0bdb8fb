#include "small/many.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "names.h"
#include "session.h"
#include "small/contact.h"
#include "small/spectrum.h"
#include "trees.h"
#include "trees/tree_inputs.h"

namespace rc_cuda {

namespace {

// The arrays of a call on the device. Without memory `bytes` alone has a meaning.
class Arrays {
 public:
  Arrays(const rc_many& many, Index contacts, unsigned char* memory) {
    const Index points = many.grid->nx * many.grid->ny;
    const auto of_all = [&](Index stride) { return static_cast<std::size_t>(stride == 0 ? points : contacts * points); };
    const auto slots = static_cast<std::size_t>(contacts * many.steps);
    Layout layout(memory);
    gaps = layout.next<double>(of_all(many.undeformed_gap_stride));
    if (many.mask) masks = layout.next<std::uint8_t>(of_all(many.mask_stride));
    targets = layout.next<double>(many.target_stride == 0 ? static_cast<std::size_t>(many.steps) : slots);
    if (many.p0) starts = layout.next<double>(static_cast<std::size_t>(contacts * points));
    pressures = layout.next<double>(slots * static_cast<std::size_t>(points));
    answers = layout.next<rc_many_answer>(slots);
    taken = layout.next<unsigned>(1);
    bytes = layout.used();
  }

  double *gaps, *targets, *starts = nullptr, *pressures;
  std::uint8_t* masks = nullptr;
  rc_many_answer* answers;
  unsigned* taken;
  std::size_t bytes;
};

// contacts rows of `count` values, `stride` apart; 0: one for all.
template <class T> void upload_rows(Device& device, T* to, const T* from, Index stride, Index count, Index contacts) {
  const bool dense = stride == 0 || stride == count;
  const Index rows = stride == 0 ? 1 : contacts, pieces = dense ? 1 : rows, of_piece = dense ? rows * count : count;
  for (Index k = 0; k < pieces; ++k)
    device.upload(to + k * of_piece, from + k * stride, static_cast<std::size_t>(of_piece) * sizeof(T));
}

template <class R> void solve(const rc_host* host, rc_many& many, const rc_options* options) {
  const rc_grid& grid = *many.grid;
  const Index points = grid.nx * grid.ny;
  const bool periodic = grid.boundary == RC_BOUNDARY_PERIODIC;
  const Settings settings(host, options);
  const auto coefficients = [&](Index mx, Index my, std::vector<double>& out) {
    out.resize(static_cast<std::size_t>(mx * my));
    roughcontact::check(many.coefficients(&many, mx, my, out.data()));
  };
  const rc::TreeInputs inputs = rc::tree_inputs(grid, points, coefficients);
  Trees trees(inputs.cells.mx, inputs.cells.my, inputs.table);

  Borrowed engine(host, settings);
  Device& device = engine->device();
  const std::string key = std::string(component.name) + " small " + std::to_string(settings.index);
  const std::shared_ptr<const SmallSpectrum> spectrum = roughcontact::kept<const SmallSpectrum>(host, component, true, key, [&] {
    std::vector<double> table;
    coefficients(grid.nx, grid.ny, table);
    return std::make_unique<SmallSpectrum>(device, grid.nx, grid.ny, periodic, table);
  });

  Common common{};
  common.nx = grid.nx;
  common.ny = grid.ny;
  common.steps = many.steps;
  common.by_load = many.control == RC_CONTROL_LOAD;
  common.warm = many.warm_start != 0;
  common.periodic = periodic;
  common.task.by_load = common.by_load;
  common.task.tol = 0.49 * many.tol;  // the library makes a product for each answer with a residual above half of tol
  common.task.periodic_mean = inputs.table.mean;
  common.task.elongated = inputs.elongated;
  common.task.patience = static_cast<int>(roughcontact::option_int(host, options, "haar-cg.patience"));
  common.tol = many.tol;
  common.length_per_pressure = many.length_per_pressure;
  common.hardness = many.hardness;
  common.least_deflection = many.least_deflection;
  common.cell_area = grid.hx * grid.hy;
  common.most_iterations = many.max_iterations;
  common.product = {spectrum->torus<float>(), spectrum->torus<double>(), nullptr, nullptr};
  common.trees_bytes = trees.bytes();
  const std::size_t single = common.product.single.bytes();
  common.single_is_shared = sizeof(R) == sizeof(float) && single <= device.most_shared();
  const std::size_t shared = common.single_is_shared ? single : 0;
  common.bytes = SmallContact<R>::bytes_of(common);

  // As many contacts as fit, and as many blocks as there is work for.
  using Work = SmallContacts<R>;
  const Index at_a_time = device.blocks_at_a_time<Work>(shared);
  const auto needed = [&](Index contacts) {
    return Arrays(many, contacts, nullptr).bytes + rounded(trees.bytes()) +
           static_cast<std::size_t>(std::min(at_a_time, contacts)) * common.bytes;
  };
  const std::size_t there = engine->most_for_vectors(spectrum->bytes() + device.bytes_of_stacks<Work>(), settings.limit);
  Index fits = many.n;
  while (fits > 1 && needed(fits) > there) fits = fits / 2;
  common.contacts = fits;
  const Index blocks = std::min(at_a_time, fits);
  engine->make_room({0, needed(fits)}, spectrum->bytes(), settings.limit,
                    "a contact of " + std::to_string(grid.nx) + "x" + std::to_string(grid.ny) + " points among many");

  const Arrays on_device(many, fits, engine->vectors());
  common.trees_at = engine->vectors() + on_device.bytes;
  common.memory = common.trees_at + rounded(trees.bytes());
  trees.place(device, common.trees_at);
  common.trees = trees.passes(true);
  common.gaps = on_device.gaps;
  common.gap_stride = many.undeformed_gap_stride == 0 ? 0 : points;
  common.masks = on_device.masks;
  common.mask_stride = many.mask_stride == 0 ? 0 : points;
  common.targets = on_device.targets;
  common.target_stride = many.target_stride == 0 ? 0 : many.steps;
  common.pressures = on_device.pressures;
  common.starts = on_device.starts;
  common.answers = on_device.answers;
  common.next = on_device.taken;
  upload_rows(device, on_device.gaps, many.undeformed_gap, many.undeformed_gap_stride, points, fits);
  if (many.mask) upload_rows(device, on_device.masks, many.mask, many.mask_stride, points, fits);
  upload_rows(device, on_device.targets, many.targets, many.target_stride, many.steps, fits);
  if (many.p0) upload_rows(device, on_device.starts, many.p0, points, points, fits);
  device.clear(common.next, sizeof *common.next);
  device.blocks(blocks, shared, Work{common});

  const auto slots = static_cast<std::size_t>(fits * many.steps);
  device.download(many.answers, on_device.answers, slots * sizeof(rc_many_answer));
  device.download(many.p, on_device.pressures, slots * static_cast<std::size_t>(points) * sizeof(double));
  many.done = fits;
  engine.give_back();
}

}  // namespace

rc_status solve_many(const rc_host* host, rc_many* many, const rc_options* options) {
  return roughcontact::guard(host, component, [&] {
    const rc_grid& grid = *many->grid;
    if (grid.nx > most_points_of_many / grid.ny || !SmallSpectrum::suits(grid.nx, grid.ny, grid.boundary == RC_BOUNDARY_PERIODIC))
      fail(RC_ERR_INCOMPATIBLE, grid.nx, "x", grid.ny, " points are too many, or no transform of many at once has such sides");
    if (many->backend != std::string_view(names::backend))
      fail(RC_ERR_INCOMPATIBLE, "certificates of many at once are by \"", names::backend, "\", not by \"", many->backend, "\"");
    if (many->n == 0) return;
    const bool mixed = roughcontact::option_text(host, options, "haar-cg.products") == std::string_view("mixed");
    mixed ? solve<float>(host, *many, options) : solve<double>(host, *many, options);
  });
}

}  // namespace rc_cuda
