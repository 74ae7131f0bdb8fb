// Named figures, written to a file or compared with those of a file.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

namespace mutants {

class Figures {
 public:
  // wanted: names of the figures to compute; empty: all.
  explicit Figures(std::set<std::string> wanted) : wanted_(std::move(wanted)) {}
  // Whether a section that begins with this is wanted; the others need not be computed.
  bool wants(const std::string& section) const {
    const auto found = wanted_.lower_bound(section);
    return wanted_.empty() || (found != wanted_.end() && found->starts_with(section));
  }
  void section(const std::string& name) { section_ = name; }
  // Equal but for the last digit.
  void exact(const std::string& name, double value) { put(name, value, 'e'); }
  // Equal to eight digits, for figures that depend on another library's sums.
  void near(const std::string& name, double value) { put(name, value, 'n'); }

  // Writes the values of the figures that the file lists, or all figures.
  void write(const std::string& file, bool all) const;
  // The number of figures of the file that differ. Prints them, or a letter for each figure of the file.
  int compare(const std::string& file, bool each) const;

 private:
  struct Figure {
    std::size_t place;
    double value;
    char kind;
  };
  void put(const std::string& name, double value, char kind);

  std::string section_;
  std::set<std::string> wanted_;
  std::unordered_map<std::string, Figure> all_;
  std::unordered_map<std::string, int> times_;
};

void figures_of_bounds(Figures& figures);
void figures_of_certificates(Figures& figures);
void figures_of_spectra(Figures& figures);
void figures_of_marks(Figures& figures);
void figures_of_results(Figures& figures);
void figures_of_hardness(Figures& figures);
void figures_of_capped_results(Figures& figures);

}  // namespace mutants
