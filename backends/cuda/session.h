// An engine and a spectrum for one contact: borrowed from what the contacts of a context share, made where there is none.
#pragma once

#include <memory>
#include <roughcontact/plugin.hpp>
#include <string>

#include "common/pool.h"
#include "engine.h"
#include "failure.h"

namespace rc_cuda {

// The options of this plugin.
struct Settings {
  Index index;   // of the device
  double limit;  // of memory [bytes]

  Settings(const rc_host* host, const rc_options* options);
};

using Engines = rc_common::Pool<std::unique_ptr<Engine>>;

// The engines of all contacts of the context on this device. A solve and its coarse grids use the same engine, one after the
// other.
std::shared_ptr<Engines> engines_of(const rc_host* host, const Settings& settings);

// An engine that is taken. It is given back where nothing failed; else the device may be lost, and it goes.
class Borrowed {
 public:
  // team: the threads that copy; null: one thread copies.
  Borrowed(const rc_host* host, const Settings& settings, const rc_team* team = nullptr);
  Borrowed(const Borrowed&) = delete;
  Borrowed& operator=(const Borrowed&) = delete;

  Engine& operator*() const { return *engine_; }
  Engine* operator->() const { return engine_.get(); }
  void give_back() { pool_->give(std::move(engine_)); }

 private:
  std::shared_ptr<Engines> pool_;
  std::unique_ptr<Engine> engine_;
  Current current_;
};

// The spectrum of the system that the host stands for. coefficients(mx, my, out): H at the offsets below mx and my.
template <class Coefficients>
std::shared_ptr<const Spectrum> spectrum_for(const rc_host* host, const Settings& settings, Engine& engine, const Torus& torus,
                                             Index nx, Index ny, const Coefficients& coefficients) {
  // Offsets beyond the grid, or beyond half the torus, belong to no product.
  const Window table{torus.periodic ? nx : std::min(nx, (torus.width + 1) / 2),
                     torus.periodic ? ny : std::min(ny, (torus.height + 1) / 2)};
  const std::string key = std::string(component.name) + " " + std::to_string(settings.index) + " " + std::to_string(torus.width) +
                          " " + std::to_string(torus.height);
  const auto made = [&] {
    return std::make_unique<Spectrum>(engine, torus, table, true, settings.limit,
                                      [&](double* out) { coefficients(table.nx, table.ny, out); });
  };
  // The eigenvalues of a smaller box are not kept: the box changes from step to step.
  const bool whole = torus == (torus.periodic ? periodic_torus(nx, ny) : free_torus(nx, ny));
  return whole ? roughcontact::kept<const Spectrum>(host, component, true, key, made)
               : roughcontact::shared<const Spectrum>(host, component, key, made);
}

}  // namespace rc_cuda
