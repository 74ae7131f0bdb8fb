// How the plans of one operator are made, and the caller's file that keeps what FFTW learned.
#pragma once

#include <roughcontact/plugin.hpp>
#include <string>

namespace rc_fft {

class Planning {
 public:
  Planning(const rc_host* host, const rc_options* options);

  unsigned effort() const { return effort_; }  // FFTW_ESTIMATE or FFTW_MEASURE

  // Call both under the planner's lock. Wisdom in double precision is kept in the file that the option fft.wisdom names, in
  // single precision in that name with ".float" appended. Without the option neither does anything.
  template <class Real> void recall();    // before plans are made; reads the file once
  template <class Real> void remember();  // after that; writes the file if measuring has taught anything

 private:
  struct File {
    std::string path;
    std::string contents;
    bool read = false;
  };
  template <class Real> File& file();

  unsigned effort_;
  File in_double_, in_float_;
};

}  // namespace rc_fft
