// The C interface of libroughcontact-formats: what it answers, what it refuses, files in pieces, and lack of memory. That it
// reads every format is shown by the other tests of this folder.
#include <roughcontact/formats.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "support/cmocka.hpp"
#include "support/failing_new.h"
#include "support/system.h"

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
const std::string gwyddion = "# Width: 6 um\n# Height: 4 um\n# Value units: nm\n1 2 3\n4 nan 6\n";

rc_surface_file read(const std::string& contents, const char* name, const rc_surface_read_spec* spec = nullptr) {
  rc_surface_file file = RC_SURFACE_FILE_INIT;
  const rc_status status = rc_surface_read_memory(contents.data(), contents.size(), name, spec, &file);
  if (status != RC_OK) fail_msg("status %d: %s", static_cast<int>(status), rc_surface_read_last_error());
  assert_string_equal(rc_surface_read_last_error(), "");
  return file;
}

void require_error(rc_status status, rc_status expected, const char* words) {
  const std::string message = rc_surface_read_last_error();
  if (status != expected || message.find(words) == std::string::npos || message.rfind("rc_surface_", 0) != 0)
    fail_msg("status %d, message \"%s\"; expected %d with \"%s\"", static_cast<int>(status), message.c_str(),
             static_cast<int>(expected), words);
}

void refuses(const std::string& contents, const char* name, const rc_surface_read_spec& spec, const char* words) {
  rc_surface_file file = RC_SURFACE_FILE_INIT;
  file.nx = 7;
  require_error(rc_surface_read_memory(contents.data(), contents.size(), name, &spec, &file), RC_ERR_ARGUMENT, words);
  assert_true(file.nx == 7 && !file.heights && !file.storage);
}

bool near(double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(b); }

void reads(void**) {
  rc_surface_file file = read(gwyddion, "a.txt");
  assert_true(file.nx == 3 && file.ny == 2 && file.missing == 1 && file.periodic == -1);
  assert_true(near(file.hx, 2e-6) && near(file.hy, 2e-6));
  assert_true(near(file.heights[0], 1e-9) && near(file.heights[5], 6e-9) && std::isnan(file.heights[4]));
  assert_string_equal(file.format, "text");
  assert_string_equal(file.assumed, "");
  rc_surface_file_free(&file);
  assert_true(!file.heights && !file.storage && file.nx == 0 && file.struct_size == sizeof file);
  rc_surface_file_free(&file);
  rc_surface_file_free(nullptr);
}

void says_what_it_assumes(void**) {
  rc_surface_file file = read("1 2\n3 4\n", "a.csv");
  assert_non_null(std::strstr(file.assumed, "lengths without a unit are in m: the file names none"));
  assert_non_null(std::strstr(file.assumed, "the pitch is not known"));
  assert_true(file.hx == 0 && file.hy == 0 && near(file.heights[3], 4) && file.unit_assumed == 1);
  rc_surface_file_free(&file);

  rc_surface_read_spec spec = RC_SURFACE_READ_SPEC_INIT;
  spec.unit = "um";
  spec.hx = 2;
  spec.hy = 3;
  file = read("1 2\n3 4\n", "a.csv", &spec);
  assert_string_equal(file.assumed, "lengths without a unit are in um, as asked for");
  assert_true(near(file.hx, 2e-6) && near(file.hy, 3e-6) && near(file.heights[3], 4e-6));
  rc_surface_file_free(&file);

  spec.hx = spec.hy = 2;
  refuses(gwyddion, "a.txt", spec, "a.txt: the unit of the heights is nm in the file, but the unit given is um");
  spec.unit = nullptr;
  refuses(gwyddion, "a.txt", spec, "hx, hy: the pitch given is 2 m, 2 m, but a.txt has its own, 2e-06 m, 2e-06 m");
  spec.hx = spec.hy = 2e-6 * (1 + 1e-7);
  file = read(gwyddion, "a.txt", &spec);
  assert_string_equal(file.assumed, "");
  assert_int_equal(file.unit_assumed, 0);
  rc_surface_file_free(&file);

  spec.format = "text";  // three columns that would be refused as points
  file = read("0 0 1\n1 0 2\n0 1 3\n1 1 4\n", nullptr, &spec);
  assert_true(file.nx == 3 && file.ny == 4);
  rc_surface_file_free(&file);
}

void refuses_arguments(void**) {
  rc_surface_file file = RC_SURFACE_FILE_INIT;
  const rc_surface_read_spec good = RC_SURFACE_READ_SPEC_INIT;
  require_error(rc_surface_read("no such file", nullptr, &file), RC_ERR_ARGUMENT, "no such file: No such file");
  require_error(rc_surface_read("/", nullptr, &file), RC_ERR_ARGUMENT, "is a folder");
  require_error(rc_surface_read(support::device, nullptr, &file), RC_ERR_ARGUMENT, support::device_refused);
  refuses("", nullptr, good, "the file: unknown format");
  refuses("1 2\n", "a.jpeg", good, "a.jpeg: unknown format");
  refuses("1 2\n3\n", "a.txt", good, "row 2 has 1 values");
  const auto changed = [&good](auto change) {
    rc_surface_read_spec spec = good;
    change(spec);
    return spec;
  };
  refuses(gwyddion, "a.txt", changed([](auto& s) { s.format = "pfu"; }),
          "format: \"pfu\" is not known; did you mean \"plu\"?; give one of gsf");
  refuses(gwyddion, "a.txt", changed([](auto& s) { s.unit = "V"; }), "unit: \"V\" is not a length unit");
  refuses(gwyddion, "a.txt", changed([](auto& s) { s.hx = 1; }), "hx = 1, hy = 0 must be positive");
  refuses(gwyddion, "a.txt", changed([](auto& s) { s.hx = s.hy = INFINITY; }), "must be positive and finite");
}

void knows_units(void**) {
  const std::pair<const char*, double> known[] = {
      {"m", 1}, {"\xb5m", 1e-6}, {"\xc5ngstr\xf6m", 1e-10}, {"microns", 1e-6}, {"Nanometres", 1e-9}};
  for (const auto& [name, metres] : known) {
    double found = 0;
    assert_int_equal(rc_surface_unit(name, &found), RC_OK);
    assert_true(near(found, metres));
  }
  double found = 7;
  for (const char* name : {"", "MM", "furlong", "mPa", "u", "Mum"})
    require_error(rc_surface_unit(name, &found), RC_ERR_ARGUMENT, "is not a length unit");
  assert_true(found == 7);
}

void lists_formats(void**) {
  const std::int64_t count = rc_surface_format_count();
  assert_true(count >= 10);
  bool found = false;
  rc_surface_format format = RC_SURFACE_FORMAT_INIT;
  for (std::int64_t i = 0; i < count; ++i) {
    assert_int_equal(rc_surface_format_describe(i, &format), RC_OK);
    assert_true(format.name[0] != '\0' && format.summary[0] != '\0' && format.suffixes[0] == '.' && format.says[0] != '\0');
    found =
        found || (std::strcmp(format.name, "sdf") == 0 && std::strcmp(format.suffixes, ".sdf .bcr") == 0 && format.by_contents);
  }
  assert_true(found);
  require_error(rc_surface_format_describe(-1, &format), RC_ERR_ARGUMENT, "index = -1");
  require_error(rc_surface_format_describe(count, &format), RC_ERR_ARGUMENT, "index = ");
}

void prepares_heights(void**) {
  std::vector<double> z = {1, 2, 3, 2, missing, 4, 3, 4, 5};  // the plane 1 + x + y
  assert_int_equal(rc_surface_fill(3, 3, 1, 1, z.data()), RC_OK);
  assert_true(near(z[4], 3));
  assert_int_equal(rc_surface_remove_form(3, 3, RC_SURFACE_FORM_PLANE, z.data()), RC_OK);
  for (const double value : z) assert_true(std::abs(value) < 1e-14);

  require_error(rc_surface_fill(3, 3, 1, 0, z.data()), RC_ERR_ARGUMENT, "hy = 0");
  require_error(rc_surface_fill(0, 3, 1, 1, z.data()), RC_ERR_SHAPE, "nx = 0");
  require_error(rc_surface_remove_form(3, 3, 4, z.data()), RC_ERR_ARGUMENT, "form = 4");
  require_error(rc_surface_remove_form(INT64_MAX, 3, 1, z.data()), RC_ERR_SHAPE, "ny = 3");
  std::vector<double> none(9, missing);
  require_error(rc_surface_fill(3, 3, 1, 1, none.data()), RC_ERR_ARGUMENT, "all 9 points are missing");
  none[2] = INFINITY;
  require_error(rc_surface_remove_form(3, 3, 1, none.data()), RC_ERR_ARGUMENT, "infinite value at ix=2, iy=0");
}

void moves_points(void**) {
  std::vector<double> z = {1, 2, 3, 4, 5, 6};  // 3 x 2
  std::int64_t nx = 3, ny = 2, count = -1;
  double largest = -1;
  assert_int_equal(rc_surface_mirror(3, 2, RC_SURFACE_MIRROR_X | RC_SURFACE_MIRROR_Y, z.data()), RC_OK);
  assert_true(z == (std::vector<double>{6, 5, 4, 3, 2, 1}));
  assert_int_equal(rc_surface_shift(3, 2, 1, 1, 1, 0, 0, RC_SURFACE_LINEAR, z.data(), &count), RC_OK);
  assert_true(count == 2 && std::isnan(z[0]) && z[1] == 6 && z[5] == 2);
  assert_int_equal(rc_surface_crop(&nx, &ny, 1, 1, 1, INFINITY, 0, 1, z.data()), RC_OK);
  assert_true(nx == 2 && ny == 1 && z[0] == 6 && z[1] == 5);
  std::vector<double> spiked = {0, 1, 0, 1, 900, 1, 0, 1, 0, 1};
  assert_int_equal(rc_surface_despike(10, 1, 10, spiked.data(), &count, &largest), RC_OK);
  assert_true(count == 1 && std::isnan(spiked[4]) && largest == 899);
  assert_int_equal(rc_surface_despike(10, 1, 10, spiked.data(), nullptr, nullptr), RC_OK);

  const std::vector<double> before = z;
  require_error(rc_surface_mirror(3, 2, 0, z.data()), RC_ERR_ARGUMENT, "axes = 0");
  require_error(rc_surface_mirror(3, 2, 4, z.data()), RC_ERR_ARGUMENT, "axes = 4");
  require_error(rc_surface_shift(2, 1, 1, 1, HUGE_VAL, 0, 0, 1, z.data(), nullptr), RC_ERR_ARGUMENT, "dx = inf");
  require_error(rc_surface_shift(2, 1, 0, 1, 1, 0, 0, 1, z.data(), nullptr), RC_ERR_ARGUMENT, "hx = 0");
  require_error(rc_surface_shift(2, 1, 1, 1, 1, 0, 2, 1, z.data(), nullptr), RC_ERR_ARGUMENT, "periodic = 2");
  require_error(rc_surface_shift(2, 1, 1, 1, 1, 0, 0, 3, z.data(), nullptr), RC_ERR_ARGUMENT, "interpolation = 3");
  require_error(rc_surface_crop(&nx, &ny, 1, 1, 5, 6, 0, 1, z.data()), RC_ERR_ARGUMENT, "middle of no cell");
  require_error(rc_surface_despike(2, 1, -1, z.data(), &count, nullptr), RC_ERR_ARGUMENT, "factor = -1");
  require_error(rc_surface_despike(2, INT64_MAX, 1, z.data(), &count, nullptr), RC_ERR_SHAPE, "nx = 2");
  assert_true(std::memcmp(z.data(), before.data(), z.size() * sizeof z[0]) == 0 && nx == 2 && ny == 1);
}

void resamples(void**) {
  const std::vector<double> z = {0, 1, 4, 9, 16};  // a parabola
  std::vector<double> to(9, 7);
  rc_surface_resampling r = RC_SURFACE_RESAMPLING_INIT;
  assert_int_equal(r.interpolation, RC_SURFACE_CUBIC);
  r.nx = 5, r.ny = 1, r.hx = r.hy = 2, r.heights = z.data();
  r.to_nx = 9, r.to_ny = 1, r.to_hx = 1, r.to_hy = 2, r.to = to.data();
  assert_int_equal(rc_surface_resample(&r), RC_OK);
  for (int i = 0; i < 9; ++i) assert_true(near(to[static_cast<std::size_t>(i)], i * i / 4.0));
  r.x0 = 7.5;
  assert_int_equal(rc_surface_resample(&r), RC_OK);
  assert_true(r.missing == 8 && near(to[0], 3.75 * 3.75) && std::isnan(to[1]));

  r.x0 = 0, r.interpolation = RC_SURFACE_LINEAR;
  assert_int_equal(rc_surface_resample(&r), RC_OK);
  for (std::size_t i = 0; i < 9; ++i) assert_true(near(to[i], (z[i / 2] + z[(i + 1) / 2]) / 2));
  std::vector<double> column = {1, 2, 3};
  assert_int_equal(rc_surface_shift(1, 3, 1, 1, 0, 1, 0, RC_SURFACE_CUBIC, column.data(), nullptr), RC_OK);
  assert_true(std::isnan(column[0]) && near(column[1], 1) && near(column[2], 2));
  // Half a point further along a wave that repeats: weights -1, 9, 9, -1 of 16, or 1, 1 of 2; along y as along x.
  for (const auto& [interpolation, quarter] : {std::pair{RC_SURFACE_CUBIC, 0.625}, {RC_SURFACE_LINEAR, 0.5}})
    for (const bool down : {false, true}) {
      std::vector<double> wave = {0, 1, 0, -1};
      assert_int_equal(rc_surface_shift(down ? 1 : 4, down ? 4 : 1, down ? 7 : 2, down ? 2 : 7, down ? 0 : 1, down ? 1 : 0, 1,
                                        interpolation, wave.data(), nullptr),
                       RC_OK);
      assert_true(near(wave[0], -quarter) && near(wave[1], quarter) && near(wave[2], quarter) && near(wave[3], -quarter));
    }

  const auto refused = [&](auto member, auto value, rc_status status, const char* says) {
    rc_surface_resampling bad = r;
    bad.*member = value;
    require_error(rc_surface_resample(&bad), status, says);
  };
  using R = rc_surface_resampling;
  refused(&R::to_nx, std::int64_t{0}, RC_ERR_SHAPE, "nx = 0");
  refused(&R::to_hx, 3.01, RC_ERR_ARGUMENT, "skip summits");
  refused(&R::to_hx, -1.0, RC_ERR_ARGUMENT, "hx = -1");
  refused(&R::x0, HUGE_VAL, RC_ERR_ARGUMENT, "x0 = inf");
}

// A pipe hands over what was written so far: reads are short.
void reads_a_file_in_pieces(void**) {
  const std::string folder = (std::filesystem::temp_directory_path() / ("formats" + std::to_string(getpid()))).string();
  std::filesystem::create_directory(folder);
  const std::string path = folder + "/pipe.txt";
  if (!support::make_pipe(path)) {
    std::filesystem::remove_all(folder);
    skip();
  }
  std::thread writer([&path] {
    std::ofstream pipe(path, std::ios::binary);
    for (const char c : gwyddion) pipe << c << std::flush;
  });
  rc_surface_file file = RC_SURFACE_FILE_INIT;
  const rc_status status = rc_surface_read(path.c_str(), nullptr, &file);
  writer.join();
  std::filesystem::remove_all(folder);
  assert_int_equal(status, RC_OK);
  assert_true(file.nx == 3 && file.ny == 2 && near(file.heights[5], 6e-9));
  rc_surface_file_free(&file);
}

void survives_lack_of_memory(void**) {
  for (std::int64_t k = 1;; ++k) {
    rc_surface_file file = RC_SURFACE_FILE_INIT;
    support::fail_allocation(k, k % 2 == 0);
    const rc_status status = rc_surface_read_memory(gwyddion.data(), gwyddion.size(), "a.txt", nullptr, &file);
    const bool failed = support::allocation_failed();
    support::fail_allocation(0, false);
    if (failed) {
      require_error(status, RC_ERR_MEMORY, "out of memory");
      assert_true(!file.heights && !file.storage);
      continue;
    }
    assert_int_equal(status, RC_OK);
    assert_true(k > 10 && near(file.heights[5], 6e-9));
    rc_surface_file_free(&file);
    return;
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(reads),
                              cmocka_unit_test(says_what_it_assumes),
                              cmocka_unit_test(refuses_arguments),
                              cmocka_unit_test(knows_units),
                              cmocka_unit_test(lists_formats),
                              cmocka_unit_test(prepares_heights),
                              cmocka_unit_test(moves_points),
                              cmocka_unit_test(resamples),
                              cmocka_unit_test(reads_a_file_in_pieces),
                              cmocka_unit_test(survives_lack_of_memory)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
