// Loading histories of small contacts, each by one block of threads from its gap to its certificate.
#pragma once

#include <roughcontact/plugin.h>

#include "machine.h"
#include "small/passes.h"
#include "small/place.h"

namespace rc_cuda {

// The data that all contacts have in common. Pointers are to the device's memory; units are the caller's.
struct Common {
  Index nx, ny, contacts, steps;
  bool by_load, warm, periodic;
  rc::HaarTask task;  // what is the same for all
  double tol;         // of the certificate
  double length_per_pressure, hardness, least_deflection, cell_area;
  Index most_iterations;
  const double* gaps;
  Index gap_stride;
  const std::uint8_t* masks;  // null: every point
  Index mask_stride;
  const double* targets;
  Index target_stride;
  const double* starts;  // [contacts][ny][nx] pressures to start from; null: none
  double* pressures;     // [contacts][steps][ny][nx]
  rc_many_answer* answers;
  TreePasses trees;
  InBlock::Product product;  // without its data
  unsigned char *trees_at, *memory;
  std::size_t trees_bytes, bytes;  // of the trees; of each block's memory
  bool single_is_shared;           // data of products in single precision lie in the fastest memory
  unsigned* next;                  // contact that nobody has taken
};

template <class R> class SmallContact {
 public:
  using M = DeviceMachine<R, InBlock>;

  // A block's memory: data of products, the gap, the machine's vectors with the trees.
  static constexpr std::size_t bytes_of(const Common& c) {
    const std::size_t single = c.single_is_shared ? 0 : c.product.single.bytes();
    return rounded(c.product.wide.bytes()) + rounded(single) + rounded(static_cast<std::size_t>(c.nx * c.ny) * sizeof(double)) +
           rounded(M::bytes(c.nx * c.ny, c.trees_bytes));
  }

  constexpr SmallContact(const Common& common, Block& block, Index number, unsigned char* fastest)
      : c_(common), block_(block), n_(common.nx * common.ny), product_(common.product), place_(block, product_) {
    unsigned char* at = c_.memory + static_cast<std::size_t>(number) * c_.bytes;
    product_.wide_data = reinterpret_cast<Complex<double>*>(at);
    at += rounded(product_.wide.bytes());
    product_.single_data = reinterpret_cast<Complex<float>*>(c_.single_is_shared ? fastest : at);
    at += c_.single_is_shared ? 0 : rounded(product_.single.bytes());
    gap_ = reinterpret_cast<double*>(at);
    at += rounded(static_cast<std::size_t>(n_) * sizeof(double));
    m_ = M::place(at, n_, c_.trees_bytes);
    trees_ = moved(block, c_.trees, m_.trees - c_.trees_at);
    block.keep_in_memory(*this);
  }

  // All contacts that no other block takes.
  constexpr void work() {
    for (Index i = 0; (i = block_.take(c_.next)) < c_.contacts;) solve_history(i);
  }

 private:
  struct Write {
    rc_many_answer* to;
    rc_many_answer answer;
    RC_ANYWHERE void operator()(Index) const { *to = answer; }
  };
  struct Poll {
    Index most;
    Index* steps;
    constexpr bool operator()(std::int64_t now, double) const {
      *steps = now;
      return now < most;
    }
  };

  static constexpr double infinite = std::numeric_limits<double>::infinity();

  // An answer that is not solved ends the history.
  RC_CALLED constexpr void solve_history(Index i) {
    const Heights found = block_.template reduce<Heights>(
        n_, TakeGap{c_.gaps + i * c_.gap_stride, c_.masks ? c_.masks + i * c_.mask_stride : nullptr, gap_, m_.state});
    see(found);
    Given start;
    if (c_.starts) start = block_.template reduce<Given>(n_, TakeStart{c_.starts + i * n_, m_.p});
    unit_ = 1;
    bool pressed = start.positive;
    bool solved = found.included > 0 && found.finite && start.finite && std::isfinite(found.highest - found.lowest);
    for (Index k = 0; k < c_.steps; ++k) {
      rc_many_answer answer{};
      if (solved) solve(c_.targets[i * c_.target_stride + k], pressed, answer);
      solved = answer.solved != 0;
      block_.each(1, Write{c_.answers + i * c_.steps + k, answer});
      if (!solved) continue;
      pressed = c_.warm && answer.contacts > 0;
      block_.each(n_, Store{m_.p, unit_, cap_, c_.hardness, c_.pressures + (i * c_.steps + k) * n_});
    }
  }

  RC_CALLED constexpr void see(const Heights& heights) {
    heights_ = heights;
    const Below all = block_.template reduce<Below>(n_, LookBelow{gap_, m_.state, heights.lowest, infinite});
    mean_height_ = all.points > 0 ? all.heights / all.points : 0;
  }

  RC_CALLED constexpr void solve(double target, bool pressed, rc_many_answer& answer) {
    const double depth = target - heights_.lowest, load = target / c_.cell_area;
    if (!std::isfinite(depth) || (c_.by_load && target < 0)) return;
    if (c_.by_load ? target == 0 : depth <= 0) return rest(c_.by_load ? 0 : depth, answer);
    const bool whole = heights_.included == n_, elastic = !(c_.hardness < infinite);
    if (!c_.by_load && c_.periodic && elastic && whole && rc::beyond_mean_plane(depth, mean_height_)) return;
    const double length = c_.by_load ? height_of(load) : depth, unit = length / c_.length_per_pressure;
    if (!(length > 0) || !std::isfinite(length)) return;
    const double cap = c_.hardness / unit;
    block_.each(n_, Penetration<double>{gap_, m_.u, c_.by_load ? heights_.lowest : target, length, c_.nx, c_.nx});
    if (!pressed)
      begin(load / unit, cap);
    else
      block_.each(n_, Convert{m_.p, unit_ / unit, cap});
    unit_ = unit;
    cap_ = cap;

    rc::HaarTask task = c_.task;
    const double scale = c_.by_load ? 0 : scale_of(depth, load);
    task.load = load / unit;
    task.cap = cap;
    if (!c_.by_load) task.tol *= scale / depth;
    if (c_.by_load && c_.periodic) task.least_scale = rc::least_scale_under(task.load, static_cast<double>(heights_.included));
    M machine(place_, n_, cap, m_, trees_);
    block_.keep_in_memory(machine);
    const Poll poll{c_.most_iterations, &answer.iterations};
    rc::HaarIteration iteration(machine, task, poll);
    block_.keep_in_memory(iteration);
    const rc::HaarOutcome outcome = iteration.run(0);
    if (outcome.ending != rc::HaarEnding::solved) return;
    block_.each(n_, Convert{m_.p, 1, cap});
    place_.multiply(static_cast<const double*>(m_.p), m_.spare);
    answer.products = machine.products() + 1;
    const double compression = c_.by_load ? outcome.approach * length : depth;
    certify(target, load, compression, length, c_.by_load ? scale_of(compression, load) : scale, answer);
    if (answer.solved != 0 && !elastic && c_.steps > 1)
      see(block_.template reduce<Heights>(n_, Indent{gap_, m_.p, m_.spare, m_.state, cap, length, compression, heights_.lowest}));
  }

  // Nothing touches.
  constexpr void rest(double compression, rc_many_answer& answer) {
    block_.each(n_, Fill<double>{m_.p, 0});
    unit_ = 1;
    cap_ = infinite;
    answer.solved = 1;
    answer.lowest = heights_.lowest;
    answer.compression = compression;
  }

  constexpr double scale_of(double compression, double load) const {
    const double deflected = c_.least_deflection * (load / static_cast<double>(n_));
    return rc::residual_scale({c_.periodic, c_.by_load, heights_.included == n_, deflected, mean_height_, c_.tol}, compression);
  }

  // The height above the lowest gap of a bed of springs that carries the load, by bisection.
  RC_CALLED constexpr double height_of(double load) {
    const double wanted = load * c_.length_per_pressure;
    const double all = rc::full_bed_height(wanted, static_cast<double>(heights_.included), mean_height_);
    double low = 0, high = heights_.highest - heights_.lowest;
    if (all >= high) return rc::bed_margin * all;
    for (int k = 0; k < 60 && high - low > rc::bed_resolution * high; ++k) {
      const double middle = 0.5 * (low + high);
      const Below below = block_.template reduce<Below>(n_, LookBelow{gap_, m_.state, heights_.lowest, middle});
      (rc::bed_carries(wanted, middle, below.points, below.heights) ? high : low) = middle;
    }
    return rc::bed_margin * high;
  }

  // Without pressures; by load with some that carry it.
  RC_CALLED constexpr void begin(double load, double cap) {
    if (!c_.by_load) return block_.each(n_, Fill<double>{m_.p, 0});
    const Grown all = block_.template reduce<Grown>(n_, Grow{m_.u, m_.p, m_.state});
    const double n = static_cast<double>(heights_.included);
    if (rc::starts_everywhere(all.within, n, all.most, all.sum, load, cap))
      block_.each(n_, Even{m_.p, load / n, m_.state});
    else
      block_.each(n_, Multiply{m_.p, load / all.sum, cap, false});
  }

  // From the product in the spare vector, over all points; contact/proof/certificate.h explains it.
  RC_CALLED constexpr void certify(double target, double load, double compression, double length, double scale,
                                   rc_many_answer& answer) {
    double* const p = m_.u;  // in the caller's unit; u is not needed any more
    block_.each(n_, Store{m_.p, unit_, cap_, c_.hardness, p});
    const Ends ends = block_.template reduce<Ends>(n_, FindEnds{p, m_.state});
    const Violations found = block_.template reduce<Violations>(
        n_, Violate{p, m_.spare, gap_, m_.state, length, compression, heights_.lowest, ends.largest, c_.hardness, scale});
    answer.contacts = ends.contacts;
    answer.sum = ends.sum;
    answer.lowest = heights_.lowest;
    answer.compression = compression;
    answer.primal = rc::primal_violation(ends.least, ends.largest, c_.hardness);
    answer.dual = found.dual;
    answer.complementarity = found.complementarity;
    const double control = c_.by_load ? rc::load_imbalance(ends.sum, load) : 0;
    const bool met = answer.primal <= c_.tol && found.dual <= c_.tol && found.complementarity <= c_.tol && control <= c_.tol;
    answer.solved = met && found.finite && std::isfinite(ends.sum * target) ? 1 : 0;
  }

  const Common& c_;
  Block& block_;
  const Index n_;
  InBlock::Product product_;
  InBlock place_;
  double* gap_ = nullptr;
  typename M::Memory m_{};
  TreePasses trees_{};
  Heights heights_;
  double mean_height_ = 0, unit_ = 1, cap_ = infinite;  // of the pressures at hand
};

// The kernel of Device::blocks.
template <class R> struct SmallContacts {
  Common common;
  RC_ANYWHERE void operator()(Block& block, Index number, unsigned char* fastest) const {
    SmallContact<R>(common, block, number, fastest).work();
  }
};

}  // namespace rc_cuda
