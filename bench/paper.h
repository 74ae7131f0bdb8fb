// The figures of Bemporad & Paggi (2015), measured anew: the rows behind docs/paper.md.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "child.h"

namespace bench {

struct PaperRequest {
  std::vector<std::int64_t> figures;  // of paper_figures(); empty: all
  bool quick = false;                 // small grids, few seeds
  std::string surfaces;               // folder with measured surfaces; empty: figures 10 and 11 show generated ones alone
  std::string file;                   // results, which a later call goes on with; empty: none
  std::int64_t threads = 1;           // of FFT products; dense ones have one
};

// One row of a list of the results.
struct Measurement {
  std::string list;
  Json key;     // tells the row from the others of the list, and goes into it
  double cost;  // seconds to expect, for the progress bar alone
  std::function<Json()> measure;
};
using Plan = std::vector<Measurement>;

// What a part of the paper needs, each in a file of its own.
void plan_example_1(const PaperRequest& request, Plan& plan);
void plan_algorithm_2(const PaperRequest& request, Plan& plan);
void plan_figure_4(const PaperRequest& request, Plan& plan);
void plan_figure_5(const PaperRequest& request, Plan& plan);
void plan_figure_6(const PaperRequest& request, Plan& plan);
void plan_figure_8(const PaperRequest& request, Plan& plan);
void plan_figure_9(const PaperRequest& request, Plan& plan);
void plan_figure_10(const PaperRequest& request, Plan& plan);

// 2 stands for Example 1 and its figure, 10 for figures 10 and 11.
std::vector<std::int64_t> paper_figures();

// Measures what this library has not measured before, each row in a process of its own, and writes it at once. Prints counts.
void run_paper(const PaperRequest& request);

}  // namespace bench
