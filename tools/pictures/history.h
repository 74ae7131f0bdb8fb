// history.png: contact area, mean gap and stiffness of all steps against the load, and the load against the approach; of bodies
// that creep all against time.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "pictures/gnuplot.h"
#include "solve/problem.h"

namespace cli {

struct HistoryPoint {
  double load = 0, approach = 0, area_fraction = 0, corrected_area = 0, mean_gap = 0, stiffness = 0, time = 0;  // NaN: not known
};

// Draws to the file with gnuplot. Persson's line goes with the area if his theory is of such a surface.
Gnuplot draw_history(const Problem& problem, const std::vector<HistoryPoint>& steps, std::FILE* file);

}  // namespace cli
