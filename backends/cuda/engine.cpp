#include "engine.h"

#include <algorithm>
#include <type_traits>

#include "kernels/products.h"

namespace rc_cuda {

namespace {

constexpr std::size_t most_plans = 64;  // enough for a grid and its coarse grids

// A room that grows is given back first.
std::size_t more(const Memory& room, std::size_t wanted) { return wanted > room.bytes() ? wanted : 0; }

void grow(Device& device, Memory& room, std::size_t wanted) {
  if (more(room, wanted) == 0) return;
  room = Memory();
  room = Memory(device, wanted);
}

}  // namespace

// Bytes: of all rooms with what is held, to be allocated, and to be given back before that.
struct Engine::Need {
  std::size_t all, fresh = 0, returned = 0;
};

Engine::Need Engine::need(const Rooms& wanted, std::size_t held) const {
  Need need{held};
  for (const auto& [room, bytes] : {std::pair{&torus_, wanted.torus}, {&vectors_, wanted.vectors}, {&work_, work_bytes_}}) {
    need.all += std::max(room->bytes(), bytes);
    if (more(*room, bytes) == 0) continue;
    need.fresh += bytes;
    need.returned += room->bytes();
  }
  return need;
}

bool Engine::has_room(const Rooms& wanted, std::size_t held, double limit) {
  const Need found = need(wanted, held);
  return static_cast<double>(found.all) <= limit && (found.fresh == 0 || found.fresh <= device_.free_bytes() + found.returned);
}

void Engine::make_room(const Rooms& wanted, std::size_t held, double limit, const std::string& what) {
  const auto [all, fresh, returned] = need(wanted, held);
  if (static_cast<double>(all) > limit)
    fail(RC_ERR_MEMORY, what, " needs ", all, " bytes on device ", device_.index(), ", more than the limit ", component.name,
         ".memory_limit of ", limit / 1048576, " MiB; raise it, or use a smaller domain or another backend (\"fft\")");
  if (fresh == 0) return;
  if (const std::size_t there = device_.free_bytes() + returned; fresh > there)
    fail(RC_ERR_MEMORY, what, " needs ", fresh, " bytes more on device ", device_.index(), ", which has ", there,
         "; use a smaller domain or another backend (\"fft\")");
  grow(device_, torus_, wanted.torus);
  grow(device_, vectors_, wanted.vectors);
  grow(device_, work_, work_bytes_);
}

std::size_t Engine::most_for_vectors(std::size_t held, double limit) {
  const double others = static_cast<double>(held + torus_.bytes() + std::max(work_.bytes(), work_bytes_));
  const double there = static_cast<double>(device_.free_bytes() + vectors_.bytes());
  return static_cast<std::size_t>(std::max(0.0, std::min(limit - others, there)));
}

template <> Engine::Plans<float>& Engine::plans<float>() { return single_; }
template <> Engine::Plans<double>& Engine::plans<double>() { return double_; }

template <class R> Lines<R>& Engine::lines(const typename Lines<R>::Shape& shape) {
  Plans<R>& made = plans<R>();
  std::unique_ptr<Lines<R>>& found = made[{shape.length, shape.count, shape.pitch, shape.inverse}];
  if (!found) {
    found = std::make_unique<Lines<R>>(device_, shape);
    work_bytes_ = std::max(work_bytes_, found->work_bytes());
  }
  return *found;
}

template <class R> void Engine::run(const typename Lines<R>::Shape& shape, R* data) {
  lines<R>(shape).run(device_, data, work_.as<void>());
}

template <class R> void Engine::plan(const Torus& torus, const Window& from, const Window& to) {
  if (plans<R>().size() + 4 > most_plans) plans<R>().clear();
  lines<R>({torus.width, from.ny, 0, false});
  lines<R>({torus.width, to.ny, 0, true});
  for (const bool inverse : {false, true}) lines<R>({torus.height, torus.pitch(), torus.pitch(), inverse});
}

template <class R>
void Engine::multiply(const Spectrum& spectrum, const Window& from, const R* x, const Window& to, R* y, double zero_mode) {
  const Torus& torus = spectrum.torus();
  const Index pitch = torus.pitch(), below = from.y + from.ny;
  auto* const complex = torus_.as<Complex<R>>();
  R* const reals = torus_.as<R>();
  R* const rows = reals + 2 * pitch * from.y;
  if (from.y > 0) device_.each(from.y * pitch, Fill<Complex<R>>{complex, {}});
  if (below < torus.height) device_.each((torus.height - below) * pitch, Fill<Complex<R>>{complex + below * pitch, {}});
  device_.each(from.ny * 2 * pitch, Pad<R>{x, rows, from.nx, from.x, pitch});
  run<R>({torus.width, from.ny, 0, false}, rows);
  run<R>({torus.height, pitch, pitch, false}, reals);
  const double points = static_cast<double>(torus.width) * static_cast<double>(torus.height);
  device_.each(torus.height * pitch,
               Times<R>{complex, spectrum.values<R>(), pitch, torus.height, static_cast<R>(zero_mode / points)});
  run<R>({torus.height, pitch, pitch, true}, reals);
  run<R>({torus.width, to.ny, 0, true}, reals);
  device_.each(to.nx * to.ny, Crop<R>{reals, y, to.nx, pitch});
}

void Spectrum::begin(Engine& engine, Index values_at_once, double limit) {
  const Window whole{torus_.width, torus_.height};
  engine.plan<double>(torus_, whole, whole);
  const std::size_t own = torus_.eigenvalues() * (sizeof(float) + sizeof(double));
  engine.make_room({torus_.bytes<double>(), static_cast<std::size_t>(values_at_once) * sizeof(double)}, own, limit,
                   "the eigenvalues of " + std::to_string(torus_.width) + "x" + std::to_string(torus_.height) + " waves");
  engine.device().clear(engine.torus_.as<void>(), torus_.bytes<double>());
}

void Spectrum::add_rows(Engine& engine, const Window& table, Index first, Index rows, const double* values) {
  double* const there = engine.vectors_.as<double>();
  engine.device().upload(there, values, static_cast<std::size_t>(rows * table.nx) * sizeof(double));
  engine.device().each(rows * table.nx,
                       Wrap{there, engine.torus_.as<double>(), table.nx, first, torus_.width, torus_.height, torus_.periodic});
}

void Spectrum::finish(Engine& engine) {
  auto* const reals = engine.torus_.as<double>();
  const auto* const complex = engine.torus_.as<Complex<double>>();
  engine.run<double>({torus_.width, torus_.height, 0, false}, reals);
  engine.run<double>({torus_.height, torus_.pitch(), torus_.pitch(), false}, reals);
  const double by = 1 / (static_cast<double>(torus_.width) * static_cast<double>(torus_.height));
  const auto count = static_cast<Index>(torus_.eigenvalues());
  engine.device().each(count, Keep<float>{complex, single_.as<float>(), by});
  if (in_double()) engine.device().each(count, Keep<double>{complex, double_.as<double>(), by});
  engine.device().wait();
}

template <> const float* Spectrum::values<float>() const { return single_.as<float>(); }
template <> const double* Spectrum::values<double>() const { return double_.as<double>(); }

template void Engine::plan<float>(const Torus&, const Window&, const Window&);
template void Engine::plan<double>(const Torus&, const Window&, const Window&);
template void Engine::multiply(const Spectrum&, const Window&, const float*, const Window&, float*, double);
template void Engine::multiply(const Spectrum&, const Window&, const double*, const Window&, double*, double);

}  // namespace rc_cuda
