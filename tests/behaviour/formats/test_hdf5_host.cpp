// A host that uses libhdf5 itself and reads a surface in HDF5: its settings stay, no code of its own or of a plugin runs,
// whatever the file names. test_hdf5_host PLUGIN_FOLDER
#include <hdf5.h>
#include <roughcontact/formats.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "support/cmocka.hpp"
#include "support/system.h"

namespace {

namespace fs = std::filesystem;

constexpr hsize_t shape[2] = {3, 4};
constexpr double heights[12] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
constexpr H5Z_filter_t unknown_filter = 300;
constexpr auto user_link = static_cast<H5L_type_t>(H5L_TYPE_UD_MIN + 1);

// The bytes of a file whose contents write(file) makes.
std::string file_with(const std::function<void(hid_t)>& write, hid_t creation = H5P_DEFAULT,
                      H5F_libver_t oldest = H5F_LIBVER_LATEST) {
  const std::string path = (fs::current_path() / "host.h5").string();
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(access, oldest, H5F_LIBVER_LATEST);
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access);
  assert_true(file >= 0);
  write(file);
  assert_true(H5Fclose(file) >= 0);
  H5Pclose(access);
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_surface(hid_t file, hid_t creation = H5P_DEFAULT) {
  const hid_t space = H5Screate_simple(2, shape, nullptr);
  const hid_t set = H5Dcreate2(file, "surface", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  assert_true(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, heights) >= 0);
  H5Dclose(set);
  H5Sclose(space);
}

const std::string& good() {
  static const std::string file = file_with([](hid_t to) { write_surface(to); });
  return file;
}

void reads(const std::string& contents) {
  rc_surface_file file = RC_SURFACE_FILE_INIT;
  if (rc_surface_read_memory(contents.data(), contents.size(), "a.h5", nullptr, &file) != RC_OK)
    fail_msg("%s", rc_surface_read_last_error());
  assert_true(file.nx == 3 && file.ny == 4 && file.heights[1] == heights[4]);
  rc_surface_file_free(&file);
}

void refuses(const std::string& contents, const char* words) {
  rc_surface_file file = RC_SURFACE_FILE_INIT;
  assert_int_equal(rc_surface_read_memory(contents.data(), contents.size(), "a.h5", nullptr, &file), RC_ERR_ARGUMENT);
  const std::string message = rc_surface_read_last_error();
  if (message.find(words) == std::string::npos) fail_msg("\"%s\" lacks \"%s\"", message.c_str(), words);
}

// Reads what is good, what is refused and what is damaged.
void read_all() {
  reads(good());
  refuses(file_with([](hid_t file) { H5Lcreate_soft("/a", file, "surface", H5P_DEFAULT, H5P_DEFAULT); }), "is a soft link");
  refuses(good().substr(0, 100), "damaged");
}

int handled = 0;
herr_t handler(hid_t, void* data) {
  handled += *static_cast<int*>(data);
  return 0;
}
herr_t old_handler(void* data) { return handler(H5E_DEFAULT, data); }

void assert_handles() {
  handled = 0;
  assert_true(H5Fopen("/nonexistent/a.h5", H5F_ACC_RDONLY, H5P_DEFAULT) < 0);
  assert_int_equal(handled, 7);
}

void the_hosts_handler_of_errors_stays(void**) {
  int seven = 7;
  H5Eset_auto2(H5E_DEFAULT, handler, &seven);
  handled = 0;
  read_all();
  assert_int_equal(handled, 0);
  assert_handles();
  H5Eset_auto1(old_handler, &seven);
  handled = 0;
  read_all();
  assert_int_equal(handled, 0);
  assert_handles();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

void whether_the_host_loads_plugins_stays(void**) {
  for (const unsigned int wanted : {0u, unsigned{H5PL_FILTER_PLUGIN}, unsigned{H5PL_ALL_PLUGIN}}) {
    unsigned int found = ~wanted, folders = 0;
    assert_true(H5PLset_loading_state(wanted) >= 0);
    read_all();
    assert_true(H5PLget_loading_state(&found) >= 0 && H5PLsize(&folders) >= 0);
    assert_true(found == wanted && folders == 1 && !std::getenv("RC_HDF5_PLUGIN_RAN"));
  }
}

size_t same(unsigned int, size_t, const unsigned int*, size_t bytes, size_t*, void**) { return bytes; }

// Calls write with a filter that the process does not have afterwards.
std::string with_filter(const std::function<std::string()>& write) {
  const H5Z_class2_t filter = {H5Z_CLASS_T_VERS, unknown_filter, 1, 1, "probe", nullptr, nullptr, same};
  assert_true(H5PLset_loading_state(0) >= 0 && H5Zregister(&filter) >= 0);
  std::string file = write();
  assert_true(H5Zunregister(unknown_filter) >= 0);
  return file;
}

void assert_not_loaded(const std::string& file, const char* words) {
  assert_true(H5PLset_loading_state(H5PL_ALL_PLUGIN) >= 0);
  refuses(file, words);
  assert_null(std::getenv("RC_HDF5_PLUGIN_RAN"));
}

void a_filter_is_not_loaded_for_a_data_set(void**) {
  assert_not_loaded(with_filter([] {
                      const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
                      H5Pset_chunk(creation, 2, shape);
                      H5Pset_filter(creation, unknown_filter, H5Z_FLAG_MANDATORY, 0, nullptr);
                      std::string file = file_with([&](hid_t to) { write_surface(to, creation); });
                      H5Pclose(creation);
                      return file;
                    }),
                    "has the filter 300 (\"probe\"), only deflate, shuffle and fletcher32");
}

// The names in a group of the file may be packed like heights. The heap that holds them says so once more by itself.
void a_filter_is_not_loaded_for_names(void**) {
  std::string file = with_filter([] {
    const hid_t creation = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_link_phase_change(creation, 0, 0);
    H5Pset_filter(creation, unknown_filter, H5Z_FLAG_MANDATORY, 0, nullptr);
    std::string written = file_with([](hid_t to) { write_surface(to); }, creation, H5F_LIBVER_EARLIEST);
    H5Pclose(creation);
    return written;
  });
  assert_not_loaded(file, "the root group has the filter 300");
  const std::string pipeline("\x0b\0\x18\0\1\0\0\0\1\1", 10);  // type, size, flags; version, number of filters
  const std::size_t at = file.find(pipeline);
  assert_true(at != std::string::npos);
  file[at] = '\0';  // a message to be passed over
  assert_not_loaded(file, "no data set");
}

int followed = 0;
hid_t follow(const char*, hid_t, const void*, std::size_t, hid_t, hid_t) { return ++followed, hid_t{-1}; }

void a_link_of_the_hosts_own_kind_is_not_followed(void**) {
  const H5L_class_t kind = {H5L_LINK_CLASS_T_VERS, user_link, "own", nullptr, nullptr, nullptr, follow, nullptr, nullptr};
  assert_true(H5Lregister(&kind) >= 0);
  const std::string file = file_with([](hid_t to) { H5Lcreate_ud(to, "surface", user_link, "x", 1, H5P_DEFAULT, H5P_DEFAULT); });
  refuses(file, "\"surface\" is a user-defined link");
  assert_int_equal(followed, 0);
}

void a_surface_may_be_read_within_a_callback_of_libhdf5(void**) {
  int calls = 0;
  file_with([&](hid_t file) {
    write_surface(file);
    const auto reading = [](hid_t, const char*, const H5L_info_t*, void* count) -> herr_t {
      reads(good());
      ++*static_cast<int*>(count);
      return 0;
    };
    assert_true(H5Literate(file, H5_INDEX_NAME, H5_ITER_INC, nullptr, reading, &calls) >= 0);
  });
  assert_int_equal(calls, 1);
}

void threads_may_read_at_the_same_time(void**) {
  assert_true(H5PLset_loading_state(H5PL_ALL_PLUGIN) >= 0);
  const std::string file = good();
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&file] {
      for (int i = 0; i < 50; ++i) reads(file);
    });
  for (std::thread& thread : threads) thread.join();
  unsigned int found = 0;
  H5PLget_loading_state(&found);
  assert_int_equal(found, H5PL_ALL_PLUGIN);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  support::set_variable("HDF5_PLUGIN_PATH", argv[1]);  // libhdf5 reads it when it starts
  H5open();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const CMUnitTest tests[] = {
      cmocka_unit_test(whether_the_host_loads_plugins_stays),
      cmocka_unit_test(a_filter_is_not_loaded_for_a_data_set),
      cmocka_unit_test(a_filter_is_not_loaded_for_names),
      cmocka_unit_test(the_hosts_handler_of_errors_stays),  // its own failing open may load plugins
      cmocka_unit_test(a_link_of_the_hosts_own_kind_is_not_followed),
      cmocka_unit_test(a_surface_may_be_read_within_a_callback_of_libhdf5),
      cmocka_unit_test(threads_may_read_at_the_same_time),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
