// FFTW's two libraries under one name, by precision.
#pragma once

#include <fftw3.h>

namespace bench {

template <class Real> struct Fftw;

template <> struct Fftw<double> {
  using Plan = fftw_plan;
  using Complex = fftw_complex;
  static constexpr auto alloc_real = fftw_alloc_real;
  static constexpr auto init_threads = fftw_init_threads;
  static constexpr auto plan_with_threads = fftw_plan_with_nthreads;
  static constexpr auto set_time_limit = fftw_set_timelimit;
  static constexpr auto plan_complex = fftw_plan_dft_1d;
  static constexpr auto plan_real_2d = fftw_plan_dft_r2c_2d;
  static constexpr auto plan_real_back_2d = fftw_plan_dft_c2r_2d;
  static constexpr auto execute = fftw_execute;
  static constexpr auto destroy = fftw_destroy_plan;
};

template <> struct Fftw<float> {
  using Plan = fftwf_plan;
  using Complex = fftwf_complex;
  static constexpr auto alloc_real = fftwf_alloc_real;
  static constexpr auto init_threads = fftwf_init_threads;
  static constexpr auto plan_with_threads = fftwf_plan_with_nthreads;
  static constexpr auto set_time_limit = fftwf_set_timelimit;
  static constexpr auto plan_complex = fftwf_plan_dft_1d;
  static constexpr auto plan_real_2d = fftwf_plan_dft_r2c_2d;
  static constexpr auto plan_real_back_2d = fftwf_plan_dft_c2r_2d;
  static constexpr auto execute = fftwf_execute;
  static constexpr auto destroy = fftwf_destroy_plan;
};

}  // namespace bench
