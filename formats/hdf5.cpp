// The container of contact.engineering and of the contact-mechanics challenge in HDF5: data set "surface", its first index
// along x, its second along y. It names neither pitch nor unit. libhdf5 reads it from memory. What leads out of the file or to
// code that libhdf5 would load is refused: heights in other files, links that are not hard, filters that libhdf5 has not always.
#include <hdf5.h>
#include <zlib.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <mutex>
#include <string>
#include <vector>

#include "formats/error.h"
#include "formats/readers.h"
#include "formats/registry.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

constexpr const char* hdf5_damaged = "the HDF5 file is damaged";

// An identifier of libhdf5, closed at the end of its scope.
class Hdf5Handle {
 public:
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t), std::string_view failure = hdf5_damaged) : id_(id), close_(close) {
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

// Keeps libhdf5 from loading plugins while a file is read: a file names filters, and the environment the folder of their code.
class NoPlugins {
 public:
  NoPlugins() {
    try {
      unsigned int left = 1;
      if (H5PLget_loading_state(&before_) < 0 || H5PLset_loading_state(0) < 0 || H5PLget_loading_state(&left) < 0 || left != 0 ||
          !forget_folders())
        throw Error("libhdf5 cannot be kept from loading plugins");
    } catch (...) {
      restore();
      throw;
    }
  }
  NoPlugins(const NoPlugins&) = delete;
  NoPlugins& operator=(const NoPlugins&) = delete;
  ~NoPlugins() { restore(); }

 private:
  // libhdf5 1.14 tries every plugin of these folders on a file that it cannot open, whatever it may load.
  bool forget_folders() {
    unsigned int count = 0;
    while (H5PLsize(&count) >= 0) {
      if (count == 0) return true;
      const auto length = H5PLget(0, nullptr, 0);
      if (length < 0) return false;
      folders_.emplace_back(static_cast<std::size_t>(length) + 1, '\0');
      if (H5PLget(0, folders_.back().data(), folders_.back().size()) < 0 || H5PLremove(0) < 0) {
        folders_.pop_back();
        return false;
      }
    }
    return false;
  }
  void restore() {
    for (const std::string& folder : folders_) H5PLappend(folder.c_str());
    H5PLset_loading_state(before_);
  }

  unsigned int before_ = 0;
  std::vector<std::string> folders_;
};

void hdf5_check(bool sound) {
  if (!sound) throw Error(hdf5_damaged);
}

// The filters in the order in which they were applied, each at most once.
std::vector<H5Z_filter_t> filters_of(hid_t creation, std::string_view what) {
  constexpr H5Z_filter_t known[] = {H5Z_FILTER_DEFLATE, H5Z_FILTER_SHUFFLE, H5Z_FILTER_FLETCHER32};
  std::vector<H5Z_filter_t> filters;
  const int count = H5Pget_nfilters(creation);
  hdf5_check(count >= 0);
  for (int k = 0; k < count; ++k) {
    unsigned int flags = 0;
    std::size_t parameters = 0;
    char name[80] = "";
    const H5Z_filter_t filter =
        H5Pget_filter2(creation, static_cast<unsigned int>(k), &flags, &parameters, nullptr, sizeof name - 1, name, nullptr);
    if (std::ranges::find(known, filter) == std::end(known)) {
      throw Error(what, " has the filter ", filter, " (", in_quotes(name),
                  "), only deflate, shuffle and fletcher32 are read; write the file anew with \"h5repack -f GZIP=6\"");
    }
    hdf5_check(std::ranges::find(filters, filter) == filters.end());
    filters.push_back(filter);
  }
  return filters;
}

// The data set's name must lead to it within the file: other links may open files or call code of the host.
void check_hdf5_link(hid_t file) {
  const Hdf5Handle root{H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose};
  filters_of(Hdf5Handle{H5Gget_create_plist(root), H5Pclose}, "the root group");
  H5L_info_t link;
  if (H5Lget_info(root, "surface", &link, H5P_DEFAULT) < 0) {
    throw Error("the HDF5 file has no data set \"surface\"; if it is NetCDF-4, \"nccopy -k cdf5\" converts it; ", other_readers);
  }
  if (link.type == H5L_TYPE_HARD) return;
  throw Error("\"surface\" is ",
              link.type == H5L_TYPE_SOFT       ? "a soft link"
              : link.type == H5L_TYPE_EXTERNAL ? "an external link"
                                               : "a user-defined link",
              ", only a data set itself is read; copy it under this name with \"h5copy\"");
}

void check_hdf5_layout(hid_t creation) {
  if (const int others = H5Pget_external_count(creation); others != 0) {
    char name[80] = "";
    hdf5_check(others > 0 && H5Pget_external(creation, 0, sizeof name - 1, name, nullptr, nullptr) >= 0);
    throw Error("the heights of the data set \"surface\" are in another file (external storage), ", in_quotes(name),
                ", which is not read; copy them into one file with \"h5repack\"");
  }
  const auto layout = H5Pget_layout(creation);
  if (layout == H5D_VIRTUAL) {
    throw Error(
        "the data set \"surface\" is virtual, it refers to other data sets and files, which are not read; copy the heights "
        "into one data set");
  }
  hdf5_check(layout == H5D_COMPACT || layout == H5D_CONTIGUOUS || layout == H5D_CHUNKED);
}

// How many bytes a zlib stream unpacks to, `most` + 1 if they are more.
std::size_t inflated_size(std::vector<unsigned char>& packed, std::size_t most) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) throw std::bad_alloc();
  stream.next_in = packed.data();
  stream.avail_in = static_cast<uInt>(packed.size());
  unsigned char block[1 << 14];
  std::size_t size = 0;
  int status = Z_OK;
  while (status == Z_OK && size <= most) {
    stream.next_out = block;
    stream.avail_out = sizeof block;
    status = inflate(&stream, Z_NO_FLUSH);
    size += sizeof block - stream.avail_out;
  }
  inflateEnd(&stream);
  if (size > most) return most + 1;
  hdf5_check(status == Z_STREAM_END);
  return size;
}

// libhdf5 takes the memory for whole chunks, and for whatever their streams unpack to.
void check_hdf5_chunks(hid_t set, hid_t creation, const Surface& surface, std::size_t bytes_per_number, std::size_t file_size) {
  constexpr std::size_t checksum_size = 4;
  constexpr std::size_t few_chunks = 1 << 16,
                        bytes_per_chunk = 16;  // what is stored of one takes more; looking for one takes long
  const auto filters = filters_of(creation, "the data set \"surface\"");
  hsize_t chunk[2] = {0, 0};
  hdf5_check(H5Pget_chunk(creation, 2, chunk) == 2 && chunk[0] > 0 && chunk[1] > 0);
  const auto chunks_along = [](std::int64_t points, hsize_t step) { return (points - 1) / static_cast<std::int64_t>(step) + 1; };
  const std::int64_t along_x = chunks_along(surface.nx, chunk[0]), along_y = chunks_along(surface.ny, chunk[1]);
  packed_data_size(along_x * static_cast<std::int64_t>(chunk[0]), along_y * static_cast<std::int64_t>(chunk[1]), bytes_per_number,
                   file_size);
  const std::size_t most = few_chunks + file_size / bytes_per_chunk;
  if (const auto chunks = static_cast<std::size_t>(along_x * along_y); chunks > most)
    throw Error("the data set \"surface\" has ", chunks, " chunks, more than the ", most, " that are read of a file of ",
                file_size, " bytes; write the file anew with \"h5repack -l CONTI\"");
  const std::size_t size = chunk[0] * chunk[1] * bytes_per_number;

  std::vector<unsigned char> stored;
  std::uint64_t all = 0;
  for (hsize_t x = 0; x < static_cast<hsize_t>(surface.nx); x += chunk[0]) {
    for (hsize_t y = 0; y < static_cast<hsize_t>(surface.ny); y += chunk[1]) {
      const hsize_t at[2] = {x, y};
      hsize_t length = 0;
      // A chunk that was never written has the fill value. Some releases fail on it, and on what reading will find damaged.
      if (H5Dget_chunk_storage_size(set, at, &length) < 0 || length == 0) continue;
      hdf5_check(length <= file_size - all);
      all += length;
      std::uint32_t skipped = 0;
      stored.resize(length);
      hdf5_check(H5Dread_chunk(set, H5P_DEFAULT, at, &skipped, stored.data()) >= 0);
      std::size_t left = length;
      for (std::size_t k = filters.size(); k-- > 0;) {
        if (skipped >> k & 1) continue;
        if (filters[k] == H5Z_FILTER_DEFLATE) left = inflated_size(stored, size + checksum_size);
        if (filters[k] == H5Z_FILTER_FLETCHER32) left -= std::min(left, checksum_size);
      }
      if (left != size)
        throw Error("the chunk at ", x, ", ", y, " does not hold the ", size, " bytes of its size; the HDF5 file is damaged");
    }
  }
}

Surface read_data_set(std::string_view file, const BareUnit& unit) {
  const NoPlugins no_plugins;
  constexpr std::string_view no_memory = "libhdf5 gives no memory";
  const Hdf5Handle access{H5Pcreate(H5P_FILE_ACCESS), H5Pclose, no_memory};
  std::string image{file};  // libhdf5 declares it as writable
  if (H5Pset_fapl_core(access, 1 << 16, false) < 0 || H5Pset_file_image(access, image.data(), image.size()) < 0)
    throw Error(no_memory);
  const Hdf5Handle opened{H5Fopen("surface", H5F_ACC_RDONLY, access), H5Fclose};
  check_hdf5_link(opened);
  const Hdf5Handle set{H5Dopen2(opened, "surface", H5P_DEFAULT), H5Dclose,
                       "\"surface\" is no data set, or the HDF5 file is damaged"};
  const Hdf5Handle creation{H5Dget_create_plist(set), H5Pclose};
  check_hdf5_layout(creation);
  const Hdf5Handle type{H5Dget_type(set), H5Tclose}, space{H5Dget_space(set), H5Sclose};
  const auto kind = H5Tget_class(type);
  const std::size_t bytes_per_number = H5Tget_size(type);
  if ((kind != H5T_FLOAT && kind != H5T_INTEGER) || bytes_per_number > sizeof(long double))
    throw Error("the data set \"surface\" holds no numbers");
  if (const int axes = H5Sget_simple_extent_ndims(space); axes != 2)
    throw Error("the data set \"surface\" has ", axes, " dimensions, 2 are needed");
  hsize_t points[2] = {0, 0};
  hdf5_check(H5Sget_simple_extent_dims(space, points, nullptr) == 2 && bytes_per_number > 0);

  Surface surface;
  constexpr hsize_t most = std::numeric_limits<std::int64_t>::max();
  surface.nx = static_cast<std::int64_t>(std::min(points[0], most));
  surface.ny = static_cast<std::int64_t>(std::min(points[1], most));
  const auto count = packed_data_size(surface.nx, surface.ny, sizeof(double), file.size()) / sizeof(double);
  if (H5Pget_layout(creation) == H5D_CHUNKED)
    check_hdf5_chunks(set, creation, surface, bytes_per_number, file.size());
  else if (const hsize_t stored = H5Dget_storage_size(set); stored != count * bytes_per_number)
    throw Error("the header says ", surface.nx, " x ", surface.ny, " points, but the data set \"surface\" has ", stored,
                " bytes, not ", bytes_per_number, " for each");
  std::vector<double> along_y(count);
  hdf5_check(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, along_y.data()) >= 0);
  const double metres = file_unit(surface, "heights", "", unit);
  surface.heights.reserve(count);
  for (std::int64_t iy = 0; iy < surface.ny; ++iy)
    for (std::int64_t ix = 0; ix < surface.nx; ++ix)
      surface.heights.push_back(metres * along_y[static_cast<std::size_t>(ix * surface.ny + iy)]);
  return surface;
}

}  // namespace

void silence_hdf5() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

// libhdf5 prints errors as its host has set; they are silent here, and the host's setting is restored.
Surface read_hdf5(std::string_view file, const BareUnit& unit) {
  static std::mutex one_at_a_time;  // libhdf5 need not be built for threads, and its settings are the process's
  const std::lock_guard lock{one_at_a_time};
  Surface surface;
  std::exception_ptr failure;
  H5E_BEGIN_TRY {
    try {
      surface = read_data_set(file, unit);
    } catch (...) {
      failure = std::current_exception();
    }
  }
  H5E_END_TRY
  if (failure) std::rethrow_exception(failure);
  return surface;
}

}  // namespace rc::formats
