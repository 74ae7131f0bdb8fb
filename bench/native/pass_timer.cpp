// Times the passes of haar-cg over all unknowns, for the best vector instructions of this processor.
#include <limits>

#include "common.h"
#include "solvers/haar_cg/threads/pass_loops.h"
#include "trees/tree_loops.h"

namespace {

using namespace bench;

constexpr double no_cap = std::numeric_limits<double>::infinity();

// Points in contact come in rows of 64.
struct Unknowns {
  Unknowns(std::int64_t count, double share)
      : n(count), in(size(n)), runs(size((n + rc::run_points - 1) / rc::run_points), rc::RunState::still) {
    for (std::int64_t i = 0; i < n; ++i) {
      const std::int64_t row = i / 64;
      if (static_cast<double>((row + 1) % 100) >= 100 * share && share < 1) continue;
      const double some = 1e-3 * static_cast<double>(i * 7919 % 101 - 50);
      in[size(i)] = 1;
      p[size(i)] = 1;
      w[size(i)] = z[size(i)] = t[size(i)] = q[size(i)] = static_cast<float>(some);
      runs[size(i / rc::run_points)] = rc::RunState::busy;
      ++busy;
    }
  }
  static std::size_t size(std::int64_t count) { return static_cast<std::size_t>(count); }

  std::int64_t n, busy = 0;
  std::vector<std::uint8_t> in;
  std::vector<rc::RunState> runs;
  std::vector<float> w = std::vector<float>(size(n), 1), z = std::vector<float>(size(n)), t = z, q = z, cut = z;
  std::vector<double> p = std::vector<double>(size(n)), u = std::vector<double>(size(n), 0.5), product = p;
};

}  // namespace

extern "C" {

// seconds, bytes [14]: of the triad a = b + c d, and of the passes in the order of HaarLoops. Bytes that a pass reads or writes:
// everywhere, and where there is contact.
const char* bench_time_passes(std::int64_t n, double share, double budget, double* seconds, double* bytes) {
  return guarded([&] {
    Unknowns of(n, share);
    const auto loops = rc::best_haar_loops<float, double>();
    const double each = 1.0 / rc::run_points, contact = static_cast<double>(of.busy) / static_cast<double>(n);
    int row = 0;
    const auto time = [&](double everywhere, double in_contact, const auto& work) {
      seconds[row] = best_time(budget, work);
      bytes[row++] = static_cast<double>(n) * (everywhere + contact * in_contact);
    };
    const auto measure = [&](double everywhere, double in_contact, auto pass) {
      time(everywhere, in_contact,
           [&] { pass(n, of.w.data(), of.q.data(), of.product.data(), 1e-9, of.u.data(), of.p.data(), no_cap, of.runs.data()); });
    };
    time(12, 0, [&] {
      for (std::int64_t i = 0; i < n; ++i) of.cut.data()[i] = of.z.data()[i] + 3 * of.q.data()[i];
    });
    time(each, 17, [&] { loops.turn(n, of.z.data(), 0.3F, of.t.data(), of.w.data(), of.in.data(), of.runs.data()); });
    time(1, 8, [&] { rc::best_haar_inner<float>()(n, of.z.data(), of.q.data(), of.in.data()); });
    time(12 + each, 20, [&] { loops.advance(n, 1e-9, of.t.data(), of.q.data(), of.p.data(), of.w.data(), of.runs.data()); });
    time(12 + each, 24, [&] {
      loops.advance_and_cut(n, 1e-9, of.t.data(), of.q.data(), of.p.data(), no_cap, of.w.data(), of.cut.data(), of.runs.data());
    });
    time(each, 24, [&] { loops.keep_loads(n, of.p.data(), no_cap, of.cut.data(), of.runs.data()); });
    time(each, 24, [&] { loops.scale(n, 1 + 1e-9, of.p.data(), no_cap, of.cut.data(), true, of.runs.data()); });
    measure(12 + each, 16, loops.add);
    measure(8 + each, 16, loops.lower);
    measure(24, 0, loops.grow);
    measure(28, 0, loops.replace);
    measure(20, 0, loops.begin);
    time(6 + each, 8, [&] { loops.choose(n, of.p.data(), no_cap, of.w.data(), 0.1F, of.in.data(), of.runs.data()); });
    time(16, 0, [&] { loops.compenetrate(n, of.u.data(), 1, 1, of.product.data()); });
  });
}

}  // extern "C"
