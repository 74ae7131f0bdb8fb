#include "slabs.h"

#include <algorithm>
#include <complex>
#include <cstring>
#include <utility>

#include "lines.h"

namespace rc_fft {

namespace {

// The bytes of a process's spectra that one transposition carries, about: more bytes need more room at the receiver, fewer make
// messages to single processes small.
constexpr double most_round_bytes = 8 << 20, message_bytes = 1 << 19;
constexpr std::int64_t most_rounds = 16;

// The place of a line in its tile: of rows 2 k and 2 k + 1 of a group one is the real parts of a sequence, the other its
// imaginary parts.
template <class Real> std::int64_t in_tile(std::int64_t line) { return line % 2 * width<Real> + line / 2; }

}  // namespace

// Rows of a block of columns: this process's own where they are, the others' as they came, one process after the other.
template <class Real> class SlabTransform<Real>::ColumnSource : public Source<Real> {
 public:
  ColumnSource(const SlabTransform& of, Range range, std::int64_t block)
      : Source<Real>(of.ny_), of_(of), own_(of.spectra(range)), blocks_(range.count), block_(block) {}

  Real* row(std::int64_t i) const {
    const std::int64_t rank = of_.owner_[static_cast<std::size_t>(i)], first = of_.first_row(rank), count = of_.count_rows(rank);
    const std::int64_t at = place_of(i - first, count, blocks_, block_);
    if (rank == of_.rows_.rank) return own_ + at * row_size<Real>;
    const std::int64_t before = rank < of_.rows_.rank ? first : first - of_.own_rows_;
    return of_.room_.columns.template data<Real>() + (blocks_ * before + at) * row_size<Real>;
  }
  void read(int, std::int64_t first, std::int64_t count, const Real** rows) override {
    for (std::int64_t i = first; i < first + count; ++i) rows[i - first] = i < this->end() ? row(i) : zero_row<Real>;
  }

 private:
  const SlabTransform& of_;
  Real* own_;
  std::int64_t blocks_, block_;
};

template <class Real> class SlabTransform<Real>::ColumnSink : public Sink<Real> {
 public:
  ColumnSink(const ColumnSource& column, Real* spare) : Sink<Real>(column.end()), column_(column), spare_(spare) {}

  void room(int, std::int64_t first, std::int64_t count, Real** rows) override {
    for (std::int64_t i = first; i < first + count; ++i) rows[i - first] = i < this->end() ? column_.row(i) : spare_;
  }

 private:
  const ColumnSource& column_;
  Real* spare_;
};

template <class Real>
SlabTransform<Real>::SlabTransform(const rc_operator_spec& spec, Lengths lengths, const Strips& strips, SlabRoom& room)
    : rows_(*spec.rows),
      team_(*spec.team),
      room_(room),
      lengths_(lengths),
      axes_(lengths),
      strips_(strips),
      nx_(spec.system->nx),
      ny_(spec.system->ny),
      own_rows_(count_rows(rows_.rank)),
      waves_(*axes_.x),
      all_blocks_((waves_.count + width<Real> - 1) / width<Real>),
      passes_size_(std::max(Fourier<Real>::scratch_rows(lengths.x), Fourier<Real>::scratch_rows(lengths.y)) * row_size<Real>),
      tiles_size_(own_rows_ % most_lines<Real> == 0 ? 0 : all_blocks_ * tile),
      parallel_(worth_sharing(lengths)) {
  const double bytes = static_cast<double>(all_blocks_) * static_cast<double>(ny_ * row_size<Real>) * sizeof(Real) /
                       static_cast<double>(rows_.ranks);
  const std::int64_t most_strips = (strips.count + rows_.ranks - 1) / rows_.ranks;
  const double round_bytes = std::min(most_round_bytes, message_bytes * static_cast<double>(rows_.ranks));
  if (rows_.ranks > 1)
    rounds_ = std::clamp<std::int64_t>(static_cast<std::int64_t>(bytes / round_bytes), 1, std::min(most_strips, most_rounds));
  round_strips_ = (most_strips + rounds_ - 1) / rounds_;
  for (std::int64_t rank = 0; rank < rows_.ranks; ++rank)
    owner_.insert(owner_.end(), static_cast<std::size_t>(count_rows(rank)), static_cast<std::int32_t>(rank));
  place_.resize(static_cast<std::size_t>(all_blocks_));
  for (std::int64_t place = 0; place < all_blocks_ * width<Real>; ++place)
    order_.push_back(axes_.x->rows()[place < waves_.count ? waves_.rank(place) : 0]);
  std::int64_t next = 0, received = 0;
  for (std::int64_t round = 0; round < rounds_; ++round) {
    const auto put = [&](std::int64_t rank) {
      const Range range = blocks(rank, round);
      for (std::int64_t block = 0; block < range.count; ++block) place_[static_cast<std::size_t>(range.first + block)] = next++;
    };
    round_begin_.push_back(next);
    for (std::int64_t rank = 0; rank < rows_.ranks; ++rank)
      if (rank != rows_.rank) put(rank);
    put(rows_.rank);
    received = std::max(received, blocks(rows_.rank, round).count * (ny_ - own_rows_));
  }
  sent_.resize(static_cast<std::size_t>(rows_.ranks));
  received_.resize(sent_.size());
  const std::int64_t first = strips.first(rows_.rank), last = strips.first(rows_.rank + 1);
  const auto at_least_one = [](std::int64_t n) { return std::max<std::int64_t>(n, 1); };
  eigenvalues_.reserve<Real>(at_least_one((last - first) * strip), axes_.y->waves(), lengths);
  if (has_half()) half_.resize(static_cast<std::size_t>(axes_.y->waves()));
  room_.spectra.template reserve<Real>(at_least_one(own_rows_), all_blocks_ * row_size<Real>, lengths);
  room_.columns.template reserve<Real>(at_least_one(received), row_size<Real>, lengths);
  room_.scratch.template reserve<Real>(team_.threads, passes_size_ + tiles_size_, lengths);
}

template <class Real>
typename SlabTransform<Real>::Range SlabTransform<Real>::blocks(std::int64_t rank, std::int64_t round) const {
  const std::int64_t end = strips_.first(rank + 1), first = std::min(strips_.first(rank) + round * round_strips_, end);
  const std::int64_t last = std::min(first + round_strips_, end);
  const std::int64_t begin = std::min(first * parts, all_blocks_);
  return {begin, std::min(last * parts, all_blocks_) - begin};
}

// A whole group has the order of its tiles, so that its waves are written where they are sent from.
template <class Real>
std::int64_t SlabTransform<Real>::place_of(std::int64_t row, std::int64_t rows, std::int64_t blocks, std::int64_t block) {
  const std::int64_t line = row % most_lines<Real>, group = row - line, lines = std::min(most_lines<Real>, rows - group);
  return group * blocks + block * lines + (lines == most_lines<Real> ? in_tile<Real>(line) : line);
}

template <class Real> template <class Act> void SlabTransform<Real>::each_range(const Act& act) const {
  for (std::int64_t round = 0; round < rounds_; ++round)
    for (std::int64_t rank = 0; rank < rows_.ranks; ++rank)
      if (const Range range = blocks(rank, round); range.count > 0) act(range);
}

// copy(a line of a group's tiles, its place in the spectra), for a group that is not whole.
template <class Real>
template <class Copy>
void SlabTransform<Real>::each_line(std::int64_t group, Real* tiles, const Copy& copy) const {
  const std::int64_t first = group * most_lines<Real>;
  each_range([&](Range range) {
    for (std::int64_t block = 0; block < range.count; ++block)
      for (std::int64_t row = first; row < own_rows_; ++row)
        copy(tiles + (range.first + block) * tile + in_tile<Real>(row - first) * row_size<Real>,
             spectra(range) + place_of(row, own_rows_, range.count, block) * row_size<Real>);
  });
}

// Moves the wave length/2 of each line, which is real, into the imaginary part of wave 0. tiles: the first block of waves.
template <class Real> void SlabTransform<Real>::put_half(const Real* scratch, Real* tiles) const {
  if (waves_.half < 0) return;
  const Real* const wave = scratch + axes_.x->rows()[waves_.half].row * row_size<Real>;
  for (std::int64_t line = 0; line < most_lines<Real>; ++line) tiles[line * row_size<Real> + width<Real>] = 2 * wave[line];
}

template <class Real> void SlabTransform<Real>::take_half(const Real* tiles, Real* scratch) const {
  if (waves_.half < 0) return;
  Real *const zero = scratch + order_.front().row * row_size<Real>, *const wave = scratch + axes_.x->rows()[waves_.half].row *
                                                                                                row_size<Real>;
  for (std::int64_t line = 0; line < most_lines<Real>; ++line) {
    zero[line] = tiles[line * row_size<Real>];
    wave[line] = tiles[line * row_size<Real> + width<Real>];
  }
}

template <class Real> void SlabTransform<Real>::rows_forward(const Real* x) {
  constexpr std::int64_t count = most_lines<Real>;
  const Fourier<Real>& along = *axes_.x;
  roughcontact::for_each(team_, (own_rows_ + count - 1) / count, parallel_, [&](std::int64_t group, std::int64_t thread) {
    const Real* given[count] = {};
    bool zero = true;
    for (std::int64_t i = 0; i < std::min(count, own_rows_ - group * count); ++i) {
      const Real* const row = x + (group * count + i) * nx_;
      if (std::all_of(row, row + nx_, [](Real value) { return value == 0; })) continue;
      zero = false;
      given[in_tile<Real>(i)] = row;
    }
    const std::int64_t before = group * count, lines = std::min(count, own_rows_ - before);
    if (zero) {
      each_range([&](Range range) {
        std::fill_n(spectra(range) + before * range.count * row_size<Real>, lines * range.count * row_size<Real>, Real{0});
      });
      return;
    }
    LineSource<Real> source(along.passes(), given, nx_);
    along.forward(source, scratch(thread));
    if (lines == count) {
      each_range([&](Range range) {
        Real* const to = spectra(range) + before * range.count * row_size<Real>;
        along.passes().to_spectra(scratch(thread), order(range), waves_in(range), to);
        if (range.first == 0) put_half(scratch(thread), to);
      });
      return;
    }
    Real* const tiles = scratch(thread) + passes_size_;
    along.passes().to_spectra(scratch(thread), order_.data(), waves_.count, tiles);
    put_half(scratch(thread), tiles);
    each_line(group, tiles, [](const Real* from, Real* to) { std::copy_n(from, row_size<Real>, to); });
  });
}

template <class Real> void SlabTransform<Real>::rows_backward(Real* y) {
  constexpr std::int64_t count = most_lines<Real>;
  const Fourier<Real>& along = *axes_.x;
  roughcontact::for_each(team_, (own_rows_ + count - 1) / count, parallel_, [&](std::int64_t group, std::int64_t thread) {
    const std::int64_t lines = std::min(count, own_rows_ - group * count);
    Real* wanted[count] = {};
    for (std::int64_t i = 0; i < lines; ++i) wanted[in_tile<Real>(i)] = y + (group * count + i) * nx_;
    if (lines == count) {
      each_range([&](Range range) {
        const Real* const from = spectra(range) + group * count * range.count * row_size<Real>;
        along.passes().from_spectra(from, count, order(range), waves_in(range), scratch(thread));
        if (range.first == 0) take_half(from, scratch(thread));
      });
    } else {
      Real* const tiles = scratch(thread) + passes_size_;
      each_line(group, tiles, [](Real* to, const Real* from) { std::copy_n(from, row_size<Real>, to); });
      // All lines are asked for: a line that is not wanted has no neighbour in its sequence, whose waves are then 0.
      for (std::int64_t i = lines; i < count; ++i)
        for (std::int64_t block = 0; block < all_blocks_; ++block)
          std::fill_n(tiles + block * tile + in_tile<Real>(i) * row_size<Real>, row_size<Real>, Real{0});
      along.passes().from_spectra(tiles, count, order_.data(), waves_.count, scratch(thread));
      take_half(tiles, scratch(thread));
    }
    LineSink<Real> sink(along.passes(), wanted, nx_);
    along.backward(scratch(thread), sink);
  });
}

// The first block, in whose first column the wave 0 along x is the real part x, and the wave length/2 the imaginary part y. With
// the waves u of x + iy along the column, and * for the conjugate complex, those of x are (u[k] + u*[-k]) / 2, those of iy (u[k]
// - u*[-k]) / 2.
template <class Real> void SlabTransform<Real>::multiply_first(ColumnSource& source, Real* scratch, ColumnSink& sink) {
  const Fourier<Real>& along = *axes_.y;
  along.forward(source, scratch);
  for (std::int64_t rank = 0; rank < along.waves(); ++rank) {
    const Real* const by = &eigenvalue(0, rank);
    Real *const one = scratch + along.rows()[rank].row * row_size<Real>, *const other =
                                                                             scratch + along.rows()[rank].mirror * row_size<Real>;
    const Real of_half = half_[static_cast<std::size_t>(rank)], even = (by[0] + of_half) / 2, odd = (by[0] - of_half) / 2;
    const std::complex<Real> u(one[0], one[width<Real>]), mirrored(other[0], other[width<Real>]);
    for (std::int64_t c = 0; c < row_size<Real>; ++c) one[c] *= by[c % width<Real>];
    if (other != one)
      for (std::int64_t c = 0; c < row_size<Real>; ++c) other[c] *= by[c % width<Real>];
    const std::complex<Real> here = even * u + odd * std::conj(mirrored), there = even * mirrored + odd * std::conj(u);
    one[0] = here.real();
    one[width<Real>] = here.imag();
    other[0] = there.real();
    other[width<Real>] = there.imag();
  }
  along.backward(scratch, sink);
}

template <class Real> void SlabTransform<Real>::columns(std::int64_t round) {
  const Range range = blocks(rows_.rank, round);
  const std::int64_t first = strips_.first(rows_.rank) * parts;
  roughcontact::for_each(team_, range.count, parallel_, [&](std::int64_t block, std::int64_t thread) {
    Real* const rows = scratch(thread);
    ColumnSource source(*this, range, block);
    ColumnSink sink(source, axes_.y->spare_row(rows));
    if (waves_.half >= 0 && range.first + block == 0) return multiply_first(source, rows, sink);
    axes_.y->multiply(source, &eigenvalue((range.first - first + block) * width<Real>, 0), rows, sink);
  });
}

template <class Real> void SlabTransform<Real>::multiply(const Real* x, Real* y) {
  constexpr std::int64_t bytes = row_size<Real> * static_cast<std::int64_t>(sizeof(Real));
  rows_forward(x);
  for (std::int64_t round = 0; round < rounds_; ++round) {
    for (std::int64_t rank = 0; rank < rows_.ranks; ++rank) {
      if (rank == rows_.rank) continue;
      sent_[static_cast<std::size_t>(rank)] = blocks(rank, round).count * own_rows_ * bytes;
      received_[static_cast<std::size_t>(rank)] = blocks(rows_.rank, round).count * count_rows(rank) * bytes;
    }
    Real* const own =
        room_.spectra.template data<Real>() + round_begin_[static_cast<std::size_t>(round)] * own_rows_ * row_size<Real>;
    Real* const others = room_.columns.template data<Real>();
    rows_.transpose(&rows_, own, sent_.data(), others, received_.data());
    columns(round);
    rows_.transpose(&rows_, others, received_.data(), own, sent_.data());
  }
  rows_backward(y);
}

template class SlabTransform<double>;
template class SlabTransform<float>;

Slabs::Slabs(const rc_host* host, const rc_operator_spec& spec) : points_(spec.system->nx * spec.system->ny) {
  const rc_system& system = *spec.system;
  const bool periodic = system.boundary == RC_BOUNDARY_PERIODIC;
  const Lengths lengths = periodic ? Lengths{system.nx, system.ny}
                                   : fast_lengths({exact_length(0, system.nx, system.nx), exact_length(0, system.ny, system.ny)},
                                                  periods({system.nx, system.ny}, system.boundary == RC_BOUNDARY_PERIODIC_X,
                                                          system.boundary == RC_BOUNDARY_PERIODIC_Y));
  const Strips strips(SharedWaves::count_of(lengths.x), spec.rows->ranks);
  const rc_status made = roughcontact::guard(host, component, [&] {
    if (std::strcmp(roughcontact::option_text(host, spec.options, "fft.precision"), "single") == 0)
      fail(RC_ERR_OPTION, "fft.precision = single is not for grids that processes share; leave it at auto");
    double_ = std::make_unique<SlabTransform<double>>(spec, lengths, strips, room_);
    single_ = std::make_unique<SlabTransform<float>>(spec, lengths, strips, room_);
  });
  roughcontact::check(spec.rows->agree(spec.rows, made));
  periodic ? load_periodic(host, spec, strips) : load_free(host, spec, strips);
}

}  // namespace rc_fft
