// The file of the option fft.wisdom.
#include <fftw3.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "fixtures.h"
#include "support/cmocka.hpp"

extern "C" rc_status rc_builtin_fft(const rc_host*, const rc_plugin**);

namespace {

namespace fs = std::filesystem;

const rc_backend& fft() {
  const rc_plugin* plugin = nullptr;
  assert_int_equal(rc_builtin_fft(nullptr, &plugin), RC_OK);
  return *plugin->backends[0];
}

// An empty directory, and no wisdom in FFTW.
class Place {
 public:
  Place() {
    std::string name = (fs::temp_directory_path() / "rc-wisdom-XXXXXX").string();
    assert_non_null(mkdtemp(name.data()));
    directory_ = name;
    forget();
  }
  ~Place() { fs::remove_all(directory_); }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  static void forget() {
    fftw_forget_wisdom();
    fftwf_forget_wisdom();
  }
  std::string path(const std::string& name) const { return (directory_ / name).string(); }
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(directory_), fs::directory_iterator()); }

 private:
  fs::path directory_;
};

std::string contents(const std::string& path) {
  std::ifstream in(path);
  assert_true(in.good());
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string known_to_fftw() {
  const std::unique_ptr<char, void (*)(void*)> text(fftw_export_wisdom_to_string(), std::free);
  return text.get();
}

// Of the first product in either precision.
struct Statuses {
  rc_status in_double, in_float;
};
Statuses multiply(const std::string& planning, const std::string& wisdom, std::int64_t n = 24) {
  contract::StandInHost host(fft());
  host.set("deterministic", planning == "measure" ? "0" : "1");
  host.set("fft.planning", planning);
  host.set("fft.wisdom", wisdom);
  const rc_system system = contract::halfspace(RC_BOUNDARY_FREE, n, n, 1.0, 1.0);
  const rc_operator_spec spec = contract::spec_of(system, host);
  const rc_domain domain{sizeof(rc_domain), n * n, nullptr, 0.0};
  void* self = nullptr;
  assert_int_equal(fft().create(&host, &spec, &self), RC_OK);
  assert_int_equal(fft().bind(self, &domain), RC_OK);
  const std::vector<double> x(static_cast<std::size_t>(n * n), 1.0);
  const std::vector<float> x_float(x.begin(), x.end());
  std::vector<double> y(x.size());
  std::vector<float> y_float(x.size());
  const Statuses statuses{fft().apply(self, x.data(), y.data()), fft().apply_float(self, x_float.data(), y_float.data())};
  fft().destroy(self);
  return statuses;
}

void assert_works(const Statuses& statuses) {
  assert_int_equal(statuses.in_double, RC_OK);
  assert_int_equal(statuses.in_float, RC_OK);
}

void assert_message_has(const std::string& part) {
  if (contract::StandInHost::message().find(part) == std::string::npos)
    fail_msg("\"%s\" is not in: %s", part.c_str(), contract::StandInHost::message().c_str());
}

void measuring_writes_a_file_for_each_precision(void**) {
  const Place place;
  const std::string path = place.path("w");
  assert_works(multiply("measure", path));
  assert_int_equal(place.files(), 2);
  assert_true(contents(path).find("fftw_wisdom") != std::string::npos);
  assert_true(contents(path + ".float").find("fftwf") != std::string::npos);
  // More sizes are added to it.
  const std::string before = contents(path);
  Place::forget();
  assert_works(multiply("measure", path, 45));
  assert_true(contents(path).size() > before.size());
  assert_int_equal(place.files(), 2);
}

void a_file_is_read_before_plans_are_made(void**) {
  const Place place;
  const std::string path = place.path("w"), nothing = known_to_fftw();
  assert_works(multiply("measure", path));
  const std::string learned = known_to_fftw();
  assert_true(learned != nothing);
  Place::forget();
  assert_works(multiply("estimate", path));
  assert_true(known_to_fftw() == learned);
}

void estimating_writes_nothing(void**) {
  const Place place;
  assert_works(multiply("estimate", place.path("w")));
  assert_int_equal(place.files(), 0);
}

void without_the_option_no_file_is_touched(void**) {
  const Place place;
  const fs::path before = fs::current_path();
  fs::current_path(place.path(""));
  assert_works(multiply("measure", ""));
  fs::current_path(before);
  assert_int_equal(place.files(), 0);
}

void a_corrupt_file_is_reported_and_left_alone(void**) {
  const Place place;
  const std::string path = place.path("w");
  std::ofstream(path) << "(fftw-3.3.10 fftw_wisdom #x0";
  std::ofstream(path + ".float") << contents(path);
  const Statuses statuses = multiply("measure", path);
  assert_int_equal(statuses.in_double, RC_ERR_OPTION);
  assert_int_equal(statuses.in_float, RC_ERR_OPTION);
  assert_message_has("wisdom file \"" + path + ".float\" holds no wisdom of fftw");
  assert_message_has("remove it");
  assert_true(contents(path) == "(fftw-3.3.10 fftw_wisdom #x0");
}

void a_file_that_cannot_be_written_is_reported(void**) {
  const Place place;
  const std::string path = place.path("no-such-directory/w");
  assert_int_equal(multiply("measure", path).in_double, RC_ERR_OPTION);
  assert_message_has("wisdom file \"" + path);
  assert_message_has("cannot be written: ");
  assert_message_has("leave fft.wisdom empty");
}

void a_directory_is_no_wisdom_file(void**) {
  const Place place;
  assert_int_equal(multiply("estimate", place.path("")).in_double, RC_ERR_OPTION);
  assert_message_has("is not a regular file");
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(measuring_writes_a_file_for_each_precision),
      cmocka_unit_test(a_file_is_read_before_plans_are_made),
      cmocka_unit_test(estimating_writes_nothing),
      cmocka_unit_test(without_the_option_no_file_is_touched),
      cmocka_unit_test(a_corrupt_file_is_reported_and_left_alone),
      cmocka_unit_test(a_file_that_cannot_be_written_is_reported),
      cmocka_unit_test(a_directory_is_no_wisdom_file),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
