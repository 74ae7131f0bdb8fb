// y = H x between two sets of points of one frame, by a pruned circular convolution: only rows with sources are transformed
// forward, columns go through a scratch that stays in the cache, and only rows with targets are transformed back.
#pragma once

#include <memory>
#include <roughcontact/plugin.hpp>
#include <vector>

#include "buffer.h"
#include "fourier.h"
#include "lengths.h"
#include "points.h"
#include "spectrum.h"
#include "split.h"

namespace rc_fft {

// The data that all transforms of these lengths share: their factors, and the eigenvalues of the operator.
template <class Real> struct Waves {
  explicit Waves(Lengths of);

  // Takes over eigenvalues of these lengths.
  void load(const Eigenvalues& source, const rc_team& team);
  template <class Other> void load(const Waves<Other>& source);

  double scale() const { return 0.5 / points(lengths); }
  std::int64_t blocks() const { return lengths.x / 2 / width<Real> + 1; }
  std::int64_t count() const { return blocks() * width<Real> * (lengths.y / 2 + 1); }  // of the eigenvalues
  // The position in the spectrum of a block of waves along x and the wave along y of this rank.
  std::int64_t offset(std::int64_t block, std::int64_t rank) const { return (block * (lengths.y / 2 + 1) + rank) * width<Real>; }
  // The place in the spectra of the wave along x of this rank.
  std::int64_t place(std::int64_t rank) const { return split ? wave[static_cast<std::size_t>(rank)] : rank; }
  Real* eigenvalue(std::int64_t rank_x, std::int64_t rank_y) const {
    const std::int64_t at = place(rank_x);
    return spectrum.data<Real>() + offset(at / width<Real>, rank_y) + at % width<Real>;
  }

  Lengths lengths;
  Axes<Real> axes;
  std::unique_ptr<const Split<Real>> split;  // where there are few lines, all in one group; with it waves are in their order
  std::vector<std::int64_t> wave;            // of each rank along x; likewise
  Buffer spectrum;  // eigenvalues / (2 x y lengths), [block of waves along x][wave along y][wave of the block], waves by rank
};

template <class Real> class Transform {
 public:
  // Makes room for targets in `rows` rows; products with more rows enlarge it.
  Transform(std::shared_ptr<const Waves<Real>> waves, std::int64_t rows, Workspace& workspace, const rc_team& team);

  std::size_t bytes() const { return waves_->spectrum.size(); }
  const Waves<Real>& waves() const { return *waves_; }
  // Sets the eigenvalue of the constant vector in periodic systems, which is 0 until then. Another value takes a spectrum of its
  // own.
  void set_zero_mode(double eigenvalue);

  // The sources' box begins at (x0, y0) of the frame, the targets' at its origin. Outer: the vectors' precision.
  template <class Outer>
  void multiply(const Points& sources, std::int64_t x0, std::int64_t y0, const Outer* x, const Points& targets, Outer* y,
                const Conversion& convert = {});

 private:
  std::int64_t blocks() const { return waves_->blocks(); }
  void reserve(std::int64_t rows);
  // Spectra of lines most_lines * group and following, see Passes.
  Real* spectra(std::int64_t group) const { return workspace_.rows.data<Real>() + group * group_; }
  Real* scratch(std::int64_t thread) const { return workspace_.scratch.data<Real>() + thread * scratch_; }
  Real* lines(std::int64_t thread) const { return scratch(thread) + scratch_ - most_lines<Real> * line_; }
  // For lines that are split, of which there are at most half as many.
  Real* room(std::int64_t thread) const { return lines(thread) + most_lines<Real> / 2 * line_; }
  const Real* eigenvalues(std::int64_t block) const {
    return (own_ ? *own_ : waves_->spectrum).template data<Real>() + waves_->offset(block, 0);
  }

  template <class Outer>
  void rows_forward(const Points& sources, std::int64_t x0, std::int64_t y0, const Outer* x, const Conversion& convert);
  void columns(std::int64_t y0, std::int64_t source_rows, std::int64_t target_rows);
  template <class Outer> void rows_backward(const Points& targets, Outer* y, const Conversion& convert);

  std::shared_ptr<const Waves<Real>> waves_;
  std::unique_ptr<Buffer> own_;  // the same eigenvalues but that of the constant vector; null: it is 0
  std::int64_t group_;           // spectra of most_lines lines [reals]
  std::int64_t line_;            // a line [reals]
  std::int64_t scratch_;         // of a thread: of a transform, and lines [reals]
  Workspace& workspace_;
  const rc_team& team_;
  bool parallel_;
};

}  // namespace rc_fft
