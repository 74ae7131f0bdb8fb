// A picture in a file of its own.
#pragma once

#include <cstdio>
#include <functional>
#include <string>

#include "pictures/gnuplot.h"

namespace cli {

// Reports a picture that gnuplot could not draw; there is then no file.
void write_picture(const std::string& path, const std::function<Gnuplot(std::FILE*)>& draw);

}  // namespace cli
