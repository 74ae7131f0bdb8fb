// The container of contact.engineering and of the contact-mechanics challenge in HDF5: data set "surface", its first index
// along x, its second along y. It names neither pitch nor unit. libhdf5 reads it from memory.
#include <hdf5.h>

#include <mutex>
#include <string>

#include "formats/error.h"
#include "formats/readers.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

// An identifier of libhdf5, closed at the end of its scope.
class Hdf5Handle {
 public:
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t), std::string_view failure) : id_(id), close_(close) {
    if (id_ < 0) throw Error(failure);
  }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  ~Hdf5Handle() { close_(id_); }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

}  // namespace

Surface read_hdf5(std::string_view file, const BareUnit& unit) {
  constexpr std::string_view damaged = "the HDF5 file is damaged";
  static std::mutex one_at_a_time;  // libhdf5 need not be built for threads
  const std::lock_guard lock{one_at_a_time};
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // it would print

  const Hdf5Handle access{H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "libhdf5 gives no memory"};
  std::string image{file};  // libhdf5 declares it as writable
  if (H5Pset_fapl_core(access, 1 << 16, false) < 0 || H5Pset_file_image(access, image.data(), image.size()) < 0)
    throw Error("libhdf5 gives no memory");
  const Hdf5Handle opened{H5Fopen("surface", H5F_ACC_RDONLY, access), H5Fclose, damaged};
  const Hdf5Handle set{H5Dopen2(opened, "surface", H5P_DEFAULT), H5Dclose,
                       "the HDF5 file has no data set \"surface\"; if it is NetCDF-4, \"nccopy -k cdf5\" converts it; " +
                           std::string(other_readers)};
  const Hdf5Handle type{H5Dget_type(set), H5Tclose, damaged}, space{H5Dget_space(set), H5Sclose, damaged};
  const auto kind = H5Tget_class(type);
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) throw Error("the data set \"surface\" holds no numbers");
  if (const int axes = H5Sget_simple_extent_ndims(space); axes != 2)
    throw Error("the data set \"surface\" has ", axes, " dimensions, 2 are needed");
  hsize_t points[2] = {0, 0};
  H5Sget_simple_extent_dims(space, points, nullptr);

  Surface surface;
  surface.nx = static_cast<std::int64_t>(points[0]);
  surface.ny = static_cast<std::int64_t>(points[1]);
  const auto count = packed_data_size(surface.nx, surface.ny, sizeof(double), file.size()) / sizeof(double);
  std::vector<double> along_y(count);
  if (H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, along_y.data()) < 0) throw Error(damaged);
  const double metres = file_unit(surface, "heights", "", unit);
  surface.heights.reserve(count);
  for (std::int64_t iy = 0; iy < surface.ny; ++iy)
    for (std::int64_t ix = 0; ix < surface.nx; ++ix)
      surface.heights.push_back(metres * along_y[static_cast<std::size_t>(ix * surface.ny + iy)]);
  return surface;
}

}  // namespace rc::formats
