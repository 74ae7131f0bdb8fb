// Files of laws that an earlier build of each version has written: they load for ever, and mean what they meant.
#include <array>
#include <cmath>
#include <filesystem>
#include <random>
#include <sstream>

#include "patches.h"

namespace {

using namespace laws;
using pairs::check;
using pairs::check_equal;
using pairs::check_near;

namespace fs = std::filesystem;

using Row = std::array<double, 11>;

struct Stored {
  const char* file;
  rc_status status;
  std::int64_t nodes;
  std::int32_t bulk;
  double hardness;
  // x, p, its bounds, slope, energy, area fraction and its bounds, bounds of the conductance
  std::array<Row, 2> points;
};

constexpr double infinite = HUGE_VAL;
const Stored stored[] = {
    {"version-1-convex.law",
     RC_OK,
     12,
     RC_LAW_BULK_NONE,
     0,
     {{{0.0085905922707471046, 0.00080802177152571725, 0.00079825648248803283, 0.0008247110038093208, 0.2188921893158583,
        2.4203915490800106e-06, 0.077696555371791737, 0.0625, 0.083333333333333329, 0.12454223494178693, 0.16724379077947904},
       {0.022152589139007271, 0.0064702399357993087, 0.0062474842030754759, 0.0067531662870171181, 0.53829717441881553,
        4.7861664502401714e-05, 0.24052519548930196, 0.16666666666666666, 0.29166666666666669, 0.29312628440550587,
        0.59963581712915981}}}},
    {"version-1-hardness.law",
     RC_UNCERTIFIED,
     9,
     RC_LAW_BULK_MEAN,
     0.04,
     {{{0.0090523696432945958, 0.00088005553200457497, 0.00086717069717100605, 0.00091609683132811706, 0.2416781799588453,
        2.7286071456057374e-06, 0.070351968428170347, 0.0625, 0.125, 0.12372593117973125, 0.22907832852475613},
       {0.013802832491832246, 0.0025744244621139618, 0.0015631499192670718, 0.0028861249231749461, 0.40923515161406893,
        1.060332907628499e-05, 0.15684979088089646, 0.125, 0.16666666666666666, 0, infinite}}}}};

LawHandle loaded(const std::string& path, rc_status wanted) {
  rc_law* law = nullptr;
  check_equal(rc_law_load(path.c_str(), &law), wanted, std::string("status of ") + path + ": " + rc_last_error());
  return LawHandle(law);
}

void means_what_it_meant(const Stored& each) {
  const std::string path = std::string(RC_TEST_DATA "/laws/") + each.file;
  const LawHandle law = loaded(path, each.status);
  const rc_law_info info = describe(law.get());
  check_equal(info.nodes, each.nodes, "nodes");
  check_equal(info.bulk, each.bulk, "bulk");
  check_near(info.hardness, each.hardness, 0, "hardness");
  check_near(info.area, 72, 0, "area");
  check_near(info.modulus, 3, 0, "modulus");
  for (const Row& row : each.points) {
    const rc_law_point p = evaluate(law.get(), row[0]);
    const Row found{p.x,          p.p,          p.p_lower,           p.p_upper,          p.slope, p.energy, p.area_fraction,
                    p.area_lower, p.area_upper, p.conductance_lower, p.conductance_upper};
    for (std::size_t i = 0; i < row.size(); ++i)
      if (found[i] != row[i]) check_near(found[i], row[i], 1e-12 * row[i], "number " + std::to_string(i));
  }
}

// The numbers of a node stand in the file in the order of rc_law_point; its kind is the last.
void members_have_their_places(const Stored& each) {
  const std::string path = std::string(RC_TEST_DATA "/laws/") + each.file;
  const LawHandle law = loaded(path, each.status);
  std::istringstream text(content(path));
  for (std::string word; text >> word && word != "nodes";) continue;
  std::int64_t count = 0;
  text >> count;
  check_equal(count, each.nodes, "nodes in the file");
  for (std::int64_t i = 0; i < count; ++i) {
    rc_law_point n = RC_LAW_POINT_INIT;
    check_equal(rc_law_describe_node(law.get(), i, &n), RC_OK, rc_last_error());
    for (const double member : {n.x, n.p, n.p_lower, n.p_upper, n.slope, n.slope_lower, n.slope_upper, n.energy, n.area_fraction,
                                n.area_lower, n.area_upper, n.between_lower, n.between_upper}) {
      std::string word;
      text >> word;
      const double wanted = std::stod(word);
      check(member == wanted, "node " + std::to_string(i) + " has " + pairs::text(member) + " where the file has " + word);
    }
    std::int32_t kind = 0;
    text >> kind;
    check_equal(n.bounds, kind, "kind of bounds");
  }
}

void is_written_as_it_was(const Stored& each) {
  const std::string path = std::string(RC_TEST_DATA "/laws/") + each.file;
  const LawHandle law = loaded(path, each.status);
  std::random_device random;
  const fs::path again = fs::temp_directory_path() / ("stored-" + std::to_string(random()) + std::to_string(random()) + ".law");
  check_equal(rc_law_save(law.get(), again.string().c_str()), RC_OK, rc_last_error());
  const std::string written = content(again);
  fs::remove(again);
  check(written == content(path), "this version writes another file; if the format has a new version, add its sample");
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<pairs::Test> tests;
  for (const Stored& each : stored) {
    const std::string name = each.file;
    tests.push_back({name + " means what it meant", [&each] { means_what_it_meant(each); }});
    tests.push_back({name + " has its members at their places", [&each] { members_have_their_places(each); }});
    tests.push_back({name + " is written as it was", [&each] { is_written_as_it_was(each); }});
  }
  return pairs::run_group("law stored", tests, argc, argv);
}
