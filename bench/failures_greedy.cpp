// Example 1 of Bemporad & Paggi (2015): N x N cells, all of them candidates, compenetrations uniform on (0, 1).
#include "failures.h"
#include "format.h"
#include "greedy_draws.h"
#include "inverse_m.h"

namespace bench {

namespace {

constexpr const char* kernels[] = {"eq9", "punch", "galerkin", "love", "disc"};

}  // namespace

void greedy_failures(const FailuresRequest& request, Atlas& atlas) {
  std::string shares;
  Json worst;
  std::int64_t elsewhere = 0, elsewhere_draws = 0, dishonest = 0, unrepaired = 0;
  for (const char* kernel : kernels)
    for (const std::int64_t spacing : {1, 2})
      for (const std::int64_t side : {5, 10, 20}) {
        const std::int64_t draws = !request.quick ? 1000 : side < 20 ? 100 : 30;
        const Json row = greedy_on_draws(kernel, side, spacing, draws);
        atlas.record("greedy", row);
        dishonest += row.at("dishonest").get<std::int64_t>();
        unrepaired += row.at("unrepaired").get<std::int64_t>();
        if (row.at("kernel") != "eq9" || spacing != 1) {
          elsewhere += row.at("failures").get<std::int64_t>();
          elsewhere_draws += draws;
          continue;
        }
        shares +=
            (shares.empty() ? "" : "; ") + formatted("n = %lld: %.1f %% (%.1f to %.1f)", static_cast<long long>(side * side),
                                                     100 * row.at("share").get<double>(), 100 * row.at("lower").get<double>(),
                                                     100 * row.at("upper").get<double>());
        if (side == 10) worst = row;
      }
  atlas.add(
      "greedy",
      {"Example 1 of the paper: N x N cells in contact at random depths, kernel eq9",
       "the answer overlaps in a share of draws that grows with n, " + shares +
           formatted(
               "; at n = 100 the deepest overlap is %.2f of the compenetration, loads are off by up to %.1e and pressures by "
               "up to %.0f %% of the largest",
               worst.at("deepest_overlap").get<double>(), worst.at("load_error").get<double>(),
               100 * worst.at("pressure_error").get<double>()),
       formatted(
           "RC_STOP_UNCERTIFIED with a note that counts the overlapping points, in each of the draws; wrong answers with status "
           "RC_OK: %lld",
           static_cast<long long>(dishonest)),
       formatted(
           "every other solver lets points come back; greedy.repair = 1 hands what greedy found over to nnls: draws it left "
           "unsolved: %lld",
           static_cast<long long>(unrepaired))});
  atlas.add("greedy",
            {"the same with kernels love, disc, galerkin or punch, or with every second cell left out",
             formatted("%lld of %lld draws fail", static_cast<long long>(elsewhere), static_cast<long long>(elsewhere_draws)),
             "not needed, checked all the same", "kernel love is the default"});

  std::string couplings;
  for (const char* kernel : kernels) {
    double dense = 0;
    for (const std::int64_t spacing : {1, 2})
      for (const std::int64_t side : {5, 10, 20, 30}) {
        if (side > 20 && (request.quick || spacing > 1)) continue;
        const double coupling = largest_inverse_coupling(kernel, side, spacing);
        atlas.record("inverse", {{"kernel", kernel}, {"n", side * side}, {"spacing", spacing}, {"coupling", coupling}});
        if (spacing == 1) dense = coupling;
      }
    couplings += formatted("%s%s %+.1e", couplings.empty() ? "" : ", ", kernel, dense);
  }
  atlas.add("greedy", {"why: greedy is exact for every surface if and only if H^-1 has no positive entry off its diagonal",
                       "largest such entry over the smallest on the diagonal: " + couplings +
                           "; negative for every kernel when every second cell is left out",
                       "a property of kernel and grid, tabled as \"inverse\"",
                       "galerkin and punch are exact on random surfaces only; see docs/paper.md"});
}

}  // namespace bench
