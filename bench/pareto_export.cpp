#include "pareto_export.h"

#include <filesystem>
#include <fstream>
#include <memory>

#include "format.h"
#include "npy_writer.h"

namespace bench {

namespace {

constexpr const char* point_columns[] = {
    "tol",         "status",         "chosen",          "setup_seconds",   "solve_seconds",
    "cpu_seconds", "memory_bytes",   "products",        "residual",        "load_error",
    "area_error",  "pressure_error", "true_load_error", "true_area_error", "true_pressure_error"};

std::string cell(const Json& value) {
  if (value.is_null()) return "";
  if (!value.is_string()) return value.dump();
  const std::string text = value;
  return text.find(',') == std::string::npos ? text : '"' + text + '"';
}

void write_lines(std::ofstream& out, const Json& rows) {
  for (const Json& row : rows) {
    const std::string grid = row.at(row.contains("grid") ? "grid" : "n").dump();
    std::string head;
    for (const char* const key : {"scene", "contact"}) head += cell(row.at(key)) + ',';
    head += grid + ',';
    for (const char* const key : {"solver", "backend", "variant", "kernel"})
      head += (row.contains(key) ? cell(row.at(key)) : "auto") + ',';
    for (const Json& point : row.at("points")) {
      out << head;
      for (const char* const key : point_columns)
        out << (key == point_columns[0] ? "" : ",") << (point.contains(key) ? cell(point.at(key)) : "");
      out << '\n';
    }
  }
}

}  // namespace

std::string ParetoExports::write(const std::string& name, const Field& field, std::int64_t n) const {
  const std::string path = folder_ + "/" + name + ".npy";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(path.c_str(), "wb"), std::fclose);
  if (!out) throw Failure("cannot write " + path);
  cli::write_npy(out.get(), field, n, n);
  return path;
}

void ParetoExports::add(const ParetoCase& of, const Truth& truth) {
  std::filesystem::create_directories(folder_);
  const ParetoScene& scene = of.scene;
  const std::string name = formatted("%s-%g", scene.name.c_str(), 100 * of.contact);
  list_.push_back({{"scene", scene.name},
                   {"contact", of.contact},
                   {"n", scene.n},
                   {"load", truth.load},
                   {"area", truth.area},
                   {"gap", write(name + "-gap", scene.gap(scene.n), scene.n)},
                   {"pressure", write(name + "-pressure", truth.pressure, scene.n)}});
}

void ParetoExports::write_list() const {
  std::filesystem::create_directories(folder_);
  const std::string path = folder_ + "/scenes.json";
  std::ofstream out(path);
  out << list_.dump(1) << '\n';
  if (!out.flush()) throw Failure("cannot write " + path);
}

void write_pareto_csv(const Json& document, const std::string& file) {
  std::ofstream out(file);
  out << "scene,contact,grid,solver,backend,variant,kernel";
  for (const char* const key : point_columns) out << ',' << key;
  out << '\n';
  for (const char* const list : {"methods", "grids"})
    if (document.contains(list)) write_lines(out, document.at(list));
  if (!out.flush()) throw Failure("cannot write " + file);
}

}  // namespace bench
