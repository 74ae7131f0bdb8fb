// `roughcontact generate`: a surface made by the surface library, written to a file.
#pragma once

#include <optional>
#include <string>

namespace cli {

struct GenerateArguments {
  std::string output;
  std::optional<std::string> size, pitch, unit, seed;
  std::optional<std::string> hurst, rms_height, rms_slope;  // rmd, spectral, noise
  std::optional<std::string> levels, stage;                 // rmd
  std::optional<std::string> longest, roll_off, shortest;   // spectral: wavelengths
  std::optional<std::string> radius, height, period;        // shapes
  bool vertices = false, additions = false;                 // rmd
  bool fixed_amplitudes = false;                            // spectral
  bool paraboloid = false;                                  // sphere
};

// Throws an Error for wrong input and failed calls; the file is then not made.
void generate(const std::string& kind, const GenerateArguments& arguments);

}  // namespace cli
