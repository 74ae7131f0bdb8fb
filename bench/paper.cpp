#include "paper.h"

#include <algorithm>
#include <iostream>

#include "format.h"
#include "progress.h"
#include "provenance.h"
#include "result_file.h"

namespace bench {

namespace {

struct Part {
  std::int64_t figure;
  void (*plan)(const PaperRequest&, Plan&);
};
// The longest last.
constexpr Part parts[] = {{2, plan_example_1}, {4, plan_algorithm_2}, {10, plan_figure_10}, {5, plan_figure_5},
                          {9, plan_figure_9},  {8, plan_figure_8},    {6, plan_figure_6},   {4, plan_figure_4}};

std::string name_of(const Measurement& measurement) {
  std::string name = measurement.list;
  for (const auto& [key, value] : measurement.key.items())
    name += ", " + key + " " + (value.is_string() ? value.get<std::string>() : value.dump());
  return name;
}

bool known(ResultFile& file, const Measurement& measurement, const std::string& library) {
  Json key = measurement.key;
  key["library"] = library;
  const Json* const row = file.find(measurement.list.c_str(), key);
  return row && !row->contains("error");
}

}  // namespace

std::vector<std::int64_t> paper_figures() {
  std::vector<std::int64_t> figures;
  for (const Part& part : parts) figures.push_back(part.figure);
  std::sort(figures.begin(), figures.end());
  figures.erase(std::unique(figures.begin(), figures.end()), figures.end());
  return figures;
}

void run_paper(const PaperRequest& request) {
  Plan plan;
  for (const Part& part : parts)
    if (request.figures.empty() || std::count(request.figures.begin(), request.figures.end(), part.figure) > 0)
      part.plan(request, plan);
  ResultFile file(request.file, "paper", request.threads);
  const std::string library = library_hash();
  file.document()["quick"] = request.quick;
  const auto first_open = std::stable_partition(
      plan.begin(), plan.end(), [&](const Measurement& measurement) { return known(file, measurement, library); });
  double cost = 0;
  for (auto open = first_open; open != plan.end(); ++open) cost += open->cost;

  Progress progress(cost);
  std::size_t failed = 0;
  for (auto open = first_open; open != plan.end(); ++open) {
    progress.begin(name_of(*open));
    Json row = open->key;
    row["library"] = library;
    row.update(in_child(open->measure));
    if (row.contains("error")) {
      ++failed;
      progress.say(name_of(*open) + ": " + row.at("error").get<std::string>());
    }
    file.put(open->list.c_str(), open->key, row);
    progress.done(open->cost);
  }
  std::cout << formatted("%td measured, %zu of them failed; %td measured before\n", plan.end() - first_open, failed,
                         first_open - plan.begin());
}

}  // namespace bench
