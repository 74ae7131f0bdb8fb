// Contributions to a combined uncertainty, and a sentence about it.
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "request/budget/budget.h"

namespace rc::request {

std::array<Named, of::count> quantity_names(bool si, const Named& further) {
  std::array<Named, of::count> names{{{"load", "N"},
                                      {"approach", "m"},
                                      {"area", ""},
                                      {"mean_pressure", "Pa"},
                                      {"stiffness", "N/m"},
                                      {"mean_gap", "m"},
                                      {"conductance", "m"},
                                      further}};
  for (Named& each : names)
    if (!si) each.unit.clear();
  return names;
}

namespace {

// Student's factor of 95 %: the expansion of Cornish and Fisher, from 3 degrees of freedom within 2 %.
double student(double freedom) {
  constexpr double z = 1.959963984540054, z2 = z * z, z3 = z2 * z, z5 = z3 * z2, z7 = z5 * z2;
  if (!std::isfinite(freedom)) return z;
  const double n = std::max(freedom, 3.0);
  return z + (z3 + z) / (4 * n) + (5 * z5 + 16 * z3 + 3 * z) / (96 * n * n) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * n * n * n);
}

std::string shown(std::size_t quantity, const Named& named, double value, int digits) {
  if (quantity == of::area) return in_digits(100 * value, digits) + " %";
  if (named.unit.empty()) return in_digits(value, digits);
  const bool power = named.unit.find('^') != std::string::npos;  // the power of a prefix would be doubtful
  return power ? in_digits(value, digits) + " " + named.unit : with_prefix(value, named.unit.c_str(), digits);
}

// A leak is the only further quantity of which this is known.
bool never_negative(std::size_t quantity, const std::string& name) {
  return quantity != of::approach && (quantity != of::further || name == "leak");
}

std::string sentence(std::size_t quantity, const Named& named, double value, const Combined& c, const std::vector<Row>& rows,
                     const Sources& sources) {
  std::string name = named.name;
  std::ranges::replace(name, '_', ' ');
  if (std::isnan(value)) return name + " is not known";
  const std::string text = join(name, " ", shown(quantity, named, value, 4));
  if (!(c.standard > 1e-12 * std::abs(value))) return text + ": no source changes it";
  const auto share = [&](std::size_t k) { return rows[k][quantity].variance() / (c.standard * c.standard); };
  const double half = c.coverage * c.standard;
  const bool to_zero = half > value && value >= 0 && never_negative(quantity, name);
  std::string line = join(
      text, to_zero ? join(", 0 to ", shown(quantity, named, value + half, 2)) : join(" +- ", shown(quantity, named, half, 2)),
      " (95 %, k = ", in_digits(c.coverage, 3), to_zero ? "; larger than the value, so not linear" : "", "): ");
  const auto first = static_cast<std::size_t>(c.dominant);
  line += join(sources.all[first].name, " brings ", std::llround(100 * share(first)), " % of the variance");
  std::size_t second = rows.size();
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (k != first && share(k) > 0.01 && (second == rows.size() || share(k) > share(second))) second = k;
  if (second < rows.size()) line += join(", ", sources.all[second].name, " ", std::llround(100 * share(second)), " %");
  return line;
}

}  // namespace

Combined combine(std::size_t quantity, const Named& named, double value, const std::vector<Row>& rows, const Sources& sources) {
  double variance = 0, fourth = 0;
  Combined found{0, std::numeric_limits<double>::infinity(), 0, -1, ""};
  double largest = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Contribution& each = rows[k][quantity];
    variance += each.variance();
    fourth += each.variance() * each.variance() / each.freedom;
    if (each.variance() > largest) {
      largest = each.variance();
      found.dominant = static_cast<std::int64_t>(k);
    }
  }
  found.standard = std::sqrt(variance);
  if (fourth > 0) found.freedom = variance * variance / fourth;
  found.coverage = student(found.freedom);
  found.sentence = sentence(quantity, named, value, found, rows, sources);
  return found;
}

}  // namespace rc::request
