// HDF5 through libhdf5, in a module that the command loads when it is asked for.
#include <hdf5.h>

#include "error.h"
#include "files/step_image.h"

namespace cli {

namespace {

template <class Id> Id check(Id id) {
  if (id < 0) throw Error("--write hdf5: libhdf5 failed");
  return id;
}

template <herr_t (*close)(hid_t)> class Handle {
 public:
  explicit Handle(hid_t id) : id_(check(id)) {}
  ~Handle() { close(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
};
using Properties = Handle<H5Pclose>;
using Space = Handle<H5Sclose>;
using Type = Handle<H5Tclose>;

void put(hid_t object, const std::string& name, hid_t type, const void* value) {
  const Space space{H5Screate(H5S_SCALAR)};
  const Handle<H5Aclose> attribute{H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT)};
  check(H5Awrite(attribute, type, value));
}

void put_text(hid_t object, const std::string& name, const std::string& text) {
  const Type type{H5Tcopy(H5T_C_S1)};
  check(H5Tset_size(type, text.size() + 1));
  check(H5Tset_cset(type, H5T_CSET_UTF8));
  put(object, name, type, text.c_str());
}

void put_number(hid_t object, const StepImage::Number& number) {
  if (const auto* const text = std::get_if<std::string>(&number.value)) put_text(object, number.name, *text);
  if (const auto* const whole = std::get_if<std::int64_t>(&number.value)) put(object, number.name, H5T_NATIVE_INT64, whole);
  if (const auto* const real = std::get_if<double>(&number.value)) put(object, number.name, H5T_NATIVE_DOUBLE, real);
  if (!number.unit.empty()) put_text(object, number.name + "_unit", number.unit);
}

void put_values(hid_t file, const char* name, const char* unit, const std::vector<hsize_t>& shape, const double* values) {
  const Properties untimed{H5Pcreate(H5P_DATASET_CREATE)};
  check(H5Pset_obj_track_times(untimed, false));  // the same step gives the same bytes
  const Space space{H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr)};
  const Handle<H5Dclose> set{H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, untimed, H5P_DEFAULT)};
  check(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  put_text(set, "units", unit);
}

std::vector<double> middles(std::int64_t count, double pitch) {
  std::vector<double> found;
  for (std::int64_t i = 0; i < count; ++i) found.push_back((static_cast<double>(i) + 0.5) * pitch);
  return found;
}

}  // namespace

}  // namespace cli

extern "C" [[gnu::visibility("default")]] void rc_write_step(const cli::StepImage& image, std::FILE* stream) {
  using namespace cli;
  constexpr std::size_t growth = 1 << 20;
  check(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr));  // it would print
  const Properties in_memory{H5Pcreate(H5P_FILE_ACCESS)};
  check(H5Pset_fapl_core(in_memory, growth, false));
  const Handle<H5Fclose> file{H5Fcreate("step", H5F_ACC_TRUNC, H5P_DEFAULT, in_memory)};
  const auto nx = static_cast<hsize_t>(image.nx), ny = static_cast<hsize_t>(image.ny);
  put_values(file, "x", "m", {nx}, middles(image.nx, image.hx).data());
  put_values(file, "y", "m", {ny}, middles(image.ny, image.hy).data());
  for (const StepImage::Field& field : image.fields) put_values(file, field.name, field.unit, {ny, nx}, field.values);
  for (const StepImage::Number& number : image.numbers) put_number(file, number);
  check(H5Fflush(file, H5F_SCOPE_GLOBAL));
  std::vector<char> contents(static_cast<std::size_t>(check(H5Fget_file_image(file, nullptr, 0))));
  check(H5Fget_file_image(file, contents.data(), contents.size()));
  std::fwrite(contents.data(), 1, contents.size(), stream);
}
