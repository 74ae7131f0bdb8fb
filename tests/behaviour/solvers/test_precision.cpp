// fft.precision=single: its products and certificates are those of double precision to within 1e-6.
#include <algorithm>
#include <cmath>
#include <random>

#include "support/contact.h"
#include "support/registry.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

constexpr double tolerance = 1e-6;  // of the largest entry of a product
constexpr std::int64_t sizes[][2] = {{16, 23}, {64, 50}, {128, 128}, {256, 243}};
const Settings single = {{"fft.precision", "single"}, {RC_OPT_TOL, "1e-5"}}, exact = {{RC_OPT_TOL, "1e-5"}};

template <class Body> void for_each_problem(const Body& body) {
  for (const auto& [nx, ny] : sizes)
    if (!quick() || nx < 100)
      for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) body(rough_problem(nx, ny, boundary));
}

void certificates_agree() {
  for_each_problem([](const Problem& by_approach) {
    const double load = solved(by_approach, {"haar-cg", "fft"}, exact).result.load;
    for (const Problem& problem : {by_approach, at_load(by_approach, load)}) {
      const Answer given = solved(problem, {"haar-cg", "fft"}, single);
      Problem same = problem;
      same.control = RC_CONTROL_APPROACH;
      same.target = given.result.approach;
      for (const char* backend : {"fft", "dense"}) {
        if (std::string(backend) == "dense" && problem.points() > 5000) continue;
        const Answer judged = Contact(same, {"auto", backend}, exact).certify(same.step(), given.p);
        check_status(judged, RC_OK);
        check_near(given.result.kkt_dual, judged.result.kkt_dual, tolerance, "dual residual");
        check_near(given.result.kkt_complementarity, judged.result.kkt_complementarity, tolerance, "complementarity");
        const double scale = same.target - same.lowest_gap();
        for (std::size_t i = 0; i < given.gap.size(); ++i) check_near(given.gap[i], judged.gap[i], tolerance * scale, "gap");
      }
      check_near(given.result.load, solved(problem, {"haar-cg", "fft"}, exact).result.load, 1e-5 * given.result.load, "load");
    }
  });
}

// The products of pressures that no solver sees: of any unit, and with a mean that is large beside what varies.
void products_agree() {
  for_each_problem([](Problem problem) {
    std::fill(problem.gap.begin(), problem.gap.end(), 0.0);
    problem.target = 0;
    for (const std::string& kernel : kernel_names())
      for (const double unit : {1.0, 1e-200, 1e200})
        for (const double mean : {0.0, 1e4}) {
          problem.kernel = kernel;
          std::mt19937 random(3);
          Field p(problem.points());
          for (double& value : p) value = unit * (mean + static_cast<double>(random()) / 4e9);
          try {
            const Answer in_double = Contact(problem, {"auto", "fft"}, exact).certify(problem.step(), p);
            const Answer in_single = Contact(problem, {"auto", "fft"}, single).certify(problem.step(), p);
            check_near(in_single.gap, in_double.gap, tolerance, kernel);
          } catch (const Failure& failure) {
            if (std::string(failure.what()).find("boundaries, which the system has") == std::string::npos) throw;
          }
        }
  });
}

}  // namespace

}  // namespace pairs

int main(int argc, char** argv) {
  using namespace pairs;
  return run_group("solvers.precision", RC_TESTS(certificates_agree, products_agree), argc, argv);
}
