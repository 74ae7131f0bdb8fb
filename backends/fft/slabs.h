// H of a half-space grid whose rows are shared by processes. Each transforms its rows, and the columns of its waves along x; in
// between and after it the waves are transposed between the processes. Two rows that follow each other make one complex sequence,
// and every process begins with an even row, so that no bit depends on who has which rows.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <roughcontact/plugin.hpp>
#include <vector>

#include "buffer.h"
#include "failure.h"
#include "fourier.h"
#include "lengths.h"

namespace rc_fft {

// Which waves along x a process has, in strips of so many.
inline constexpr std::int64_t strip = row_size<double>;

struct Strips {
  Strips(std::int64_t waves, std::int64_t processes) : count((waves + strip - 1) / strip), ranks(processes) {}
  std::int64_t first(std::int64_t rank) const { return rank * count / ranks; }

  // The process with the first of them.
  std::int64_t owner_of_first() const { return (ranks - 1) / count; }

  std::int64_t count, ranks;
};

// Waves along x in the order in which processes have them: that of their ranks, but wave length/2, which is real as wave 0 is, is
// the imaginary part of that one, and the last of the others has its place. So powers of two are shared evenly.
struct SharedWaves {
  static std::int64_t count_of(std::int64_t length) { return (length + 1) / 2; }
  template <class Real>
  explicit SharedWaves(const Fourier<Real>& along)
      : count(count_of(along.length())), half(along.length() % 2 == 0 ? along.rank(along.length() / 2) : -1) {}
  std::int64_t rank(std::int64_t place) const { return place == half ? count : place; }

  std::int64_t count, half;  // half: the rank of wave length/2; -1: none
};

// The working memory of products in either precision: one product runs at a time.
struct SlabRoom {
  // The spectra of this process's rows, [transposition][process][group of lines][block of that process][line], its own last.
  Buffer spectra;
  Buffer columns;  // of this process's blocks in one transposition, of the other processes: [process][group][block][line]
  Buffer scratch;  // [thread]: of the passes, and the waves of a group that is not whole
};

template <class Real> class SlabTransform {
 public:
  SlabTransform(const rc_operator_spec& spec, Lengths lengths, const Strips& strips, SlabRoom& room);

  Lengths lengths() const { return lengths_; }
  const Fourier<Real>& along_y() const { return *axes_.y; }
  // The eigenvalue / (2 x y lengths) of the wave along x of this rank among this process's, and along y of that rank.
  Real& eigenvalue(std::int64_t rank_x, std::int64_t rank_y) {
    return eigenvalues_.data<Real>()[(rank_x / width<Real> * axes_.y->waves() + rank_y) * width<Real> + rank_x % width<Real>];
  }
  // Whether this process has the waves 0 and length/2 along x; of the latter, along y of that rank.
  bool has_half() const { return waves_.half >= 0 && rows_.rank == strips_.owner_of_first(); }
  Real& half_eigenvalue(std::int64_t rank_y) { return half_[static_cast<std::size_t>(rank_y)]; }
  // Between this process's rows.
  void multiply(const Real* x, Real* y);

 private:
  static constexpr std::int64_t parts = strip / width<Real>;  // blocks in a strip
  static constexpr std::int64_t tile = most_lines<Real> * row_size<Real>;
  // The blocks of a process that one transposition carries.
  struct Range {
    std::int64_t first, count;
  };
  class ColumnSource;
  class ColumnSink;

  std::int64_t first_row(std::int64_t rank) const { return rows_.first[rank]; }
  std::int64_t count_rows(std::int64_t rank) const { return first_row(rank + 1) - first_row(rank); }
  Range blocks(std::int64_t rank, std::int64_t round) const;
  // The spectra of a range of blocks.
  Real* spectra(Range range) const {
    return room_.spectra.template data<Real>() + place_[static_cast<std::size_t>(range.first)] * own_rows_ * row_size<Real>;
  }
  // Where in a range of so many blocks the row of a process with so many rows lies.
  static std::int64_t place_of(std::int64_t row, std::int64_t rows, std::int64_t blocks, std::int64_t block);
  Real* scratch(std::int64_t thread) const { return room_.scratch.template data<Real>() + thread * (passes_size_ + tiles_size_); }
  void rows_forward(const Real* x);
  void rows_backward(Real* y);
  void put_half(const Real* scratch, Real* tiles) const;
  void take_half(const Real* tiles, Real* scratch) const;
  void multiply_first(ColumnSource& source, Real* scratch, ColumnSink& sink);
  void columns(std::int64_t round);
  const Mirrored* order(Range range) const { return order_.data() + range.first * width<Real>; }
  std::int64_t waves_in(Range range) const {
    return std::min(waves_.count - range.first * width<Real>, range.count * width<Real>);
  }
  template <class Act> void each_range(const Act& act) const;
  template <class Copy> void each_line(std::int64_t group, Real* tiles, const Copy& copy) const;

  const rc_rows& rows_;
  const rc_team& team_;
  SlabRoom& room_;
  Lengths lengths_;
  Axes<Real> axes_;
  Strips strips_;
  std::int64_t nx_, ny_, own_rows_;
  SharedWaves waves_;
  std::int64_t all_blocks_;
  std::int64_t rounds_ = 1, round_strips_;  // transpositions carry so many strips of each process
  std::int64_t passes_size_, tiles_size_;   // of a thread's scratch [reals]; no tiles where all groups are whole
  bool parallel_;
  std::vector<std::int32_t> owner_;            // of each row
  std::vector<std::int64_t> place_;            // of each block: those of a transposition follow each other, this process's last
  std::vector<std::int64_t> round_begin_;      // of each transposition
  std::vector<std::int64_t> sent_, received_;  // bytes, by process
  std::vector<Mirrored> order_;                // rows of the scratch along x, in the order of the shared waves
  std::vector<Real> half_;                     // eigenvalues of wave length/2 along x, where this process has it
  Buffer eigenvalues_;                         // [own block][wave along y][wave of the block]
};

class Slabs {
 public:
  // All processes make one at the same time.
  Slabs(const rc_host* host, const rc_operator_spec& spec);

  std::int64_t points() const { return points_; }  // of the grid
  void apply(const double* x, double* y) { double_->multiply(x, y); }
  void apply(const float* x, float* y) { single_->multiply(x, y); }

 private:
  void load_free(const rc_host* host, const rc_operator_spec& spec, const Strips& strips);
  void load_periodic(const rc_host* host, const rc_operator_spec& spec, const Strips& strips);

  std::int64_t points_;
  SlabRoom room_;
  std::unique_ptr<SlabTransform<double>> double_;
  std::unique_ptr<SlabTransform<float>> single_;
};

}  // namespace rc_fft
