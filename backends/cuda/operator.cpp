#include "operator.h"

#include <string>

#include "kernels/products.h"

namespace rc_cuda {

Operator::Operator(const rc_host* host, const rc_operator_spec& spec)
    : host_(host), spec_(spec), settings_(host, spec.options), grid_{0, 0, spec.system->nx, spec.system->ny} {
  if (spec.system->op != RC_OPERATOR_HALFSPACE)
    fail(RC_ERR_INCOMPATIBLE, "only half-space grids can be transformed; use another backend");
}

void Operator::bind(const rc_domain& domain) {
  box_ = rc_common::bounding_box(domain, grid_.nx, grid_.ny);
  n_ = domain.n;
  zero_mode_ = domain.zero_mode;
  place_ = rc_common::places_in(box_, domain, grid_.nx);
  if (const Torus wanted = torus(false); of_box_ && !(of_box_->torus() == wanted)) of_box_.reset();
}

Torus Operator::torus(bool whole) const {
  if (periodic()) return periodic_torus(grid_.nx, grid_.ny);
  return whole ? free_torus(grid_.nx, grid_.ny) : free_torus(box_.nx, box_.ny);
}

const Spectrum& Operator::spectrum(Engine& engine, bool whole) {
  const Torus wanted = torus(whole);
  std::shared_ptr<const Spectrum>& own = whole && !(wanted == torus(false)) ? of_grid_ : of_box_;
  if (!own)
    own = spectrum_for(host_, settings_, engine, wanted, grid_.nx, grid_.ny, [&](Index mx, Index my, double* out) {
      roughcontact::check(host_->coefficients(host_, spec_.system, spec_.kernel, mx, my, out));
    });
  return *own;
}

// The box lies at its place in the grid where the product is over the whole grid.
template <class R> void Operator::multiply(const R* x, R* y, bool whole) {
  const Window from{box_.nx, box_.ny, whole ? box_.x : 0, whole ? box_.y : 0};
  const Window to = whole ? Window{grid_.nx, grid_.ny} : from;
  const auto cells = static_cast<std::size_t>(from.nx * from.ny), results = static_cast<std::size_t>(to.nx * to.ny),
             places = place_.size(), n = static_cast<std::size_t>(n_);
  try {
    Borrowed engine(host_, settings_, spec_.team);
    const Spectrum& eigenvalues = spectrum(*engine, whole);
    engine->plan<R>(eigenvalues.torus(), from, to);
    // In the vectors' room: places, x in the box, x of the domain, which is y of the domain later, and y in the box.
    const std::size_t bytes = places * sizeof(Index) + (cells + results + (places > 0 ? n : 0)) * sizeof(R);
    engine->make_room({eigenvalues.torus().bytes<R>(), bytes}, eigenvalues.bytes(), settings_.limit,
                      "a product over " + std::to_string(from.nx) + "x" + std::to_string(from.ny) + " points");
    Device& device = engine->device();
    auto* const place = reinterpret_cast<Index*>(engine->vectors());
    R* const in_box = reinterpret_cast<R*>(place + places);
    R* const result = in_box + cells;
    R* const of_domain = result + results;
    if (places > 0) {
      device.upload(place, place_.data(), places * sizeof(Index));
      device.upload(of_domain, x, n * sizeof(R));
      device.clear(in_box, cells * sizeof(R));
      device.each(n_, Scatter<R>{of_domain, place, in_box});
    } else {
      device.upload(in_box, x, cells * sizeof(R));
    }
    engine->multiply<R>(eigenvalues, from, in_box, to, result, zero_mode_);
    if (places > 0 && !whole) {
      device.each(n_, Gather<R>{result, place, of_domain});
      device.download(y, of_domain, n * sizeof(R));
    } else {
      device.download(y, result, results * sizeof(R));
    }
    engine.give_back();
  } catch (...) {
    of_box_.reset();  // a device that is lost has lost them, too
    of_grid_.reset();
    throw;
  }
}

template void Operator::multiply(const float*, float*, bool);
template void Operator::multiply(const double*, double*, bool);

}  // namespace rc_cuda
