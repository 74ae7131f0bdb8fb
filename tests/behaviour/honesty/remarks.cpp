// Blunders in units and heights get a remark, and are solved all the same. Ordinary scenes get no remark.
#include <cmath>

#include "honesty_tests.h"
#include "support/contact.h"
#include "support/surfaces.h"

namespace pairs {

namespace {

constexpr const char* pressure = "mean pressure ";
constexpr const char* soft = "hardness ";
constexpr const char* approach = "approach above the grid's side";
constexpr const char* single = "one point in contact";
constexpr const char* spike = "a point without neighbours in contact has the largest pressure";
constexpr const char* tilted = "of the heights' variance";

void check_note(const Answer& answer, std::initializer_list<const char*> expected) {
  const std::string note = answer.result.note;
  for (const char* words : {pressure, soft, approach, single, spike, tilted}) {
    bool wanted = false;
    for (const char* each : expected) wanted = wanted || each == words;
    check((note.find(words) != std::string::npos) == wanted,
          (wanted ? "no remark: " : "a remark: ") + std::string(words) + " in: " + note);
  }
}

// A map of micrometres, in metres, with E* = 1e11 Pa.
Problem measured(std::int64_t side = 64) {
  Problem problem = rough_problem(side, side);
  double range = 0;
  for (const double h : problem.gap) range = std::max(range, h);
  for (double& h : problem.gap) h *= 1e-6 / range;
  problem.system.hx = problem.system.hy = 1e-6;
  problem.system.modulus = 1e11;
  problem.target = 0.4e-6;
  return problem;
}

void ordinary_scenes_have_no_remark() {
  check_note(solved(measured(), automatic, {{RC_OPT_TOL, "1e-6"}}), {});
  check_note(solved(at_load(measured(), 1e-2), automatic, {{RC_OPT_TOL, "1e-6"}}), {});
}

// 210 meant in GPa.
void a_modulus_in_gigapascal() {
  Problem problem = measured();
  problem.system.modulus = 210;
  const double nominal = 64e-6 * 64e-6;
  const Answer answer = solved(at_load(problem, 1e7 * nominal), automatic, {{RC_OPT_TOL, "1e-6"}});
  check_note(answer, {pressure, approach});
  check(std::string(answer.result.note).starts_with("mean pressure 4.76e+04 E*"), answer.result.note);
}

// 150 meant in MPa; and the lowest hardness that is not doubted, in any units.
void a_hardness_in_megapascal() {
  Problem problem = measured();
  problem.system.hardness = 150;
  check_note(solved(at_load(problem, 1e-8), automatic, {{RC_OPT_TOL, "1e-6"}}), {soft});
  for (const double unit : {1.0, 1e6}) {
    problem.system.modulus = 1e11 / unit;
    problem.system.hardness = 1.01e8 / unit;
    check_note(solved(at_load(problem, 1e-2 / unit), automatic, {{RC_OPT_TOL, "1e-6"}}), {});
    problem.system.hardness = 0.99e8 / unit;
    check_note(solved(at_load(problem, 1e-2 / unit), automatic, {{RC_OPT_TOL, "1e-6"}}), {soft});
  }
}

// 39 meant in micrometres.
void a_pitch_in_metres() {
  Problem problem = measured();
  problem.system.hx = problem.system.hy = 39;
  check_note(solved(at_load(problem, 1e-3), automatic, {{RC_OPT_TOL, "1e-6"}}), {single});
}

// Heights of micrometres taken for millimetres.
void an_approach_beyond_the_side() {
  Problem problem = measured();
  for (double& h : problem.gap) h *= 1e3;
  problem.target = 0.4e-3;
  check_note(solved(problem, automatic, {{RC_OPT_TOL, "1e-6"}}), {pressure, approach});
}

Problem tilted_map(Problem problem, double slope) {
  const std::int64_t nx = problem.system.nx;
  for (std::size_t i = 0; i < problem.gap.size(); ++i)
    problem.gap[i] += slope * 1e-6 * static_cast<double>(static_cast<std::int64_t>(i) % nx);
  return problem;
}

void a_tilted_map_is_told() {
  for (const std::int64_t side : {16, 64, 200})
    check_note(solved(tilted_map(measured(side), 2.0 / static_cast<double>(side)), automatic, {{RC_OPT_TOL, "1e-6"}}), {tilted});
}

void masked_heights_do_not_count() {
  Problem problem = measured();
  const Problem tilted_too = tilted_map(problem, 0.03);
  problem.mask.assign(problem.points(), 1);
  for (std::size_t i = 0; i < problem.points(); ++i)
    if (i / 64 >= 48) {
      problem.mask[i] = 0;
      problem.gap[i] = 1e-3 * static_cast<double>(i);
    }
  check_note(solved(problem, automatic, {{RC_OPT_TOL, "1e-6"}}), {});
  Problem on_the_rest = problem;
  for (std::size_t i = 0; i < problem.points(); ++i)
    if (problem.mask[i]) on_the_rest.gap[i] = tilted_too.gap[i];
  check_note(solved(on_the_rest, automatic, {{RC_OPT_TOL, "1e-6"}}), {tilted});
}

// A new surface on the same contact is looked at anew; one that is only repeated is not.
void each_surface_has_its_own_remark() {
  const Problem level = measured(), tilt = tilted_map(level, 0.03);
  const Contact contact(level, automatic, {{RC_OPT_TOL, "1e-6"}});
  check_note(contact.solve(level), {});
  check_note(contact.solve(tilt), {tilted});
  check_note(contact.solve(tilt), {tilted});
  check_note(contact.solve(level), {});
}

// A wave is no tilt, and a caller's matrix has no map.
void waves_and_matrices_have_no_tilt() {
  Problem wave = measured();
  wave.system.boundary = RC_BOUNDARY_PERIODIC;
  for (std::size_t i = 0; i < wave.points(); ++i)
    wave.gap[i] = 1e-6 * (1 + std::sin(2 * 3.14159265358979 * static_cast<double>(i % 64) / 64));
  check_note(solved(wave, automatic, {{RC_OPT_TOL, "1e-6"}}), {});

  Field matrix(20 * 20, 0.0);
  Problem stored;
  stored.system.op = RC_OPERATOR_DENSE;
  stored.system.nx = stored.system.dense_ld = 20;
  stored.system.dense = matrix.data();
  for (std::size_t i = 0; i < 20; ++i) {
    matrix[21 * i] = 1;
    stored.gap.push_back(static_cast<double>(i));
  }
  stored.target = 0.5;
  check_note(solved(stored, automatic), {});
}

// A tilted map that is pressed as a sample jumps at its edges; the same rough map does not.
void a_tilt_is_told_with_periodic_edges() {
  Problem level = at_load(measured(), 1e-2);
  level.system.boundary = RC_BOUNDARY_PERIODIC;
  check_note(solved(level, automatic, {{RC_OPT_TOL, "1e-6"}}), {});
  check_note(solved(tilted_map(level, 0.03), automatic, {{RC_OPT_TOL, "1e-6"}}), {tilted});
}

// A spike of any contact, inside, at an edge that repeats and at one that does not; not on the map without it.
void a_spike_is_told() {
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC, RC_BOUNDARY_PERIODIC_X})
    for (const std::size_t place : {std::size_t{0}, std::size_t{63}, std::size_t{20 * 64 + 30}})
      for (const double load : {0.5, 3.0}) {
        Problem problem = at_load(measured(), load);
        problem.system.boundary = boundary;
        problem.gap = paraboloid(64, 64, 1e-6, 40.5, 40.5, 1e-4);
        const Answer clean = solved(problem, automatic, {{RC_OPT_TOL, "1e-6"}});
        check(std::string(clean.result.note).find(spike) == std::string::npos, clean.result.note);
        problem.gap[place] = -2e-6;
        const Answer spiked = solved(problem, automatic, {{RC_OPT_TOL, "1e-6"}});
        check(spiked.result.contacts > 1, "more than the spike touches");
        check(std::string(spiked.result.note).find(spike) != std::string::npos, std::string("no remark: ") + spiked.result.note);
      }
}

// A flat punch is as stiff as itself and presses at its rim; a ball in the middle, and the same punch as a sample, have no rim.
void free_edges_are_told() {
  const Settings settings = {{RC_OPT_TOL, "1e-8"}, {RC_OPT_STIFFNESS, "1"}};
  Problem punch = at_load(measured(), 1e-2);
  punch.gap.assign(punch.points(), 0.0);
  const Answer pressed = solved(punch, automatic, settings);
  const std::string note = pressed.result.note;
  check(note.find("and the largest pressure at the rim, stiffness 1 of a flat punch") != std::string::npos, note);
  check_near(pressed.result.stiffness, pressed.result.punch_stiffness, 0.02 * pressed.result.punch_stiffness, "punch");
  check_near(pressed.result.punch_stiffness, 1.1523 * punch.system.modulus * 64e-6, 0.003 * pressed.result.punch_stiffness, "E*");
  punch.system.boundary = RC_BOUNDARY_PERIODIC;
  check(std::string(solved(punch, automatic, settings).result.note).find("edges") == std::string::npos, "periodic");
  Problem ball = at_load(measured(), 1e-3);
  ball.gap = paraboloid(64, 64, 1e-6, 31.5, 31.5, 1e-4);
  check(std::string(solved(ball, automatic, settings).result.note).find("edges") == std::string::npos, "ball");
}

}  // namespace

std::vector<Test> remarks() {
  return RC_TESTS(ordinary_scenes_have_no_remark, a_modulus_in_gigapascal, a_hardness_in_megapascal, a_pitch_in_metres,
                  an_approach_beyond_the_side, a_tilt_is_told_with_periodic_edges, a_spike_is_told, free_edges_are_told,
                  a_tilted_map_is_told, masked_heights_do_not_count, each_surface_has_its_own_remark,
                  waves_and_matrices_have_no_tilt);
}

}  // namespace pairs
