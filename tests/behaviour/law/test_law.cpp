// What a law evaluates to, its files, and what is refused.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include "patches.h"

namespace {

using namespace laws;
using pairs::check;
using pairs::check_equal;
using pairs::text;

namespace fs = std::filesystem;

const rc_law* usual_law() {
  static const LawHandle law = made(usual_patch(32));
  return law.get();
}

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {(std::istreambuf_iterator<char>(file)), {}};
}

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

// A folder of its own, which must hold nothing but the files that are named at the end.
class Folder {
 public:
  explicit Folder(const std::string& name) : path_(fs::temp_directory_path() / ("law-" + name)) {
    fs::remove_all(path_);
    fs::create_directory(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  std::string operator/(const char* name) const { return (path_ / name).string(); }
  std::size_t files() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), {})); }

 private:
  fs::path path_;
};

void refuses(rc_status status, const std::string& part, const std::string& what) {
  check_equal(status, RC_ERR_ARGUMENT, what);
  check(std::string(rc_last_error()).find(part) != std::string::npos, what + ": " + rc_last_error());
}

// Overclosures of all magnitudes of a law, and beyond it.
std::vector<double> overclosures(const rc_law* law) {
  const rc_law_info info = describe(law);
  std::vector<double> all{-1, 0, info.x_lower / 3, info.x_upper, 2 * info.x_upper};
  for (int i = 0; i <= 1000; ++i) all.push_back(info.x_lower * std::pow(info.x_upper / info.x_lower, i / 1000.0));
  return all;
}

void slope_energy_and_inverse_belong_to_the_pressure() {
  const rc_law* const law = usual_law();
  for (const double x : overclosures(law)) {
    double p = 0, slope = 0, energy = 0, back = 0, above = 0, more = 0;
    const rc_status status = rc_law_pressure(law, x, &p, &slope, &energy);
    check_equal(status, x > describe(law).x_upper ? RC_OUTSIDE : RC_OK, "status at " + text(x));
    check(rc_law_overclosure(law, p, &back) == status, "status of the inverse");
    if (x > 0 && p > 0) check(std::abs(back / x - 1) < 1e-10, "the inverse of " + text(x) + " is " + text(back));
    const double step = 1e-6 * std::abs(x) + 1e-12;
    rc_law_pressure(law, x + step, &above, nullptr, &more);
    check(std::abs((more - energy) - step * (p + above) / 2) <= 1e-6 * step * above + 1e-15 * more, "energy at " + text(x));
    check(above >= p && slope >= 0, "p falls at " + text(x));
    const rc_law_point point = evaluate(law, x);
    check(point.p == p && point.slope == slope && point.energy == energy, "rc_law_evaluate");
    check(point.p_lower <= p * (1 + 1e-14) && p <= point.p_upper * (1 + 1e-14), "p leaves its bounds at " + text(x));
    double conductance = 0;
    check(rc_law_gap_conductance(law, p, 1, 1, &conductance) >= 0, "conductance");
    if (x > 0) check(std::abs(conductance - point.conductance / 2) <= 1e-9 * conductance, "conductance at " + text(x));
  }
  std::vector<double> xs = overclosures(law), p(xs.size()), slope(xs.size()), energy(xs.size());
  check_equal(rc_law_pressures(law, static_cast<std::int64_t>(xs.size()), xs.data(), p.data(), slope.data(), energy.data()),
              RC_OUTSIDE, "n");
  for (std::size_t i = 0; i < xs.size(); ++i) check(p[i] == evaluate(law, xs[i]).p, "rc_law_pressures");
}

void nodes_are_on_the_curve_and_few() {
  const LawHandle law = made(usual_patch(64));
  const rc_law_info info = describe(law.get());
  check_equal(info.bounds, RC_LAW_CONVEX, "bounds");
  check(info.nodes <= 110, std::to_string(info.nodes) + " nodes");
  check(info.width <= 1e-3 && info.energy_error < 1e-3, "width " + text(info.width) + ", energy " + text(info.energy_error));
  rc_law_node before = RC_LAW_NODE_INIT;
  for (std::int64_t i = 0; i < info.nodes; ++i) {
    rc_law_node node = RC_LAW_NODE_INIT;
    check_equal(rc_law_describe_node(law.get(), i, &node), RC_OK, "node");
    const rc_law_point point = evaluate(law.get(), node.x);
    check(std::abs(point.p - node.p) <= 1e-12 * node.p, "p of node " + std::to_string(i));
    check(i < 1 || (point.slope >= node.slope * (1 - 1e-6) && point.slope <= node.between_upper * (1 + 1e-6)),
          "slope of node " + std::to_string(i));
    check(i == 0 || (node.x > before.x && node.p > before.p && node.slope >= before.slope * (1 - 1e-6)), "order of nodes");
    before = node;
  }
  refuses(rc_law_describe_node(law.get(), info.nodes, &before), "is none of", "a node too many");
}

void the_conductance_is_as_exact_as_asked() {
  Patch patch = usual_patch(32);
  patch.spec.tolerance_conductance = 0.01;
  const LawHandle law = made(patch);
  int wide = 0;
  for (std::int64_t i = 1; i + 1 < describe(law.get()).nodes; ++i) {
    rc_law_node node = RC_LAW_NODE_INIT, next = RC_LAW_NODE_INIT;
    rc_law_describe_node(law.get(), i, &node), rc_law_describe_node(law.get(), i + 1, &next);
    if ((node.between_upper / node.between_lower - 1) / 2 <= 0.01) continue;
    ++wide;  // a jump: enclosed by a short interval
    check(next.x - node.x <= 1e-4 * node.x, "an interval is wide and long");
  }
  pairs::report(std::to_string(describe(law.get()).nodes) + " nodes, " + std::to_string(wide) + " jumps");
}

void a_saved_law_has_the_same_bits() {
  const Folder folder("bits");
  for (const char* name : {"free, love, disc", "periodic, spectral, hardness"}) {
    std::vector<Patch> all = patches(16);
    const Patch& patch = *std::find_if(all.begin(), all.end(), [&](const Patch& each) { return each.name == name; });
    const LawHandle law = made(patch);
    const std::string path = folder / "a.law", again = folder / "b.law";
    rc_law* read = nullptr;
    check_equal(rc_law_save(law.get(), path.c_str()), RC_OK, rc_last_error());
    check_equal(rc_law_load(path.c_str(), &read), RC_OK, rc_last_error());
    const LawHandle loaded(read);
    check_equal(rc_law_save(read, again.c_str()), RC_OK, rc_last_error());
    check(content(path) == content(again), "the files differ");
    for (const double x : overclosures(law.get())) {
      const rc_law_point a = evaluate(law.get(), x), b = evaluate(read, x);
      check(std::memcmp(&a, &b, sizeof a) == 0, "other bits at " + text(x));
    }
    rc_law_info first = describe(law.get()), second = describe(read);
    check(second.seconds == 0, "a file has no seconds");
    first.seconds = 0;
    check(std::memcmp(&first, &second, sizeof first) == 0, "other infos");
  }
  check_equal(static_cast<std::int64_t>(folder.files()), 2, "files left");
}

void damaged_files_are_refused() {
  const Folder folder("damage");
  const std::string path = folder / "a.law";
  check_equal(rc_law_save(usual_law(), path.c_str()), RC_OK, rc_last_error());
  const std::string good = content(path);
  rc_law* law = nullptr;
  const auto load = [&](const std::string& bad) {
    write(path, bad);
    const rc_status status = rc_law_load(path.c_str(), &law);
    check(law == nullptr, "a law of a bad file");
    return status;
  };
  for (std::size_t at = 20; at + 30 < good.size(); at += 997) {
    std::string bad = good;
    bad[at] = bad[at] == '7' ? '8' : '7';
    refuses(load(bad), "damaged", "one digit differs");
  }
  refuses(load(good.substr(0, good.size() / 2)), "damaged", "half a file");
  refuses(load(""), "empty", "no text");
  refuses(load("hello"), "does not begin with", "another file");
  refuses(load("roughcontact-law 2\n"), "version 2", "a newer version");
  refuses(rc_law_load((folder / "none.law").c_str(), &law), "none.law: cannot be read", "no file");
  refuses(rc_law_save(usual_law(), (folder / "none/a.law").c_str()), "cannot be written", "no folder");
  refuses(rc_law_save(usual_law(), (folder / ".").c_str()), "it is a folder", "a folder");
  refuses(rc_law_load((folder / ".").c_str(), &law), "cannot be read: it is a folder", "a folder");
  check_equal(static_cast<std::int64_t>(folder.files()), 1, "files left");
}

rc_law_export_spec exported(const std::string& path, std::int32_t format, std::int64_t rows = 0, double rho = 0) {
  rc_law_export_spec spec = RC_LAW_EXPORT_SPEC_INIT;
  spec.format = format;
  spec.rows = rows;
  spec.rho1 = rho;
  check_equal(rc_law_export(usual_law(), path.c_str(), &spec), RC_OK, rc_last_error());
  return spec;
}

std::vector<std::vector<double>> rows_in(const std::string& path, const std::string& after) {
  std::istringstream file(content(path));
  std::vector<std::vector<double>> rows;
  bool in = after.empty();
  for (std::string line; std::getline(file, line);) {
    if (in && (line.empty() || line[0] == '*')) break;
    if (in) {
      rows.emplace_back();
      std::istringstream fields(line);
      for (std::string field; std::getline(fields, field, ',');) {
        check(field.size() <= 20, "a field of " + std::to_string(field.size()) + " characters");
        rows.back().push_back(std::stod(field));
      }
    }
    in = in || line.starts_with(after);
  }
  return rows;
}

void tables_hold_the_law() {
  const Folder folder("tables");
  const rc_law_info info = describe(usual_law());
  const std::string path = folder / "table";
  for (const std::int32_t format : {RC_LAW_CALCULIX, RC_LAW_ABAQUS}) {
    const rc_law_export_spec spec = exported(path, format, 100, 0.02);
    const auto rows = rows_in(path, "*SURFACE BEHAVIOR"), conductances = rows_in(path, "*GAP CONDUCTANCE");
    check_equal(static_cast<std::int64_t>(rows.size()), 100, "rows");
    check(rows[0] == std::vector<double>{0, 0}, "the first row");
    check(rows[98][1] > 0.999999 * info.x_upper && rows[99][1] > 99.9 * info.x_upper, "the last rows");
    check(spec.error > 1e-6 && spec.error < 0.02, "error " + text(spec.error));
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const rc_law_point point = evaluate(usual_law(), rows[i][1]);
      check(std::abs(rows[i][0] / point.p - 1) < 1e-9, "row " + std::to_string(i));
      check(std::abs(conductances[i][0] / (point.conductance / 0.02) - 1) < 1e-6 && conductances[i][1] == rows[i][0],
            "conductance");
    }
  }
  exported(path, RC_LAW_MOOSE, 50);
  check_equal(static_cast<std::int64_t>(rows_in(path, "").size()), 50, "rows for MOOSE");
  exported(path, RC_LAW_CSV, 20);
  check_equal(static_cast<std::int64_t>(rows_in(path, "overclosure,").size()), 20, "rows of CSV");
  rc_law_export_spec spec = RC_LAW_EXPORT_SPEC_INIT;
  spec.format = RC_LAW_MOOSE;
  spec.length = 1e3, spec.force = 10;
  check_equal(rc_law_export(usual_law(), path.c_str(), &spec), RC_OK, rc_last_error());
  const auto rows = rows_in(path, "");
  check(std::abs(rows[198][0] / (1e3 * info.x_upper) - 1) < 1e-9 && std::abs(rows[198][1] / (1e-5 * info.p_upper) - 1) < 1e-9,
        "units");

  const std::string before = content(path);
  const auto refused = [&](const std::string& part, auto change) {
    rc_law_export_spec bad = RC_LAW_EXPORT_SPEC_INIT;
    bad.format = RC_LAW_CALCULIX;
    change(bad);
    refuses(rc_law_export(usual_law(), path.c_str(), &bad), part, part);
  };
  refused("format", [](rc_law_export_spec& bad) { bad.format = 9; });
  refused("rows", [](rc_law_export_spec& bad) { bad.rows = 201; });
  refused("rho1", [](rc_law_export_spec& bad) { bad.rho1 = -1; });
  refused("length", [](rc_law_export_spec& bad) { bad.length = -1; });
  refused("beyond double precision", [](rc_law_export_spec& bad) { bad.force = 1e308, bad.length = 1e-6; });
  refused("nearer than 1e-10", [](rc_law_export_spec& bad) { bad.length = 1e-8; });
  refused("rc_law_export_spec.beyond", [](rc_law_export_spec& bad) { bad.beyond = 0.5; });
  refused("beyond double precision", [](rc_law_export_spec& bad) { bad.beyond = 1e308, bad.length = 1e6; });
  check(content(path) == before && folder.files() == 1, "a refused export leaves the file as it was");
}

// Runs a program that has table.c and the numbers, and not the library; its output.
std::istringstream said_alone(const Folder& folder, const std::string& table, const std::vector<double>& xs) {
  std::ostringstream command;
  command.precision(17);
  command << RC_LAW_ALONE << ' ' << table;
  for (const double x : xs) command << ' ' << x;
  const std::string out = folder / "out";
  check_equal(std::system((command.str() + " > " + out).c_str()), 0, "the program");
  return std::istringstream(content(out));
}

void the_evaluation_stands_alone() {
  const Folder folder("alone");
  const std::string table = folder / "numbers";
  exported(table, RC_LAW_TABLE);
  std::vector<double> xs = overclosures(usual_law());
  xs.resize(200);
  std::istringstream lines = said_alone(folder, table, xs);
  for (const double x : xs) {
    double p = 0, slope = 0, energy = 0, back = 0, own = 0;
    lines >> p >> slope >> energy >> back;
    const rc_law_point point = evaluate(usual_law(), x);
    rc_law_overclosure(usual_law(), point.p, &own);
    check(p == point.p && slope == point.slope && energy == point.energy && back == own, "other bits at " + text(x));
  }
}

// Squares of its slopes are beyond double precision.
void slopes_may_be_large_and_small() {
  const Folder folder("slopes");
  const std::string table = folder / "numbers";
  exported(table, RC_LAW_TABLE);
  std::vector<double> numbers, xs = overclosures(usual_law());
  xs.resize(200);
  std::istringstream text_of_table(content(table));
  for (double number = 0; text_of_table >> number;) numbers.push_back(number);
  numbers.erase(numbers.begin());
  const auto pieces = static_cast<std::size_t>(numbers[1]);
  for (const double factor : {1e200, 1e-200}) {
    std::ostringstream scaled;
    scaled.precision(17);
    scaled << numbers.size();
    for (std::size_t i = 0; i < numbers.size(); ++i)
      scaled << '\n' << (i < 8 || i >= 8 + 5 * pieces || (i - 8) % 5 == 0 ? 1 : factor) * numbers[i];
    write(table, scaled.str());
    std::istringstream lines = said_alone(folder, table, xs);
    for (const double x : xs) {
      std::string p, slope, energy, back;
      lines >> p >> slope >> energy >> back;
      check(x <= 0 || std::abs(std::stod(back) / x - 1) < 1e-9, "the inverse of " + text(x) + " is " + back + " at p = " + p);
    }
  }
}

// A constant added to the gap changes nothing but round-off.
void the_datum_does_not_matter() {
  for (const double datum : {-2.0, 0.5}) {
    Patch patch = usual_patch(16);
    const LawHandle law = made(patch);
    for (double& gap : patch.problem.gap) gap += datum;
    const LawHandle moved = made(patch);
    const rc_law_info info = describe(law.get()), other = describe(moved.get());
    check(std::abs(other.mean_gap / info.mean_gap - 1) < 1e-9 && other.bounds == info.bounds, "infos");
    for (const double share : {0.01, 0.1, 0.5, 1.0}) {
      const rc_law_point a = evaluate(law.get(), share * info.x_upper), b = evaluate(moved.get(), share * info.x_upper);
      check(std::abs(b.p / a.p - 1) < 2e-3 && b.p_lower <= a.p_upper && a.p_lower <= b.p_upper, "p at " + text(a.x));
    }
  }
}

void no_bound_is_beyond_the_hardness() {
  std::vector<Patch> all = patches(16);
  for (const Patch& patch : all) {
    if (!(patch.problem.system.hardness > 0)) continue;
    const LawHandle law = made(patch);
    const rc_law_point point = evaluate(law.get(), 1e6 * describe(law.get()).x_upper);
    check(point.p_lower <= patch.problem.system.hardness, patch.name + ": " + text(point.p_lower));
  }
}

void bad_input_is_refused() {
  const auto refused = [](rc_status status, const std::string& part, auto change) {
    Patch patch = usual_patch(16);
    change(patch);
    const MadeLaw result = make(patch);
    check_equal(result.status, status, part);
    check(!result.law && result.message.find(part) != std::string::npos, result.message);
  };
  const auto bad = RC_ERR_ARGUMENT;
  refused(bad, "p_lower", [](Patch& patch) { patch.spec.p_lower = 0; });
  refused(bad, "p_upper", [](Patch& patch) { patch.spec.p_upper = patch.spec.p_lower; });
  refused(bad, "p_upper", [](Patch& patch) { patch.spec.p_upper = std::numeric_limits<double>::infinity(); });
  refused(bad, "double precision", [](Patch& patch) { patch.spec.tolerance = 1e-9; });
  refused(bad, "tolerance_conductance", [](Patch& patch) { patch.spec.tolerance_conductance = 1e-6; });
  refused(bad, "rc_law_spec.bulk", [](Patch& patch) { patch.spec.bulk = 7; });
  refused(bad, "bulk_stiffness", [](Patch& patch) { patch.spec.bulk = RC_LAW_BULK_GIVEN; });
  refused(bad, "max_nodes", [](Patch& patch) { patch.spec.max_nodes = 2; });
  refused(bad, "area", [](Patch& patch) { patch.spec.area = -1; });
  refused(bad, "smaller than the points", [](Patch& patch) { patch.spec.area = 1e-3; });
  refused(RC_ERR_INCOMPATIBLE, "RC_LAW_BULK_MEAN", [](Patch& patch) { patch.spec.bulk = RC_LAW_BULK_MEAN; });
  refused(bad, "not finite", [](Patch& patch) { patch.problem.gap[3] = std::nan(""); });
  refused(RC_ERR_INFEASIBLE, "is closed", [](Patch& patch) { patch.spec.p_upper = 1000; });
  refused(RC_ERR_INFEASIBLE, "hardness", [](Patch& patch) { patch.problem.system.hardness = 0.001; });

  Patch few = usual_patch(16);
  few.spec.max_nodes = 10;
  const MadeLaw stopped = make(few);
  check_equal(stopped.status, RC_STOP_MAX_ITER, stopped.message);
  check(stopped.law && describe(stopped.law.get()).nodes <= 10, "the law made so far");

  double value = 0;
  refuses(rc_law_pressure(usual_law(), std::nan(""), &value, nullptr, nullptr), "NaN", "NaN");
  refuses(rc_law_pressure(nullptr, 1, &value, nullptr, nullptr), "null", "no law");
  refuses(rc_law_overclosure(usual_law(), std::nan(""), &value), "NaN", "NaN");
  refuses(rc_law_gap_conductance(usual_law(), 1, 0, 0, &value), "rho1", "no resistivity");
  const double infinity = std::numeric_limits<double>::infinity();
  refuses(rc_law_pressure(usual_law(), infinity, &value, nullptr, nullptr), "infinite", "infinity");
  refuses(rc_law_overclosure(usual_law(), infinity, &value), "infinite", "infinity");
  refuses(rc_law_gap_conductance(usual_law(), infinity, 1, 1, &value), "infinite", "infinity");
  check_equal(rc_law_pressures(usual_law(), 0, nullptr, nullptr, nullptr, nullptr), RC_OK, "no overclosure");
  rc_law_point point = RC_LAW_POINT_INIT;
  refuses(rc_law_evaluate(usual_law(), infinity, &point), "not finite", "infinity");
  refuses(rc_law_evaluate(usual_law(), std::nan(""), &point), "not finite", "NaN");
  point.struct_size = 8;
  refuses(rc_law_evaluate(usual_law(), 1, &point), "struct_size", "a small struct");
}

void a_name_stands_for_one_law() {
  const Folder folder("names");
  const std::string path = folder / "steel.law";
  check_equal(rc_law_save(usual_law(), path.c_str()), RC_OK, rc_last_error());
  const rc_law *first = nullptr, *second = nullptr;
  refuses(rc_law_open("steel of the test", nullptr, &first), "steel of the test.law: cannot be read", "no file");
  check_equal(rc_law_open("steel of the test", path.c_str(), &first), RC_OK, rc_last_error());
  check_equal(rc_law_open("steel of the test", nullptr, &second), RC_OK, rc_last_error());
  check(first == second && first != nullptr, "two laws of one name");
  refuses(rc_law_open("", nullptr, &first), "name", "no name");
}

}  // namespace

int main(int argc, char** argv) {
  return pairs::run_group("law",
                          {{"slope, energy and inverse belong to the pressure", slope_energy_and_inverse_belong_to_the_pressure},
                           {"nodes are on the curve and few", nodes_are_on_the_curve_and_few},
                           {"the conductance is as exact as asked", the_conductance_is_as_exact_as_asked},
                           {"a saved law has the same bits", a_saved_law_has_the_same_bits},
                           {"damaged files are refused", damaged_files_are_refused},
                           {"tables hold the law", tables_hold_the_law},
                           {"the evaluation stands alone", the_evaluation_stands_alone},
                           {"slopes may be large and small", slopes_may_be_large_and_small},
                           {"the datum does not matter", the_datum_does_not_matter},
                           {"no bound is beyond the hardness", no_bound_is_beyond_the_hardness},
                           {"bad input is refused", bad_input_is_refused},
                           {"a name stands for one law", a_name_stands_for_one_law}},
                          argc, argv);
}
