// The eigenvalues of H for slabs.h: each process makes those of the waves that it has.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "lines.h"
#include "slabs.h"

namespace rc_fft {

namespace {

// The eigenvalues of one of a process's strips of waves along x, for one wave along y; half: of the wave length/2 along x alone.
template <class Real>
void load(SlabTransform<Real>& to, std::int64_t own_strip, std::int64_t rank_y, const double* values, bool half) {
  const double factor = 0.5 / points(to.lengths());
  if (half)
    to.half_eigenvalue(rank_y) = static_cast<Real>(factor * values[0]);
  else
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
  // The process with the first strip has one more, with the wave length/2 alone.
  const SharedWaves waves(along);
  const std::int64_t with_half = waves.half < 0 ? -1 : strips.owner_of_first();
  const auto strips_before = [&](std::int64_t rank) { return strips.first(rank) + (with_half >= 0 && rank > with_half ? 1 : 0); };
  const std::int64_t all_strips = strips_before(rows.ranks), own_strips = strips_before(rows.rank + 1) - strips_before(rows.rank);
  const std::int64_t scratch_rows = std::max(Fourier<double>::scratch_rows(lengths.x), Fourier<double>::scratch_rows(lengths.y));
  std::vector<std::int64_t> strip_rank;  // which process has a strip
  const auto to_process = [&](std::int64_t s, std::int64_t row) {
    const std::int64_t rank = strip_rank[static_cast<std::size_t>(s)], before = strips_before(rank),
                       count = strips_before(rank + 1) - before;
    return (before * own + row * count + s - before) * strip;
  };
  // The wave of a strip's column; -1: none.
  const auto wave_of = [&](std::int64_t s, std::int64_t column) {
    const std::int64_t rank = strip_rank[static_cast<std::size_t>(s)],
                       place = (s - strips_before(rank) + strips.first(rank)) * strip + column;
    if (rank == with_half && s + 1 == strips_before(rank + 1)) return column == 0 ? waves.half : -1;
    return place < waves.count ? waves.rank(place) : -1;
  };
  Buffer sent, received, scratch;
  std::vector<std::int64_t> give, take;
  std::vector<const double*> places;  // of the first of this process's strips in each row that is received
  const rc_status made = roughcontact::guard(host, component, [&] {
    const auto at_least_one = [](std::int64_t n) { return std::max<std::int64_t>(n, 1); };
    sent.reserve<double>(at_least_one(own * all_strips), strip, lengths);
    received.reserve<double>(at_least_one(all_rows * own_strips), strip, lengths);
    scratch.reserve<double>(spec.team->threads, (scratch_rows + 2 * row_length) * most, lengths);
    for (std::int64_t rank = 0; rank < rows.ranks; ++rank)
      strip_rank.insert(strip_rank.end(), static_cast<std::size_t>(strips_before(rank + 1) - strips_before(rank)), rank);
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
        for (std::int64_t s = 0; s < all_strips; ++s)
          for (std::int64_t c = 0; c < strip; ++c) {
            const std::int64_t wave = wave_of(s, c);
            sent.data<double>()[to_process(s, item * most + row) + c] = wave >= 0 ? room[along.rows()[wave].row * most + row] : 0;
          }
    });
    // Asks again on this thread for the message: those of other threads are not seen here.
    std::vector<double> row(static_cast<std::size_t>(row_length));
    if (const auto at = std::find(failed.begin(), failed.end(), 1); at != failed.end())
      roughcontact::check(
          host->window(host, spec.system, spec.kernel, 0, begin + (at - failed.begin()) * most, row_length, 1, row.data()));
    for (std::int64_t rank = 0; rank < rows.ranks; ++rank) {
      give.push_back((strips_before(rank + 1) - strips_before(rank)) * own * strip_bytes);
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
      const bool half = rows.rank == with_half && s + 1 == own_strips;
      load(*double_, s, rank, values, half);
      load(*single_, s, rank, values, half);
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
    const SharedWaves shared(*axes.x);
    std::vector<std::int64_t> wave_of(static_cast<std::size_t>(waves));  // by rank
    for (std::int64_t kx = 0; kx < waves; ++kx) wave_of[static_cast<std::size_t>(axes.x->rank(kx))] = kx;
    for (std::int64_t ky = 0; ky < axes.y->waves(); ++ky) {
      const double* const row = table.data<double>() + ky * waves;
      const auto put = [&](std::int64_t own_strip, const double* values, bool half) {
        load(*double_, own_strip, axes.y->rank(ky), values, half);
        load(*single_, own_strip, axes.y->rank(ky), values, half);
      };
      for (std::int64_t s = first; s < last; ++s) {
        double values[strip] = {};
        for (std::int64_t c = 0; c < std::min(strip, shared.count - s * strip); ++c)
          values[c] = row[wave_of[static_cast<std::size_t>(shared.rank(s * strip + c))]];
        put(s - first, values, false);
      }
      if (double_->has_half()) put(0, row + waves - 1, true);
    }
  });
  roughcontact::check(rows.agree(&rows, made));
}

}  // namespace rc_fft
