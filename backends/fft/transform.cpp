#include "transform.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "lines.h"

namespace rc_fft {

namespace {

// Rows of a block of columns among the spectra of all lines: address of row i.
template <class Real> struct Column {
  Real* row(std::int64_t i) const { return first + i / most_lines<Real> * group + i % most_lines<Real> * row_size<Real>; }
  Real* first;
  std::int64_t group;  // from one group of lines to the next
};

template <class Real> class ColumnSource : public Source<Real> {
 public:
  // Rows outside of [begin, begin + count) are zero.
  ColumnSource(const Column<Real>& column, std::int64_t begin, std::int64_t count)
      : Source<Real>(begin + count), column_(column), begin_(begin) {}

  void read(int, std::int64_t first, std::int64_t count, const Real** rows) override {
    for (std::int64_t i = first; i < first + count; ++i)
      rows[i - first] = i >= begin_ && i < this->end() ? column_.row(i) : zero_row<Real>;
  }

 private:
  Column<Real> column_;
  std::int64_t begin_;
};

template <class Real> class ColumnSink : public Sink<Real> {
 public:
  // Rows that are not wanted go to `spare`.
  ColumnSink(const Column<Real>& column, std::int64_t count, Real* spare) : Sink<Real>(count), column_(column), spare_(spare) {}

  void room(int, std::int64_t first, std::int64_t count, Real** rows) override {
    for (std::int64_t i = first; i < first + count; ++i) rows[i - first] = i < this->end() ? column_.row(i) : spare_;
  }

 private:
  Column<Real> column_;
  Real* spare_;
};

}  // namespace

template <class Real> Waves<Real>::Waves(Lengths of) : lengths(of) {
  spectrum.reserve<Real>(blocks() * width<Real>, lengths.y / 2 + 1, lengths);  // before anything that is long in the making
  axes = Axes<Real>(lengths);
  const bool splits = Split<Real>::suits(lengths);
  // Places without a wave are multiplied, too, and what lies there by chance may be denormal, which takes a hundred times as
  // long.
  const std::int64_t first = splits ? 0 : offset(blocks() - 1, 0);
  std::fill_n(spectrum.data<Real>() + first, count() - first, Real{0});
  if (!splits) return;
  split = std::make_unique<const Split<Real>>(lengths.x);
  wave.resize(static_cast<std::size_t>(axes.x->waves()));
  for (std::int64_t k = 0; k < axes.x->waves(); ++k) wave[static_cast<std::size_t>(axes.x->rank(k))] = k;
}

template <class Real> void Waves<Real>::load(const Eigenvalues& source, const rc_team& team) {
  const double factor = scale();
  roughcontact::for_each(team, source.blocks(), worth_sharing(lengths), [&](std::int64_t wide, std::int64_t thread) {
    constexpr std::int64_t parts = Eigenvalues::columns / width<Real>;
    const std::int64_t first = wide * parts, last = std::min(first + parts, blocks());
    source.along_y(wide, thread, [&](std::int64_t rank, const double* values) {
      if (split) {
        const std::int64_t begin = wide * Eigenvalues::columns, end = std::min(begin + Eigenvalues::columns, axes.x->waves());
        for (std::int64_t x = begin; x < end; ++x) *eigenvalue(x, rank) = static_cast<Real>(factor * values[x - begin]);
        return;
      }
      for (std::int64_t block = first; block < last; ++block) {
        Real* const to = spectrum.data<Real>() + offset(block, rank);
        const double* const from = values + (block - first) * width<Real>;
        for (std::int64_t c = 0; c < width<Real>; ++c) to[c] = static_cast<Real>(factor * from[c]);
      }
    });
  });
}

template <class Real> template <class Other> void Waves<Real>::load(const Waves<Other>& source) {
  for (std::int64_t x = 0; x < axes.x->waves(); ++x)
    for (std::int64_t y = 0; y < axes.y->waves(); ++y) *eigenvalue(x, y) = static_cast<Real>(*source.eigenvalue(x, y));
}

template <class Real>
Transform<Real>::Transform(std::shared_ptr<const Waves<Real>> waves, std::int64_t rows, Workspace& workspace, const rc_team& team)
    : waves_(std::move(waves)),
      group_(blocks() * most_lines<Real> * row_size<Real>),
      line_(round_up(waves_->lengths.x, width<Real>)),
      scratch_(std::max(Fourier<Real>::scratch_rows(waves_->lengths.x), Fourier<Real>::scratch_rows(waves_->lengths.y)) *
                   row_size<Real> +
               most_lines<Real> * line_),
      workspace_(workspace),
      team_(team),
      parallel_(worth_sharing(waves_->lengths)) {
  // Else the parts of a column would compete for the same cache sets.
  if (blocks() % 8 == 0) group_ += most_lines<Real> * row_size<Real>;
  reserve(rows);
}

template <class Real> void Transform<Real>::set_zero_mode(double eigenvalue) {
  if (eigenvalue == 0) {
    own_.reset();
    return;
  }
  if (!own_) {
    auto own = std::make_unique<Buffer>();
    own->reserve<Real>(waves_->count(), 1, waves_->lengths);
    std::copy_n(waves_->spectrum.template data<Real>(), waves_->count(), own->data<Real>());
    own_ = std::move(own);
  }
  *own_->data<Real>() = static_cast<Real>(waves_->scale() * eigenvalue);
}

template <class Real> void Transform<Real>::reserve(std::int64_t rows) {
  workspace_.rows.reserve<Real>((rows + most_lines<Real> - 1) / most_lines<Real>, group_, waves_->lengths);
  workspace_.scratch.reserve<Real>(team_.threads, scratch_, waves_->lengths);
}

template <class Real>
template <class Outer>
void Transform<Real>::multiply(const Points& sources, std::int64_t x0, std::int64_t y0, const Outer* x, const Points& targets,
                               Outer* y, const Conversion& convert) {
  reserve(std::max(y0 + sources.rows(), targets.rows()));
  rows_forward(sources, x0, y0, x, convert);
  columns(y0, sources.rows(), targets.rows());
  rows_backward(targets, y, convert);
}

template <class Real>
template <class Outer>
void Transform<Real>::rows_forward(const Points& sources, std::int64_t x0, std::int64_t y0, const Outer* x,
                                   const Conversion& convert) {
  constexpr std::int64_t count = most_lines<Real>;
  const std::int64_t first_group = y0 / count, end_group = (y0 + sources.rows() + count - 1) / count;
  roughcontact::for_each(team_, end_group - first_group, parallel_, [&](std::int64_t item, std::int64_t thread) {
    const std::int64_t group = first_group + item;
    const std::int64_t begin = std::max<std::int64_t>(group * count - y0, 0);
    const std::int64_t end = std::min((group + 1) * count - y0, sources.rows());
    const Real* given[count] = {};
    bool zero = true;
    for (std::int64_t i = begin; i < end; ++i) {
      const Real* as_it_is = nullptr;  // a row that need not be copied
      if constexpr (std::is_same_v<Real, Outer>) as_it_is = x0 == 0 ? sources.row(i, x) : nullptr;
      if (convert.mean == 0 && (zero || !as_it_is) && sources.row_is_zero(i, x)) continue;
      zero = false;
      const std::int64_t line = y0 + i - group * count;
      if ((given[line] = as_it_is)) continue;
      Real* const padded = lines(thread) + line * line_;
      std::fill_n(padded, x0, Real{0});
      sources.scatter(i, x, padded + x0, convert);
      given[line] = padded;
    }
    if (zero) {
      std::fill_n(spectra(group), blocks() * most_lines<Real> * row_size<Real>, Real{0});
      return;
    }
    if (waves_->split) {
      for (std::int64_t l = 0; l < y0 + sources.rows(); l += 2)
        waves_->split->forward(given + l, x0 + sources.nx(), scratch(thread), room(thread), spectra(0) + l * row_size<Real>);
      return;
    }
    const Fourier<Real>& along = *waves_->axes.x;
    LineSource<Real> source(along.passes(), given, x0 + sources.nx());
    along.forward(source, scratch(thread));
    along.passes().to_spectra(scratch(thread), along.rows(), along.waves(), spectra(group));
  });
}

template <class Real> void Transform<Real>::columns(std::int64_t y0, std::int64_t source_rows, std::int64_t target_rows) {
  roughcontact::for_each(team_, blocks(), parallel_, [&](std::int64_t block, std::int64_t thread) {
    const Column<Real> column{spectra(0) + block * most_lines<Real> * row_size<Real>, group_};
    Real* const rows = scratch(thread);
    ColumnSource<Real> source(column, y0, source_rows);
    ColumnSink<Real> sink(column, target_rows, waves_->axes.y->spare_row(rows));
    waves_->axes.y->multiply(source, eigenvalues(block), rows, sink);
  });
}

template <class Real>
template <class Outer>
void Transform<Real>::rows_backward(const Points& targets, Outer* y, const Conversion& convert) {
  constexpr std::int64_t count = most_lines<Real>;
  const std::int64_t groups = (targets.rows() + count - 1) / count;
  roughcontact::for_each(team_, groups, parallel_, [&](std::int64_t group, std::int64_t thread) {
    const std::int64_t begin = group * count, rows = std::min(count, targets.rows() - begin);
    Real* wanted[count] = {};
    for (std::int64_t i = 0; i < rows; ++i) {
      if (targets.row_is_empty(begin + i)) continue;
      if constexpr (std::is_same_v<Real, Outer>) wanted[i] = targets.row(begin + i, y);
      if (!wanted[i]) wanted[i] = lines(thread) + i * line_;
    }
    if (waves_->split) {
      for (std::int64_t l = 0; l < rows; l += 2)
        waves_->split->backward(spectra(0) + l * row_size<Real>, l + 1 < rows, scratch(thread), room(thread), wanted + l,
                                targets.nx());
    } else {
      const Fourier<Real>& along = *waves_->axes.x;
      along.passes().from_spectra(spectra(group), rows, along.rows(), along.waves(), scratch(thread));
      LineSink<Real> sink(along.passes(), wanted, targets.nx());
      along.backward(scratch(thread), sink);
    }
    for (std::int64_t i = 0; i < rows; ++i)
      if (wanted[i] == lines(thread) + i * line_) targets.gather(begin + i, wanted[i], y, convert);
  });
}

template class Transform<double>;
template class Transform<float>;
template struct Waves<double>;
template struct Waves<float>;
template void Waves<float>::load(const Waves<double>&);
template void Transform<double>::multiply(const Points&, std::int64_t, std::int64_t, const double*, const Points&, double*,
                                          const Conversion&);
template void Transform<float>::multiply(const Points&, std::int64_t, std::int64_t, const float*, const Points&, float*,
                                         const Conversion&);
template void Transform<float>::multiply(const Points&, std::int64_t, std::int64_t, const double*, const Points&, double*,
                                         const Conversion&);

}  // namespace rc_fft
