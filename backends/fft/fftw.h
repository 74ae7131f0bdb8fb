// FFTW's two libraries under one name, by precision.
#pragma once

#include <fftw3.h>

#include <complex>

namespace rc_fft {

template <class Real> struct Fftw;

template <> struct Fftw<double> {
  using Plan = fftw_plan;
  using Complex = fftw_complex;
  static constexpr auto plan_real = fftw_plan_dft_r2c_1d;
  static constexpr auto plan_real_back = fftw_plan_dft_c2r_1d;
  static constexpr auto plan_complex = fftw_plan_many_dft;
  static constexpr auto execute_real = fftw_execute_dft_r2c;
  static constexpr auto execute_real_back = fftw_execute_dft_c2r;
  static constexpr auto execute_complex = fftw_execute_dft;
  static constexpr auto destroy = fftw_destroy_plan;
  static constexpr auto make_planner_thread_safe = fftw_make_planner_thread_safe;
  static constexpr auto planner_threads = fftw_planner_nthreads;
  static constexpr auto plan_with_threads = fftw_plan_with_nthreads;
  static constexpr auto import_wisdom = fftw_import_wisdom_from_string;
  static constexpr auto export_wisdom = fftw_export_wisdom_to_string;
  static const char* version() { return fftw_version; }
};

template <> struct Fftw<float> {
  using Plan = fftwf_plan;
  using Complex = fftwf_complex;
  static constexpr auto plan_real = fftwf_plan_dft_r2c_1d;
  static constexpr auto plan_real_back = fftwf_plan_dft_c2r_1d;
  static constexpr auto plan_complex = fftwf_plan_many_dft;
  static constexpr auto execute_real = fftwf_execute_dft_r2c;
  static constexpr auto execute_real_back = fftwf_execute_dft_c2r;
  static constexpr auto execute_complex = fftwf_execute_dft;
  static constexpr auto destroy = fftwf_destroy_plan;
  static constexpr auto make_planner_thread_safe = fftwf_make_planner_thread_safe;
  static constexpr auto planner_threads = fftwf_planner_nthreads;
  static constexpr auto plan_with_threads = fftwf_plan_with_nthreads;
  static constexpr auto import_wisdom = fftwf_import_wisdom_from_string;
  static constexpr auto export_wisdom = fftwf_export_wisdom_to_string;
  static const char* version() { return fftwf_version; }
};

template <class Real> typename Fftw<Real>::Complex* as_fftw(std::complex<Real>* z) {
  return reinterpret_cast<typename Fftw<Real>::Complex*>(z);
}

}  // namespace rc_fft
