// The C interface of libroughcontact-request.
#include <roughcontact/request.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "support/cmocka.hpp"

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN(), pi = 3.14159265358979323846;

// Words and one map of 4 x 3 points.
struct Asked {
  std::vector<rc_given> words{{"modulus", "1GPa", nullptr, 0}, {"load", "1mN", nullptr, 0}, {"boundary", "free", nullptr, 0}};
  std::vector<double> z = std::vector<double>(12, 0);
  std::vector<rc_map> maps{RC_MAP_INIT};
  rc_request_spec spec = RC_REQUEST_SPEC_INIT;
  rc_request* made = nullptr;

  Asked() {
    z[5] = 1e-6;
    maps[0].word = "surface";
    maps[0].heights = z.data();
    maps[0].nx = 4;
    maps[0].ny = 3;
    maps[0].hx = maps[0].hy = 1e-6;
    spec.call = RC_CALL_SOLVE;
  }
  ~Asked() { rc_request_destroy(made); }
  Asked(const Asked&) = delete;
  Asked& operator=(const Asked&) = delete;

  rc_status ask() {
    rc_request_destroy(made);
    made = nullptr;
    spec.words = words.data();
    spec.n_words = static_cast<int64_t>(words.size());
    spec.maps = maps.data();
    spec.n_maps = static_cast<int64_t>(maps.size());
    return rc_request_create(&spec, &made);
  }
  rc_problem_view view() {
    rc_problem_view found = RC_PROBLEM_VIEW_INIT;
    const rc_status status = ask();
    if (status != RC_OK) fail_msg("status %d: %s", static_cast<int>(status), rc_request_last_error());
    assert_int_equal(rc_request_problem(made, &found), RC_OK);
    return found;
  }
  void refuses(rc_status expected, const char* words_of_it) {
    const rc_status status = ask();
    const std::string message = rc_request_last_error();
    if (status != expected || message.find(words_of_it) == std::string::npos || made)
      fail_msg("status %d, message \"%s\"; expected %d with \"%s\"", static_cast<int>(status), message.c_str(),
               static_cast<int>(expected), words_of_it);
  }
};

void the_table_is_whole(void**) {
  assert_true(rc_word_count() > 20);
  for (int64_t k = 0; k < rc_word_count(); ++k) {
    rc_word word = RC_WORD_INIT;
    assert_int_equal(rc_word_describe(k, &word), RC_OK);
    assert_true(*word.name && *word.form && *word.help && word.most >= 1 && word.calls > 0);
    assert_true((*word.why_not == 0) == (word.calls == 2 * RC_CALL_ROWS - 1));
  }
  rc_word word = RC_WORD_INIT;
  assert_int_equal(rc_word_describe(-1, &word), RC_ERR_ARGUMENT);
  assert_int_equal(rc_word_describe(rc_word_count(), &word), RC_ERR_ARGUMENT);
}

void heights_that_no_word_changes_are_the_callers(void**) {
  Asked asked;
  assert_ptr_equal(asked.view().heights, asked.z.data());
  asked.words.push_back({"remove", "mean", nullptr, 0});
  const rc_problem_view view = asked.view();
  assert_ptr_not_equal(view.heights, asked.z.data());
  assert_true(std::abs(view.heights[0] + 1e-6 / 12) < 1e-18 && asked.z[0] == 0);
}

void masks_and_missing_points(void**) {
  Asked asked;
  std::vector<uint8_t> mask(12, 1);
  mask[2] = 0;
  asked.z[2] = missing;  // what the mask leaves out may be anything
  asked.maps[0].mask = mask.data();
  rc_problem_view view = asked.view();
  assert_ptr_equal(view.mask, mask.data());
  assert_int_equal(view.missing, 0);
  asked.z[7] = missing;
  asked.refuses(RC_ERR_ARGUMENT, "1 missing value of 12, first at ix=3, iy=1; give missing fill");
  asked.words.push_back({"missing", "exclude", nullptr, 0});
  view = asked.view();
  assert_true(view.mask[2] == 0 && view.mask[7] == 0 && view.mask[5] == 1);
  assert_int_equal(view.missing, 1);
  rc_remark remark = RC_REMARK_INIT;
  assert_int_equal(rc_request_remark(asked.made, 0, &remark), RC_OK);
  assert_int_equal(remark.code, RC_REMARK_MISSING);
  assert_true(remark.number[0] == 1 && remark.number[1] == 3 && remark.number[2] == 1);
  assert_int_equal(rc_request_remark(asked.made, rc_request_remark_count(asked.made), &remark), RC_ERR_ARGUMENT);
  asked.words.back().text = "fill";
  view = asked.view();
  assert_true(!view.mask && std::isfinite(view.heights[2]) && std::isfinite(view.heights[7]));
}

void numbers_stay_in_the_callers_units_until_one_is_named(void**) {
  Asked asked;
  const double modulus = 3, load = 5;
  asked.spec.numbers = RC_NUMBERS_OWN;
  asked.words[0] = {"modulus", nullptr, &modulus, 1};
  asked.words[1] = {"load", nullptr, &load, 1};
  rc_problem_view view = asked.view();
  assert_true(view.si == 0 && view.system.modulus == 3 && view.targets[0] == 5 && rc_request_remark_count(asked.made) == 0);
  asked.words[1] = {"load", "5mN", nullptr, 0};
  view = asked.view();
  assert_true(view.si == 1 && std::abs(view.targets[0] - 5e-3) < 1e-18);
  rc_remark remark = RC_REMARK_INIT;
  bool said = false;
  for (int64_t k = 0; k < rc_request_remark_count(asked.made); ++k) {
    assert_int_equal(rc_request_remark(asked.made, k, &remark), RC_OK);
    said = said || remark.code == RC_REMARK_UNIT;
  }
  assert_true(said);
  asked.maps[0].unit = "um";
  view = asked.view();
  assert_true(std::abs(view.system.hx - 1e-12) < 1e-24 && std::abs(view.heights[5] - 1e-12) < 1e-24 && view.metres == 1e-6);
}

void flows_are_words(void**) {
  Asked asked;
  asked.spec.spelling = RC_SPELLING_OPTION;
  assert_true(asked.view().along == 0 && asked.view().viscosity == 0);
  asked.words.push_back({"leak", "viscosity=1.5 mPa s,drop=2bar,along=y", nullptr, 0});
  rc_problem_view view = asked.view();
  assert_true(std::abs(view.viscosity - 1.5e-3) < 1e-18 && view.pressure_drop == 2e5 && view.along == 2 && view.si == 1);
  for (const auto& [text, says] : {std::pair{"viscosity=1mPas", "--leak: \"viscosity=1mPas\" needs both viscosity and drop"},
                                   {"viscosity=0Pas,drop=1bar", "is not positive"},
                                   {"viscosity=1bar,drop=1bar", "is a pressure, expected a viscosity: Pas with an SI prefix"},
                                   {"viscosity=1mPas,drop=1bar,along=z", "--leak: along"},
                                   {"viscosity", "is not a number"},
                                   {"visc=1mPas,drop=1bar", "viscosity"}}) {
    asked.words.back().text = text;
    asked.refuses(RC_ERR_ARGUMENT, says);
  }
  asked.words.back().text = "viscosity=1e-3,drop=1e5";
  assert_true(asked.view().along == 1);
  asked.words.push_back({"closing-pressure", "x", nullptr, 0});
  asked.refuses(RC_ERR_ARGUMENT, "either --leak or --closing-pressure");
  asked.words.erase(asked.words.end() - 2);
  asked.refuses(RC_ERR_ARGUMENT, "give only one of --load and --closing-pressure");
  asked.words.erase(asked.words.begin() + 1);
  view = asked.view();
  assert_true(std::string(view.loading) == "closing-pressure" && view.along == 1 && view.n == 0);
}

void smooth_bodies(void**) {
  Asked asked;
  asked.words.push_back({"shape", "sphere:R=1mm", nullptr, 0});
  asked.view();
  rc_smooth smooth = RC_SMOOTH_INIT;
  assert_int_equal(rc_request_smooth(asked.made, 1e-3, &smooth), RC_OK);
  const double a = std::cbrt(3 * 1e-3 * 1e-3 / (4 * 1e9));
  assert_true(std::abs(smooth.width / (2 * a) - 1) < 1e-12 && std::abs(smooth.approach / (a * a / 1e-3) - 1) < 1e-12);
  assert_true(std::abs(smooth.max_pressure / (1.5 * 1e-3 / (pi * a * a)) - 1) < 1e-12);
  assert_non_null(std::strstr(smooth.remark, "press a larger map"));
  assert_int_equal(rc_request_smooth(asked.made, -1, &smooth), RC_ERR_ARGUMENT);
  char text[256];
  assert_int_equal(rc_request_note(asked.made, "stalled", 1e-3, sizeof text, text), RC_OK);
  assert_true(std::string(text).starts_with("stalled; Hertz' contact of this shape"));
  asked.words.pop_back();
  asked.view();
  assert_int_equal(rc_request_smooth(asked.made, 1, &smooth), RC_ERR_ARGUMENT);
}

void notes_name_the_word_that_helps(void**) {
  Asked asked;
  asked.spec.spelling = RC_SPELLING_OPTION;
  asked.view();
  char text[256];
  const char* const note = "check the map for a spike; a plane is 90 % of the heights' variance: level them";
  assert_int_equal(rc_request_note(asked.made, note, 1, sizeof text, text), RC_OK);
  assert_string_equal(text,
                      "check the map for a spike, which --despike 10 takes out; a plane is 90 % of the heights' variance: level "
                      "them with --remove plane");
  assert_int_equal(rc_request_note(asked.made, note, 1, 6, text), RC_OK);
  assert_string_equal(text, "check");
  assert_int_equal(rc_request_note(asked.made, nullptr, 1, sizeof text, text), RC_ERR_ARGUMENT);
}

void metres_that_only_a_mistaken_unit_explains_are_refused(void**) {
  Asked asked;
  asked.maps[0].hx = asked.maps[0].hy = 0.0099;
  asked.view();
  std::vector<double> tall(12, 0);
  tall[3] = 0.0101;
  asked.maps[0].heights = tall.data();
  asked.refuses(RC_ERR_ARGUMENT, "the range of heights of surface would be 10.1 mm");
  asked.words.push_back({"unit", "m", nullptr, 0});
  asked.view();
}

void what_a_program_may_do_wrong(void**) {
  Asked asked;
  asked.spec.call = 3;
  asked.refuses(RC_ERR_ARGUMENT, "is not one RC_CALL_*");
  asked.spec.call = RC_CALL_SOLVE;
  asked.spec.spelling = 9;
  asked.refuses(RC_ERR_ARGUMENT, "RC_SPELLING_");
  asked.spec.spelling = RC_SPELLING_OPTION;
  asked.maps[0].nx = 0;
  asked.refuses(RC_ERR_SHAPE, "2^40");
  asked.maps[0].nx = 4;
  asked.maps[0].hx = -1;
  asked.refuses(RC_ERR_ARGUMENT, "hx = -1");
  asked.maps[0].hx = 1e-6;
  asked.words.push_back({"modlus", "1", nullptr, 0});
  asked.refuses(RC_ERR_OPTION, "did you mean \"modulus\"");
  asked.words.back() = {"tol", nullptr, nullptr, 0};
  asked.refuses(RC_ERR_ARGUMENT, "has no value");
  asked.words.back() = {"load", "1", nullptr, 0};
  asked.refuses(RC_ERR_ARGUMENT, "--load is given twice");
  const double two[] = {1, 2};
  asked.words.pop_back();
  asked.words[1] = {"load", nullptr, two, 2};
  asked.refuses(RC_ERR_ARGUMENT, "--load has 2 values");
  rc_request_destroy(nullptr);
}

void options_are_words_too(void**) {
  Asked asked;
  asked.words.push_back({"max-iter", "7", nullptr, 0});
  asked.view();
  rc_options* options = nullptr;
  double most = 0;
  assert_int_equal(rc_options_create(nullptr, &options), RC_OK);
  assert_int_equal(rc_request_options(asked.made, options), RC_OK);
  assert_int_equal(rc_options_get_number(options, "max_iter", &most), RC_OK);
  assert_true(most == 7);
  asked.words.back().text = "much";
  asked.view();
  assert_int_equal(rc_request_options(asked.made, options), RC_ERR_OPTION);
  rc_options_destroy(options);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_table_is_whole),
      cmocka_unit_test(heights_that_no_word_changes_are_the_callers),
      cmocka_unit_test(masks_and_missing_points),
      cmocka_unit_test(numbers_stay_in_the_callers_units_until_one_is_named),
      cmocka_unit_test(flows_are_words),
      cmocka_unit_test(smooth_bodies),
      cmocka_unit_test(notes_name_the_word_that_helps),
      cmocka_unit_test(metres_that_only_a_mistaken_unit_explains_are_refused),
      cmocka_unit_test(what_a_program_may_do_wrong),
      cmocka_unit_test(options_are_words_too),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
