// The formats of --write.
#pragma once

#include <string>
#include <string_view>

#include "files/step_image.h"

namespace cli {

inline constexpr std::string_view step_formats[] = {"vti", "netcdf", "hdf5"};

// Extensions of the files step-K.vti, step-K.nc, step-K.h5.
inline constexpr const char* step_extensions[] = {"vti", "nc", "h5"};

struct NamedWriter {
  const char* extension;
  StepWriter write;
};
using StepWriters = std::vector<NamedWriter>;

// The writers of a list "vti,hdf5". Throws an Error if a format is unknown, or was not built in.
StepWriters find_step_writers(std::string_view formats);

// For ParaView and others that read VTK's image data; libpugixml writes what is XML of it.
void write_vti(const StepImage& image, std::FILE* file);

}  // namespace cli
