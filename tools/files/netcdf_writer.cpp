// NetCDF-4, which is HDF5, through libnetcdf, in a module that the command loads when it is asked for.
#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "files/step_image.h"
#include "formats/error.h"

namespace cli {

namespace {

void check(int status) {
  if (status != NC_NOERR) throw rc::formats::Error(std::string("--write: ") + nc_strerror(status));
}

void put_text(int file, int variable, const std::string& name, const std::string& text) {
  // An empty text is a NUL, because HDF5 would have an attribute without a value.
  check(nc_put_att_text(file, variable, name.c_str(), std::max<std::size_t>(text.size(), 1), text.c_str()));
}

void put_number(int file, const StepImage::Number& number) {
  const char* const name = number.name.c_str();
  if (const auto* const text = std::get_if<std::string>(&number.value)) put_text(file, NC_GLOBAL, name, *text);
  if (const auto* const whole = std::get_if<std::int64_t>(&number.value)) {
    const long long value = *whole;
    check(nc_put_att_longlong(file, NC_GLOBAL, name, NC_INT64, 1, &value));
  }
  if (const auto* const real = std::get_if<double>(&number.value))
    check(nc_put_att_double(file, NC_GLOBAL, name, NC_DOUBLE, 1, real));
  if (!number.unit.empty()) put_text(file, NC_GLOBAL, number.name + "_unit", number.unit);
}

// A file in memory; its contents are taken out once.
class File {
 public:
  File() { check(nc_create_mem("step", NC_NETCDF4, 0, &id_)); }
  ~File() {
    if (open_) nc_abort(id_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  int id() const { return id_; }
  NC_memio close() {
    NC_memio contents{};
    open_ = false;
    check(nc_close_memio(id_, &contents));
    return contents;
  }

 private:
  int id_ = 0;
  bool open_ = true;
};

// The middles of the cells along an axis.
void put_axis(int file, const char* name, int dimension, std::int64_t count, double pitch) {
  int variable = 0;
  check(nc_def_var(file, name, NC_DOUBLE, 1, &dimension, &variable));
  put_text(file, variable, "units", "m");
  std::vector<double> middles;
  for (std::int64_t i = 0; i < count; ++i) middles.push_back((static_cast<double>(i) + 0.5) * pitch);
  check(nc_put_var_double(file, variable, middles.data()));
}

}  // namespace

}  // namespace cli

extern "C" [[gnu::visibility("default")]] void rc_write_step(const cli::StepImage& image, std::FILE* stream) {
  using namespace cli;
  File file;
  int dimensions[2];
  check(nc_def_dim(file.id(), "y", static_cast<std::size_t>(image.ny), &dimensions[0]));
  check(nc_def_dim(file.id(), "x", static_cast<std::size_t>(image.nx), &dimensions[1]));
  put_axis(file.id(), "x", dimensions[1], image.nx, image.hx);
  put_axis(file.id(), "y", dimensions[0], image.ny, image.hy);
  for (const StepImage::Field& field : image.fields) {
    int variable = 0;
    check(nc_def_var(file.id(), field.name, NC_DOUBLE, 2, dimensions, &variable));
    put_text(file.id(), variable, "units", field.unit);
    check(nc_put_var_double(file.id(), variable, field.values));
  }
  for (const StepImage::Number& number : image.numbers) put_number(file.id(), number);
  const NC_memio contents = file.close();
  const std::unique_ptr<void, decltype(&std::free)> memory{contents.memory, std::free};
  std::fwrite(contents.memory, 1, contents.size, stream);
}
