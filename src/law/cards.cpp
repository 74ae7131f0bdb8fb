#include "law/cards.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

#include "core/error.h"
#include "law/slip.h"
#include "law/table.h"

namespace rc {

namespace {

constexpr std::int64_t usual_rows = 200, most_rows = 1'000'000, most_rows_of_calculix = 200;
constexpr double least_step_of_calculix = 1e-10;  // it moves rows apart that are nearer, in any unit

struct LawRow {
  double x, p, slope, energy;
};

LawRow row_at(const Law& law, double x) {
  LawRow row{x, 0, 0, 0};
  roughcontact_law_pressure(law.table.data(), x, &row.p, &row.slope, &row.energy);
  return row;
}

// 12 decimals: at most 20 characters, whatever the exponent.
std::string card_number(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, std::end(digits), value, std::chars_format::scientific, 12).ptr};
}

class Units {
 public:
  Units(double length, double force) : length_(length), pressure_(force / length / length) {}

  double x(const LawRow& row) const { return fits(row.x, length_); }
  double p(double pressure) const { return fits(pressure, pressure_); }
  double slope(const LawRow& row) const { return fits(row.slope, pressure_ / length_); }
  double energy(const LawRow& row) const { return fits(row.energy, pressure_ * length_); }
  double per_length(double value) const { return fits(value, 1 / length_); }

 private:
  static double fits(double value, double unit) {
    const double result = value * unit;
    if (!std::isfinite(result) || (value != 0 && std::abs(result) < 1e-290))
      fail(RC_ERR_ARGUMENT, "in these units a number is beyond double precision: ", value, " * ", unit,
           "; choose other rc_law_export_spec.length and force, or a smaller beyond");
    return result;
  }

  double length_, pressure_;
};

void check_export(const Law& law, const rc_law_export_spec& spec) {
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  if (spec.format < RC_LAW_CSV || spec.format > RC_LAW_TABLE)
    fail(RC_ERR_ARGUMENT, "rc_law_export_spec.format = ", spec.format, " is none of RC_LAW_CSV (1) .. RC_LAW_TABLE (5)");
  const std::int64_t most = spec.format == RC_LAW_CALCULIX ? most_rows_of_calculix : most_rows;
  if (spec.rows < 5 || spec.rows > most) fail(RC_ERR_ARGUMENT, "rc_law_export_spec.rows = ", spec.rows, " must be 5 .. ", most);
  if (!(spec.rho1 >= 0 && spec.rho2 >= 0 && std::isfinite(spec.rho1 + spec.rho2)))
    fail(RC_ERR_ARGUMENT, "rc_law_export_spec.rho1 = ", spec.rho1, ", rho2 = ", spec.rho2, " must be >= 0 and finite");
  if (!positive(spec.length) || !positive(spec.force))
    fail(RC_ERR_ARGUMENT, "rc_law_export_spec.length = ", spec.length, ", force = ", spec.force, " must be positive and finite");
  if (!(spec.beyond >= 1 && std::isfinite(spec.beyond)))
    fail(RC_ERR_ARGUMENT, "rc_law_export_spec.beyond = ", spec.beyond, " must be 1 or more, and finite");
  check_friction(spec.mu, spec.nu, "rc_law_export_spec");
  if (spec.mu > 0) check_slips(law);
  if (spec.mu > 0 && (spec.format == RC_LAW_MOOSE || spec.format == RC_LAW_TABLE))
    fail(RC_ERR_ARGUMENT, "rc_law_export_spec.mu = ", spec.mu, ": this format has no friction");
  if (spec.rho1 + spec.rho2 > 0 && !(law.info.modulus > 0))
    fail(RC_ERR_ARGUMENT, "rc_law_export_spec.rho1 = ", spec.rho1, ", rho2 = ", spec.rho2, ": ", no_conductance);
}

// The origin, then rows in equal ratios from the first node to the last.
std::vector<LawRow> rows_of(const Law& law, std::int64_t count) {
  std::vector<LawRow> rows{{0, 0, 0, 0}};
  const double lower = law.info.x_lower, upper = law.info.x_upper;
  const double ratio = std::log(upper / lower) / static_cast<double>(count - 2);
  for (std::int64_t i = 0; i < count - 1; ++i)
    rows.push_back(row_at(law, i == count - 2 ? upper : std::min(upper, lower * std::exp(ratio * static_cast<double>(i)))));
  return rows;
}

// The largest distance of the line a + b t from the parabola 1 + s t + q t^2, over the latter, for t from 0 to 1. The derivative
// of their ratio is 0 where b q t^2 + 2 a q t + a s - b is.
double largest_distance(double a, double b, double s, double q) {
  const auto distance = [&](double t) { return std::abs((a + b * t) / (1 + t * (s + t * q)) - 1); };
  double most = std::max(distance(0), distance(1));
  const double square = a * q * a * q - b * q * (a * s - b);
  if (!(square >= 0)) return most;
  const double root = -(a * q + std::copysign(std::sqrt(square), a * q));
  for (const double t : {root / (b * q), (a * s - b) / root})
    if (t > 0 && t < 1) most = std::max(most, distance(t));
  return most;
}

// The largest distance from the first row after the origin on.
double distance_of_lines(const Law& law, const std::vector<LawRow>& rows) {
  double most = 0;
  const law_table_piece *piece = law_pieces(law.table.data()), *const last = law_last_piece(law.table.data());
  for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
    const double rise = (rows[i + 1].p - rows[i].p) / (rows[i + 1].x - rows[i].x);
    for (double x = rows[i].x; x < rows[i + 1].x;) {
      while (piece < last && piece[1].x <= x) ++piece;
      const double end = piece < last ? std::min(rows[i + 1].x, piece[1].x) : rows[i + 1].x;
      const LawRow at = row_at(law, x);
      const double length = end - x, line = rows[i].p + (x - rows[i].x) * rise;
      most = std::max(most, largest_distance(line / at.p, rise * length / at.p, at.slope * length / at.p,
                                             piece->half_bend * length / at.p * length));
      x = end;
    }
  }
  return most;
}

// Written with 12 decimals, no two rows may have the same overclosure.
void check_ascending(const Law& law, const std::vector<LawRow>& rows, const Units& units) {
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (card_number(units.x(rows[i])) == card_number(units.x(rows[i - 1])))
      fail(RC_ERR_ARGUMENT, "two of ", rows.size(), " rows would have the overclosure ", card_number(units.x(rows[i])),
           ": the law, x = ", rows[1].x, " to ", law.info.x_upper, ", is too short for so many; lower rc_law_export_spec.rows");
}

std::string joined_line(const std::vector<double>& values) {
  std::string line;
  for (const double value : values) {
    if (!line.empty()) line += ',';
    line += card_number(value);
  }
  line += '\n';
  return line;
}

// The stiffness per area at the start of slip, over dp/dx.
double stick(const rc_law_export_spec& spec) { return (2 - 2 * spec.nu) / (2 - spec.nu); }

std::string columns(const Law& law, const std::vector<LawRow>& rows, const Units& units, const rc_law_export_spec& spec) {
  const double resistivity = spec.rho1 + spec.rho2;
  std::string text = "overclosure,pressure,slope,energy,area_fraction,conductance,pressure_lower,pressure_upper";
  text += spec.mu > 0 ? ",shear_stiffness,sliding_shear,sliding_slip\n" : "\n";
  for (const LawRow& row : rows) {
    roughcontact_law_bounds bounds{};
    if (row.x > 0) roughcontact_law_bounds_at(law.table.data(), row.x, row.p, &bounds);
    const double unit = law.conductance();  // NaN: none
    const double conductance = std::isnan(unit) ? unit : units.per_length(unit * row.slope) / (resistivity > 0 ? resistivity : 1);
    const double upper = bounds.p_upper;  // infinite beyond the last node
    std::vector<double> line{
        units.x(row), units.p(row.p), units.slope(row),        units.energy(row),
        bounds.area,  conductance,    units.p(bounds.p_lower), std::isfinite(upper) ? units.p(upper) : upper};
    if (spec.mu > 0)
      for (const double more : {stick(spec) * units.slope(row), spec.mu * units.p(row.p), spec.mu / stick(spec) * units.x(row)})
        line.push_back(more);
    text += joined_line(line);
  }
  return text;
}

// Both programs have one number for all pressures. The law's stiffness grows with the pressure, its elastic slip far less.
std::string friction_card(const Law& law, const Units& units, const rc_law_export_spec& spec) {
  const auto elastic_slip = [&](double p, double* stiffness) {
    double x = 0;
    roughcontact_law_overclosure(law.table.data(), p, &x);
    const LawRow row = row_at(law, x);
    *stiffness = stick(spec) * units.slope(row);
    return spec.mu * units.p(p) / *stiffness;
  };
  double stiffness = 0;
  const double least = elastic_slip(law.info.p_lower, &stiffness), most = elastic_slip(law.info.p_upper, &stiffness),
               middle = std::sqrt(law.info.p_lower) * std::sqrt(law.info.p_upper), slip = elastic_slip(middle, &stiffness);
  const std::string text = join("** friction: at the pressure ", card_number(units.p(middle)), "; the law has elastic slips of ",
                                in_digits(least, 3), " at its lowest and ", in_digits(most, 3), " at its highest\n");
  if (spec.format == RC_LAW_ABAQUS) return text + "*FRICTION, ELASTIC SLIP=" + card_number(slip) + '\n' + joined_line({spec.mu});
  return text + "*FRICTION\n" + joined_line({spec.mu, stiffness});
}

std::string pressure_cards(const Law& law, const std::vector<LawRow>& rows, const Units& units, const rc_law_export_spec& spec) {
  const char* const proof = law.info.bounds == RC_LAW_MONOTONE ? "estimated" : "contact sets assumed to be nested";
  std::string text =
      join("** roughcontact: ", rows.size(), " rows; straight lines between them are within ", in_digits(spec.error, 2),
           " of the law\n** from the second row on, below it the table is a line from the ",
           "origin; bounds of the patch within ", in_digits(law.info.width, 2), " (", proof, ")\n");
  text += "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n";
  for (const LawRow& row : rows) text += joined_line({units.p(row.p), units.x(row)});
  if (spec.mu > 0) text += friction_card(law, units, spec);
  if (!(spec.rho1 + spec.rho2 > 0)) return text;
  text += spec.format == RC_LAW_ABAQUS ? "*GAP CONDUCTANCE, PRESSURE\n" : "*GAP CONDUCTANCE\n";
  for (std::size_t i = 0; i < rows.size(); ++i)  // one row for each pressure
    if (i == 0 || card_number(units.p(rows[i].p)) != card_number(units.p(rows[i - 1].p)))
      text += joined_line({units.per_length(law.conductance() * rows[i].slope) / (spec.rho1 + spec.rho2), units.p(rows[i].p)});
  return text;
}

std::string whole_table(const Law& law) {
  std::string text = join(law.table.size(), '\n');
  for (const double number : law.table) text += exact(number) + '\n';
  return text;
}

}  // namespace

std::string cards_of(const Law& law, rc_law_export_spec& spec) {
  if (spec.rows == 0) spec.rows = usual_rows;
  if (spec.length == 0) spec.length = 1;
  if (spec.force == 0) spec.force = 1;
  if (spec.beyond == 0) spec.beyond = 100;
  check_export(law, spec);
  spec.error = 0;
  if (spec.format == RC_LAW_TABLE) return whole_table(law);
  const bool more = spec.format != RC_LAW_CSV && spec.beyond > 1;
  std::vector<LawRow> rows = rows_of(law, spec.rows - (more ? 1 : 0));
  spec.error = distance_of_lines(law, rows);
  if (more) rows.push_back(row_at(law, spec.beyond * law.info.x_upper));
  const Units units(spec.length, spec.force);
  check_ascending(law, rows, units);
  if (spec.format == RC_LAW_CSV) return columns(law, rows, units, spec);
  if (spec.format == RC_LAW_CALCULIX && (rows[2].x - rows[1].x) * spec.length < least_step_of_calculix)
    fail(RC_ERR_ARGUMENT, "rows are ", (rows[2].x - rows[1].x) * spec.length,
         " apart, and CalculiX changes overclosures that are nearer than 1e-10: choose a smaller unit of length, or fewer rows");
  if (spec.format != RC_LAW_MOOSE) return pressure_cards(law, rows, units, spec);
  std::string text;
  for (const LawRow& row : rows) text += joined_line({units.x(row), units.p(row.p)});
  return text;
}

}  // namespace rc
