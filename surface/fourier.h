// Discrete Fourier transforms of any length, by GSL's transforms of powers of two: these allocate nothing.
#pragma once

#include <complex>
#include <cstdint>
#include <vector>

namespace rc::surface {

using Complex = std::complex<double>;
enum class Direction { forward, backward };

// values[iy*nx + ix] -> sum over points of values exp(-+ 2 pi i (kx ix/nx + ky iy/ny)), not scaled, in place.
void fourier(std::vector<Complex>& values, std::int64_t nx, std::int64_t ny, Direction direction);

// The wave number's signed index: 0, 1, .. n/2, .. -1.
inline std::int64_t signed_index(std::int64_t k, std::int64_t n) { return k > n / 2 ? k - n : k; }

}  // namespace rc::surface
