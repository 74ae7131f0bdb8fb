// The files of laws, and tables for other programs.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <random>
#include <sstream>

#include "patches.h"

namespace {

using namespace laws;
using pairs::check;
using pairs::check_equal;
using pairs::text;

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

// The last line of a file of a law: FNV-1a, 64 bits.
std::string sum_of(const std::string& text) {
  std::uint64_t sum = 14695981039346656037u;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211u;
  std::ostringstream line;
  line << "sum " << std::hex << std::setw(16) << std::setfill('0') << sum << '\n';
  return line.str();
}

// A folder of its own, which must hold nothing but the files that are named at the end.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(fs::temp_directory_path() / ("law-" + name + '-' + std::to_string(std::random_device()()))) {
    check(fs::create_directory(path_), path_.string() + " exists");
  }
  ~Folder() { fs::remove_all(path_); }
  std::string operator/(const char* name) const { return (path_ / name).string(); }
  std::size_t files() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), {})); }

 private:
  fs::path path_;
};

// Also by name, and of a file without the line, whose status follows from width and kind.
void a_saved_law_has_the_status_of_its_making() {
  const Folder folder("statuses");
  Patch few = usual_patch(16), mean = usual_patch(16);
  few.spec.max_nodes = 6;
  mean.problem.system.boundary = RC_BOUNDARY_FREE;
  mean.problem.system.hardness = 0.05;
  struct Case {
    const char* name;
    Patch patch;
    rc_status status, without;
    const char* says;
  };
  for (const Case& each : {Case{"ok", usual_patch(16), RC_OK, RC_OK, ""},
                           Case{"few", few, RC_STOP_MAX_ITER, RC_STOP_STALLED, "rc_law_spec.max_nodes did not allow"},
                           Case{"mean", mean, RC_UNCERTIFIED, RC_UNCERTIFIED, "met by estimate"}}) {
    const MadeLaw law = make(each.patch);
    check_equal(law.status, each.status, law.message);
    const std::string path = folder / each.name;
    check_equal(rc_law_save(law.law.get(), path.c_str()), RC_OK, rc_last_error());
    rc_law* read = nullptr;
    check_equal(rc_law_load(path.c_str(), &read), each.status, "load");
    check(std::string(rc_last_error()).find(each.says) != std::string::npos, rc_last_error());
    rc_law_destroy(read);
    const rc_law* named = nullptr;
    for (int call = 0; call < 2; ++call) check_equal(rc_law_open(path.c_str(), path.c_str(), &named), each.status, "open");
    std::string old = content(path);
    const std::size_t line = old.find("status "), end = old.find('\n', line) + 1;
    check(line != old.npos, "the file has the status");
    old.erase(line, end - line);
    old.erase(old.rfind("sum "));
    write(path, old + sum_of(old));
    check_equal(rc_law_load(path.c_str(), &read), each.without, "load of a file without the line");
    rc_law_destroy(read);
  }
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
  check_equal(static_cast<std::int64_t>(folder.files()), 1, "files left");
}

// The checksum is right, as where another program has written the file.
void numbers_that_no_law_has_are_refused() {
  const Folder folder("numbers");
  const std::string path = folder / "a.law";
  check_equal(rc_law_save(usual_law(), path.c_str()), RC_OK, rc_last_error());
  std::vector<std::string> lines;
  std::istringstream good(content(path));
  for (std::string line; std::getline(good, line);) lines.push_back(line);
  lines.pop_back();  // the checksum
  const auto begins = [](const char* word) { return [word](const std::string& line) { return line.starts_with(word); }; };
  const auto place = [&](const char* word) {
    return static_cast<std::size_t>(std::ranges::find_if(lines, begins(word)) - lines.begin());
  };
  const std::size_t status = place("status "), first = place("nodes ") + 1, last = lines.size() - 1;
  const auto words = [&](std::size_t line) {
    std::istringstream text(lines[line]);
    return std::vector<std::string>(std::istream_iterator<std::string>(text), {});
  };
  // Loads the file with another word in one line.
  const auto load = [&](std::size_t line, std::size_t column, const std::string& word) {
    std::vector<std::string> changed = words(line);
    changed[column] = word;
    std::string all;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (i != line) all += lines[i];
      for (std::size_t k = 0; i == line && k < changed.size(); ++k) all += (k > 0 ? " " : "") + changed[k];
      all += '\n';
    }
    write(path, all + sum_of(all));
    rc_law* law = nullptr;
    const rc_status found = rc_law_load(path.c_str(), &law);
    check(law == nullptr || found >= 0, "a law of a bad file");
    rc_law_destroy(law);
    return found;
  };
  constexpr std::size_t x = 0, p = 1, slope = 4;
  check_equal(load(first + 2, x, words(first + 2)[x]), RC_OK, "as it was");
  for (const std::size_t column : {x, p}) refuses(load(first, column, "1e-9"), "node 0", "a first node off the origin");
  refuses(load(first + 2, x, words(first + 1)[x]), "node 2 is not beyond", "the same overclosure twice");
  refuses(load(first + 2, p, words(first)[p]), "node 2 is not beyond", "a falling pressure");
  refuses(load(first + 2, slope, "-1e-9"), "node 2 is not beyond", "a falling slope");
  for (const std::size_t column : {x, p, slope}) refuses(load(last, column, "inf"), "is not beyond", "an infinite number");
  for (const rc_status none : {RC_STOP_TIME, RC_STOP_CANCELLED})
    refuses(load(status, 1, std::to_string(none)), "a law has no status", "a status of steps");
  for (const rc_status one : {RC_STOP_MAX_ITER, RC_STOP_STALLED, RC_UNCERTIFIED})
    check_equal(load(status, 1, std::to_string(one)), one, "a status of laws");
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
  spec.format = RC_LAW_CALCULIX, spec.rows = 201;
  refuses(rc_law_export(usual_law(), path.c_str(), &spec), "rows", "rows");
  check(content(path) == before && folder.files() == 1, "a refused export leaves the file as it was");
}

// Against samples of the rows that are written.
void the_error_of_a_table_is_its_largest() {
  const Folder folder("errors");
  const std::string path = folder / "table";
  for (const char* name : {"disc", "hardness", "mean gap"}) {
    const LawHandle law = made(patch_named(name));
    for (const std::int64_t count : {5, 6, 9, 20, 200}) {
      rc_law_export_spec spec = RC_LAW_EXPORT_SPEC_INIT;
      spec.format = RC_LAW_MOOSE;
      spec.rows = count;
      spec.beyond = 1;
      check_equal(rc_law_export(law.get(), path.c_str(), &spec), RC_OK, rc_last_error());
      const auto rows = rows_in(path, "");
      double most = 0;
      for (std::size_t i = 1; i + 1 < rows.size(); ++i)
        for (int k = 0; k <= 400; ++k) {
          const double share = k / 400.0, x = rows[i][0] + share * (rows[i + 1][0] - rows[i][0]);
          double p = 0;
          rc_law_pressure(law.get(), x, &p, nullptr, nullptr);
          most = std::max(most, std::abs((rows[i][1] + share * (rows[i + 1][1] - rows[i][1])) / p - 1));
        }
      check(most <= spec.error * (1 + 1e-6) + 1e-11 && most >= 0.99 * spec.error,
            std::string(name) + ", rows " + std::to_string(count) + ": " + text(spec.error) + ", sampled " + text(most));
    }
  }
}

void tables_hold_friction() {
  const Folder folder("friction");
  const std::string path = folder / "table";
  const rc_law_info info = describe(usual_law());
  const double stick = 1.4 / 1.7, middle = std::sqrt(info.p_lower * info.p_upper);
  rc_law_export_spec spec = RC_LAW_EXPORT_SPEC_INIT;
  spec.format = RC_LAW_CSV;
  spec.mu = spec.nu = 0.3;
  check_equal(rc_law_export(usual_law(), path.c_str(), &spec), RC_OK, rc_last_error());
  for (const auto& row : rows_in(path, "overclosure,")) {
    const rc_law_point point = evaluate(usual_law(), row[0]);
    check_equal(static_cast<std::int64_t>(row.size()), 11, "columns");
    if (row[0] > 0)
      check(std::abs(row[8] / (stick * point.slope) - 1) < 1e-6 && std::abs(row[9] / (0.3 * point.p) - 1) < 1e-6 &&
                std::abs(row[10] / (0.3 * row[0] / stick) - 1) < 1e-9,
            "row at " + text(row[0]));
  }
  double x = 0;
  rc_law_overclosure(usual_law(), middle, &x);
  const double stiffness = stick * evaluate(usual_law(), x).slope;
  spec.format = RC_LAW_ABAQUS;
  spec.length = 1e3;
  check_equal(rc_law_export(usual_law(), path.c_str(), &spec), RC_OK, rc_last_error());
  const std::string deck = content(path), key = "*FRICTION, ELASTIC SLIP=";
  check(std::abs(std::stod(deck.substr(deck.find(key) + key.size())) / (1e3 * 0.3 * middle / stiffness) - 1) < 1e-9,
        "elastic slip");
  check(rows_in(path, "*FRICTION").at(0).at(0) == 0.3, "friction");
  spec.format = RC_LAW_CALCULIX;
  spec.length = 1;
  check_equal(rc_law_export(usual_law(), path.c_str(), &spec), RC_OK, rc_last_error());
  check(std::abs(rows_in(path, "*FRICTION").at(0).at(1) / stiffness - 1) < 1e-9, "stiffness");
}

void rows_too_near_are_refused() {
  const Folder folder("near");
  const std::string path = folder / "table";
  Patch narrow = usual_patch(16);
  narrow.spec.p_upper = narrow.spec.p_lower * (1 + 1e-11);
  const LawHandle law = made(narrow);
  for (const std::int32_t format : {RC_LAW_CSV, RC_LAW_CALCULIX, RC_LAW_ABAQUS, RC_LAW_MOOSE}) {
    rc_law_export_spec spec = RC_LAW_EXPORT_SPEC_INIT;
    spec.format = format;
    refuses(rc_law_export(law.get(), path.c_str(), &spec), "is too short for so many; lower rc_law_export_spec.rows",
            "repeated rows");
  }
  check_equal(static_cast<std::int64_t>(folder.files()), 0, "files");
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
  rc_law_slip_state state = RC_LAW_SLIP_STATE_INIT;
  state.mu = state.nu = 0.3;
  for (const double x : xs) {
    double p = 0, slope = 0, energy = 0, back = 0, own = 0, shear[2] = {};
    lines >> p >> slope >> energy >> back >> shear[0] >> shear[1];
    const double slip[2] = {x / 10, x / 20};
    check(rc_law_slip(usual_law(), &state, x, slip, &state) >= 0, rc_last_error());
    check(std::memcmp(shear, state.shear, sizeof shear) == 0, "other shears at " + text(x));
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
      std::string p, slope, energy, back, shears;
      lines >> p >> slope >> energy >> back;
      std::getline(lines, shears);
      check(x <= 0 || std::abs(std::stod(back) / x - 1) < 1e-9, "the inverse of " + text(x) + " is " + back + " at p = " + p);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  return pairs::run_group("law files",
                          {{"a saved law has the status of its making", a_saved_law_has_the_status_of_its_making},
                           {"damaged files are refused", damaged_files_are_refused},
                           {"numbers that no law has are refused", numbers_that_no_law_has_are_refused},
                           {"tables hold the law", tables_hold_the_law},
                           {"tables hold friction", tables_hold_friction},
                           {"the error of a table is its largest", the_error_of_a_table_is_its_largest},
                           {"rows too near are refused", rows_too_near_are_refused},
                           {"the evaluation stands alone", the_evaluation_stands_alone},
                           {"slopes may be large and small", slopes_may_be_large_and_small}},
                          argc, argv);
}
