// Named figures, written to a file in full or compared with those of a file.
#pragma once

#include <string>
#include <vector>

namespace mutants {

class Figures {
 public:
  void section(const std::string& name) { section_ = name; }
  // Equal but for the last digit.
  void exact(const std::string& name, double value) { put(name, value, 'e'); }
  // Equal to eight digits, for figures that depend on another library's sums.
  void near(const std::string& name, double value) { put(name, value, 'n'); }

  void write(const std::string& file) const;
  // Prints the figures that differ, and returns their number.
  int compare(const std::string& file) const;

 private:
  struct Figure {
    std::string section, name;
    double value;
    char kind;
  };
  void put(const std::string& name, double value, char kind) { all_.push_back({section_, name, value, kind}); }

  std::string section_;
  std::vector<Figure> all_;
};

void figures_of_bounds(Figures& figures);
void figures_of_certificates(Figures& figures);
void figures_of_spectra(Figures& figures);
void figures_of_marks(Figures& figures);
void figures_of_results(Figures& figures);
void figures_of_hardness(Figures& figures);
void figures_of_capped_results(Figures& figures);

}  // namespace mutants
