// An engine: device, memory that grows and plans of transforms for one solve or product at a time. Contacts lend engines to each
// other.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "lengths.h"
#include "runtime/memory.h"

namespace rc_cuda {

class Spectrum;

// Bytes of the memory that the engine holds.
struct Rooms {
  std::size_t torus = 0, vectors = 0;
};

// Columns and rows of a box that begins at a place of the torus.
struct Window {
  Index nx, ny;
  Index x = 0, y = 0;
};

class Engine {
 public:
  Engine(const rc_host* host, Index index) : device_(host, index) {}

  Device& device() { return device_; }

  // Makes the rooms at least so large. Fails before anything is allocated where that and `held` are beyond the limit [bytes], or
  // the device has less. what: for whom, as in "a solve of 32 x 32 points".
  void make_room(const Rooms& wanted, std::size_t held, double limit, const std::string& what);
  // Whether make_room() would do so.
  bool has_room(const Rooms& wanted, std::size_t held, double limit);
  // The most bytes for which make_room() makes the vectors' room, nothing of the others being wanted.
  std::size_t most_for_vectors(std::size_t held, double limit);
  std::size_t bytes() const { return torus_.bytes() + vectors_.bytes() + work_.bytes(); }  // of the rooms
  unsigned char* vectors() const { return vectors_.as<unsigned char>(); }

  // The plans for products between these windows; the work area that they need is part of what make_room() makes.
  template <class R> void plan(const Torus& torus, const Window& from, const Window& to);
  // y = H x, from one window to the other, which begins at the torus' first place; zero_mode: eigenvalue of H for the constant
  // vector. After plan() and make_room().
  template <class R>
  void multiply(const Spectrum& spectrum, const Window& from, const R* x, const Window& to, R* y, double zero_mode);

 private:
  friend class Spectrum;
  struct Need;
  Need need(const Rooms& wanted, std::size_t held) const;

  template <class R> using Plans = std::map<std::tuple<Index, Index, Index, bool>, std::unique_ptr<Lines<R>>>;
  template <class R> Plans<R>& plans();
  template <class R> Lines<R>& lines(const typename Lines<R>::Shape& shape);
  template <class R> void run(const typename Lines<R>::Shape& shape, R* data);

  Device device_;
  Plans<float> single_;
  Plans<double> double_;
  std::size_t work_bytes_ = 256;  // that the plans need; never 0: cuFFT then always gets an address
  Memory torus_, vectors_, work_;
};

// The eigenvalues of H on a torus, on the device. Read by several engines of one device.
class Spectrum {
 public:
  // coefficients(first row, rows, out): rows of the table of H at non-negative offsets, nx values wide.
  template <class Coefficients>
  Spectrum(Engine& engine, const Torus& torus, const Window& table, bool in_double, double limit,
           const Coefficients& coefficients);
  Spectrum(const Spectrum&) = delete;

  const Torus& torus() const { return torus_; }
  std::size_t bytes() const { return single_.bytes() + double_.bytes(); }
  template <class R> const R* values() const;
  bool in_double() const { return double_.bytes() > 0; }

 private:
  void begin(Engine& engine, Index values_at_once, double limit);
  void add_rows(Engine& engine, const Window& table, Index first, Index rows, const double* values);
  void finish(Engine& engine);

  Torus torus_;
  Memory single_, double_;
};

// Passes and products as launches, between the points of a box.
class WholeDevice {
 public:
  // After plan() and make_room(). zero_mode: eigenvalue of H for the constant vector.
  WholeDevice(Engine& engine, const Spectrum& spectrum, const Window& box, double zero_mode)
      : engine_(engine), device_(engine.device()), spectrum_(spectrum), box_(box), zero_mode_(zero_mode) {}

  template <class F> void each(Index n, const F& f) { device_.each(n, f); }
  template <class Part, class F> Part reduce(Index n, const F& f) { return device_.reduce<Part>(n, f); }
  template <class Work> void together(const Work& work) { device_.together(work); }
  template <class T> void clear(T* x, Index n) { device_.clear(x, static_cast<std::size_t>(n) * sizeof(T)); }
  template <class R> void multiply(const R* x, R* y) { engine_.multiply(spectrum_, box_, x, box_, y, zero_mode_); }

 private:
  Engine& engine_;
  Device& device_;
  const Spectrum& spectrum_;
  const Window box_;
  const double zero_mode_;
};

constexpr Index coefficients_at_once = Index{1} << 24;

template <class Coefficients>
Spectrum::Spectrum(Engine& engine, const Torus& torus, const Window& table, bool in_double, double limit,
                   const Coefficients& coefficients)
    : torus_(torus) {
  std::vector<double> values(static_cast<std::size_t>(table.nx * table.ny));
  coefficients(values.data());
  const Index at_once = std::min(table.ny, std::max<Index>(1, coefficients_at_once / table.nx));  // rows
  begin(engine, at_once * table.nx, limit);
  single_ = Memory(engine.device(), torus.eigenvalues() * sizeof(float));
  if (in_double) double_ = Memory(engine.device(), torus.eigenvalues() * sizeof(double));
  for (Index first = 0; first < table.ny; first += at_once)
    add_rows(engine, table, first, std::min(at_once, table.ny - first), values.data() + first * table.nx);
  finish(engine);
}

}  // namespace rc_cuda
