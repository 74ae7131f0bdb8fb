// Figures of the certificate and of the bounds on small problems, to the last digits: figures.txt lists those that notice every
// change of an operator, chosen by `scripts/mutants.py build-mutants --cover`. `--write FILE` renews their values after a change
// that is meant to alter them. That such figures are right is tested in tests/behaviour/bounds.
#include "known_answers.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace mutants {

namespace {

bool equal(double a, double b, char kind) {
  if (std::isnan(a) || std::isnan(b) || std::isinf(a) || std::isinf(b)) return (std::isnan(a) && std::isnan(b)) || a == b;
  const double allowed = kind == 'e' ? std::numeric_limits<double>::epsilon() : 1e-8;
  return std::abs(a - b) <= allowed * std::abs(b);
}

// As short as it can be read back.
std::string text(double value, char kind) {
  char written[40];
  const auto end = kind == 'e' ? std::to_chars(written, written + sizeof written, value)
                               : std::to_chars(written, written + sizeof written, value, std::chars_format::general, 10);
  return {written, end.ptr};
}

// Names and values of a file, a line each.
std::vector<std::pair<std::string, double>> listed(const std::string& file) {
  std::vector<std::pair<std::string, double>> all;
  std::ifstream in(file);
  for (std::string section, name, value; in >> section >> name >> value;)
    all.emplace_back(section + ' ' + name, std::strtod(value.c_str(), nullptr));
  return all;
}

}  // namespace

// A name that occurs again has the number of its occurrence.
void Figures::put(const std::string& name, double value, char kind) {
  std::string full = section_ + ' ' + name;
  if (const int before = times_[full]++; before > 0) full += '#' + std::to_string(before + 1);
  all_.insert_or_assign(full, Figure{all_.size(), value, kind});
}

void Figures::write(const std::string& file, bool all) const {
  std::vector<std::pair<std::string, double>> wanted = listed(file);
  if (all) {
    wanted.resize(all_.size());
    for (const auto& [name, figure] : all_) wanted[figure.place].first = name;
  }
  std::ofstream out(file);
  for (const auto& [name, before] : wanted)
    if (const auto found = all_.find(name); found != all_.end())
      out << name << ' ' << text(found->second.value, found->second.kind) << '\n';
}

int Figures::compare(const std::string& file, bool each) const {
  int different = 0;
  for (const auto& [name, value] : listed(file)) {
    const auto found = all_.find(name);
    const bool same = found != all_.end() && equal(found->second.value, value, found->second.kind);
    if (each) std::putchar(same ? '.' : 'x');
    if (!same && !each && different < 20)
      std::fprintf(stderr, "%s = %s instead of %s\n", name.c_str(),
                   found == all_.end() ? "nothing" : text(found->second.value, 'e').c_str(), text(value, 'e').c_str());
    different += !same;
  }
  return different;
}

}  // namespace mutants

int main(int argc, char** argv) {
  using namespace mutants;
  const std::string_view option = argc == 3 ? argv[1] : "";
  if (argc != 2 && option != "--write" && option != "--write-all" && option != "--each") {
    std::fprintf(stderr,
                 "usage: %s [--write|--write-all|--each] FILE\n--write: the values of the figures that FILE lists; "
                 "--write-all: every figure; --each: a letter for each line of FILE, x if its value is another\n",
                 argv[0]);
    return 2;
  }
  std::set<std::string> wanted;
  if (option != "--write-all")
    for (const auto& [name, value] : listed(argv[argc - 1])) wanted.insert(name);
  Figures figures(std::move(wanted));
  figures_of_certificates(figures);
  figures_of_spectra(figures);
  figures_of_marks(figures);
  figures_of_bounds(figures);
  figures_of_results(figures);
  figures_of_hardness(figures);
  figures_of_capped_results(figures);
  if (option.starts_with("--write")) {
    figures.write(argv[2], option == "--write-all");
    return 0;
  }
  return figures.compare(argv[argc - 1], option == "--each") == 0 ? 0 : 1;
}
