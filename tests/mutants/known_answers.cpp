// Figures of the certificate and of the bounds on small problems, to the last digits. `--write FILE` writes them after a change
// that is meant to alter them. That such figures are right is tested in tests/behaviour/bounds.
#include "known_answers.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

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

}  // namespace

// A line for each section: its name and its values in order.
void Figures::write(const std::string& file) const {
  std::ofstream out(file);
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const bool first = i == 0 || all_[i].section != all_[i - 1].section;
    out << (first ? (i == 0 ? "" : "\n") + all_[i].section : "") << ' ' << text(all_[i].value, all_[i].kind);
  }
  out << '\n';
}

int Figures::compare(const std::string& file) const {
  std::ifstream in(file);
  int different = 0;
  std::string word;
  for (std::size_t i = 0; i < all_.size() && different < 20; ++i) {
    const Figure& each = all_[i];
    if (i == 0 || each.section != all_[i - 1].section) {
      in >> word;
      if (word != each.section)
        std::fprintf(stderr, "section %s instead of %s\n", each.section.c_str(), word.c_str()), ++different;
    }
    in >> word;
    if (equal(each.value, std::strtod(word.c_str(), nullptr), each.kind)) continue;
    std::fprintf(stderr, "%s %s = %s instead of %s\n", each.section.c_str(), each.name.c_str(), text(each.value, 'e').c_str(),
                 word.c_str());
    ++different;
  }
  if (different == 0 && in >> word) {
    std::fprintf(stderr, "%s is missing\n", word.c_str());
    ++different;
  }
  return different;
}

}  // namespace mutants

int main(int argc, char** argv) {
  using namespace mutants;
  if (argc != 2 && !(argc == 3 && std::string_view(argv[1]) == "--write")) {
    std::fprintf(stderr, "usage: %s [--write] FILE\n", argv[0]);
    return 2;
  }
  Figures figures;
  figures_of_certificates(figures);
  figures_of_spectra(figures);
  figures_of_marks(figures);
  figures_of_bounds(figures);
  figures_of_results(figures);
  figures_of_hardness(figures);
  figures_of_capped_results(figures);
  if (argc == 3) {
    figures.write(argv[2]);
    return 0;
  }
  return figures.compare(argv[1]) == 0 ? 0 : 1;
}
