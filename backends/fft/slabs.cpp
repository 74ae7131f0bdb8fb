#include "slabs.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>

#include "lines.h"

namespace rc_fft {

namespace {

constexpr double round_bytes = 8 << 20;  // of a process's spectra that one transposition carries, about
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
      all_blocks_(lengths.x / 2 / width<Real> + 1),
      passes_size_(std::max(Fourier<Real>::scratch_rows(lengths.x), Fourier<Real>::scratch_rows(lengths.y)) * row_size<Real>),
      tiles_size_(own_rows_ % most_lines<Real> == 0 ? 0 : all_blocks_ * tile),
      parallel_(worth_sharing(lengths)) {
  const double bytes = static_cast<double>(all_blocks_) * static_cast<double>(ny_ * row_size<Real>) * sizeof(Real) /
                       static_cast<double>(rows_.ranks);
  const std::int64_t most_strips = (strips.count + rows_.ranks - 1) / rows_.ranks;
  rounds_ = std::clamp<std::int64_t>(static_cast<std::int64_t>(bytes / round_bytes), 1, std::min(most_strips, most_rounds));
  round_strips_ = (most_strips + rounds_ - 1) / rounds_;
  for (std::int64_t rank = 0; rank < rows_.ranks; ++rank)
    owner_.insert(owner_.end(), static_cast<std::size_t>(count_rows(rank)), static_cast<std::int32_t>(rank));
  place_.resize(static_cast<std::size_t>(all_blocks_));
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
        along.passes().to_spectra(scratch(thread), along.rows() + range.first * width<Real>, waves_in(range),
                                  spectra(range) + before * range.count * row_size<Real>);
      });
      return;
    }
    Real* const tiles = scratch(thread) + passes_size_;
    along.passes().to_spectra(scratch(thread), along.rows(), along.waves(), tiles);
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
        along.passes().from_spectra(spectra(range) + group * count * range.count * row_size<Real>, count,
                                    along.rows() + range.first * width<Real>, waves_in(range), scratch(thread));
      });
    } else {
      Real* const tiles = scratch(thread) + passes_size_;
      each_line(group, tiles, [](Real* to, const Real* from) { std::copy_n(from, row_size<Real>, to); });
      // All lines are asked for: a line that is not wanted has no neighbour in its sequence, whose waves are then 0.
      for (std::int64_t i = lines; i < count; ++i)
        for (std::int64_t block = 0; block < all_blocks_; ++block)
          std::fill_n(tiles + block * tile + in_tile<Real>(i) * row_size<Real>, row_size<Real>, Real{0});
      along.passes().from_spectra(tiles, count, along.rows(), along.waves(), scratch(thread));
    }
    LineSink<Real> sink(along.passes(), wanted, nx_);
    along.backward(scratch(thread), sink);
  });
}

template <class Real> void SlabTransform<Real>::columns(std::int64_t round) {
  const Range range = blocks(rows_.rank, round);
  const std::int64_t first = strips_.first(rows_.rank) * parts;
  roughcontact::for_each(team_, range.count, parallel_, [&](std::int64_t block, std::int64_t thread) {
    Real* const rows = scratch(thread);
    ColumnSource source(*this, range, block);
    ColumnSink sink(source, axes_.y->spare_row(rows));
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

namespace {

// The eigenvalues of one of a process's strips of waves along x, for one wave along y.
template <class Real> void load(SlabTransform<Real>& to, std::int64_t own_strip, std::int64_t rank_y, const double* values) {
  const double factor = 0.5 / points(to.lengths());
  for (std::int64_t c = 0; c < strip; ++c) to.eigenvalue(own_strip * strip + c, rank_y) = static_cast<Real>(factor * values[c]);
}

// Rows of coefficients, each somewhere: row i is row length - i as well.
class EvenRows : public Source<double> {
 public:
  EvenRows(std::span<const double* const> rows, std::int64_t column, std::int64_t length)
      : Source(length), rows_(rows), column_(column) {}

  void read(int, std::int64_t first, std::int64_t count, const double** to) override {
    for (std::int64_t i = 0; i < count; ++i) {
      const auto row = static_cast<std::size_t>(std::min(first + i, end() - first - i));
      to[i] = row < rows_.size() ? rows_[row] + column_ * strip : zero_row<double>;
    }
  }

 private:
  std::span<const double* const> rows_;
  std::int64_t column_;
};

}  // namespace

Slabs::Slabs(const rc_host* host, const rc_operator_spec& spec) : points_(spec.system->nx * spec.system->ny) {
  const rc_system& system = *spec.system;
  const bool periodic = system.boundary == RC_BOUNDARY_PERIODIC;
  const Lengths lengths =
      periodic ? Lengths{system.nx, system.ny}
               : Lengths{fast_length(exact_length(0, system.nx, system.nx)), fast_length(exact_length(0, system.ny, system.ny))};
  const Strips strips(lengths.x / 2 + 1, spec.rows->ranks);
  const rc_status made = roughcontact::guard(host, component, [&] {
    if (std::strcmp(roughcontact::option_text(host, spec.options, "fft.precision"), "single") == 0)
      fail(RC_ERR_OPTION, "fft.precision = single is not for grids that processes share; leave it at auto");
    double_ = std::make_unique<SlabTransform<double>>(spec, lengths, strips, room_);
    single_ = std::make_unique<SlabTransform<float>>(spec, lengths, strips, room_);
  });
  roughcontact::check(spec.rows->agree(spec.rows, made));
  periodic ? load_periodic(host, spec, strips) : load_free(host, spec, strips);
}

// Each process transforms some rows of the coefficients along x, all processes exchange them, and each transforms its columns.
void Slabs::load_free(const rc_host* host, const rc_operator_spec& spec, const Strips& strips) {
  constexpr std::int64_t most = most_lines<double>;
  constexpr std::int64_t strip_bytes = strip * static_cast<std::int64_t>(sizeof(double));
  const rc_rows& rows = *spec.rows;
  const Lengths lengths = double_->lengths();
  const Axes<double> axes(lengths);
  const Fourier<double>& along = *axes.x;
  const std::int64_t row_length = std::min(along.waves(), spec.system->nx), all_rows = std::min(axes.y->waves(), spec.system->ny);
  const std::int64_t items = (all_rows + most - 1) / most;
  const auto first_row = [&](std::int64_t rank) { return std::min(rank * items / rows.ranks * most, all_rows); };
  const std::int64_t begin = first_row(rows.rank), own = first_row(rows.rank + 1) - begin;
  const std::int64_t first_strip = strips.first(rows.rank), own_strips = strips.first(rows.rank + 1) - first_strip;
  const std::int64_t scratch_rows = std::max(Fourier<double>::scratch_rows(lengths.x), Fourier<double>::scratch_rows(lengths.y));
  std::vector<std::int64_t> strip_rank;  // which process has a strip
  const auto to_process = [&](std::int64_t s, std::int64_t row) {
    const std::int64_t rank = strip_rank[static_cast<std::size_t>(s)], before = strips.first(rank),
                       count = strips.first(rank + 1) - before;
    return (before * own + row * count + s - before) * strip;
  };
  Buffer sent, received, scratch;
  std::vector<std::int64_t> give, take;
  std::vector<const double*> places;  // of the first of this process's strips in each row that is received
  const rc_status made = roughcontact::guard(host, component, [&] {
    const auto at_least_one = [](std::int64_t n) { return std::max<std::int64_t>(n, 1); };
    sent.reserve<double>(at_least_one(own * strips.count), strip, lengths);
    received.reserve<double>(at_least_one(all_rows * own_strips), strip, lengths);
    scratch.reserve<double>(spec.team->threads, (scratch_rows + 2 * row_length) * most, lengths);
    for (std::int64_t rank = 0; rank < rows.ranks; ++rank)
      strip_rank.insert(strip_rank.end(), static_cast<std::size_t>(strips.first(rank + 1) - strips.first(rank)), rank);
    std::vector<char> failed(static_cast<std::size_t>((own + most - 1) / most), 0);
    roughcontact::for_each(*spec.team, (own + most - 1) / most, true, [&](std::int64_t item, std::int64_t thread) {
      double* const room = scratch.data<double>() + thread * (scratch_rows + 2 * row_length) * most;
      double *const sequences = room + scratch_rows * most, *const coefficients = sequences + row_length * most;
      const std::int64_t count = std::min(most, own - item * most);
      if (host->window(host, spec.system, spec.kernel, 0, begin + item * most, row_length, count, coefficients) != RC_OK) {
        failed[static_cast<std::size_t>(item)] = 1;
        return;
      }
      for (std::int64_t i = 0; i < row_length; ++i)
        for (std::int64_t row = 0; row < most; ++row)
          sequences[i * most + row] = row < count ? coefficients[row * row_length + i] : 0;
      // Two real rows in one complex sequence. They are even, so their transforms are real and do not mix.
      EvenSource<double> source(sequences, most, row_length, along.length());
      along.forward(source, room);
      // To each process, row by row, its strips.
      for (std::int64_t row = 0; row < count; ++row)
        for (std::int64_t s = 0; s < strips.count; ++s)
          for (std::int64_t c = 0; c < strip; ++c) {
            const std::int64_t rank = s * strip + c;
            sent.data<double>()[to_process(s, item * most + row) + c] =
                rank < along.waves() ? room[along.rows()[rank].row * most + row] : 0;
          }
    });
    // Asks again on this thread for the message: those of other threads are not seen here.
    std::vector<double> row(static_cast<std::size_t>(row_length));
    if (const auto at = std::find(failed.begin(), failed.end(), 1); at != failed.end())
      roughcontact::check(
          host->window(host, spec.system, spec.kernel, 0, begin + (at - failed.begin()) * most, row_length, 1, row.data()));
    for (std::int64_t rank = 0; rank < rows.ranks; ++rank) {
      give.push_back((strips.first(rank + 1) - strips.first(rank)) * own * strip_bytes);
      take.push_back((first_row(rank + 1) - first_row(rank)) * own_strips * strip_bytes);
    }
    for (std::int64_t i = 0; i < all_rows; ++i) places.push_back(received.data<double>() + i * own_strips * strip);
  });
  roughcontact::check(rows.agree(&rows, made));
  rows.transpose(&rows, sent.data<double>(), give.data(), received.data<double>(), take.data());

  roughcontact::for_each(*spec.team, own_strips, true, [&](std::int64_t s, std::int64_t thread) {
    double* const room = scratch.data<double>() + thread * (scratch_rows + 2 * row_length) * most;
    EvenRows source(places, s, axes.y->length());
    axes.y->forward(source, room);
    for (std::int64_t rank = 0; rank < axes.y->waves(); ++rank) {
      const double* const values = room + axes.y->rows()[rank].row * row_size<double>;
      load(*double_, s, rank, values);
      load(*single_, s, rank, values);
    }
  });
}

void Slabs::load_periodic(const rc_host* host, const rc_operator_spec& spec, const Strips& strips) {
  const rc_rows& rows = *spec.rows;
  const Lengths lengths = double_->lengths();
  const rc_status made = roughcontact::guard(host, component, [&] {
    const Axes<double> axes(lengths);
    const std::int64_t waves = axes.x->waves();
    Buffer table;
    table.reserve<double>(axes.y->waves(), waves, lengths);
    roughcontact::check(host->symbol(host, spec.system, spec.kernel, table.data<double>()));
    const std::int64_t first = strips.first(rows.rank), last = strips.first(rows.rank + 1);
    for (std::int64_t ky = 0; ky < axes.y->waves(); ++ky)
      for (std::int64_t s = first; s < last; ++s) {
        double values[strip] = {};
        for (std::int64_t kx = 0; kx < waves; ++kx) {
          const std::int64_t at = axes.x->rank(kx) - s * strip;
          if (at >= 0 && at < strip) values[at] = table.data<double>()[ky * waves + kx];
        }
        load(*double_, s - first, axes.y->rank(ky), values);
        load(*single_, s - first, axes.y->rank(ky), values);
      }
  });
  roughcontact::check(rows.agree(&rows, made));
}

}  // namespace rc_fft
