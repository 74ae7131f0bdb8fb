// Readers of single formats and what they share. A reader gets the whole file, and the unit of lengths for which the file names
// none. It throws an Error that says what is wrong with the file, and allocates no more than the file's size
// justifies. Missing heights are NaN.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "formats/binary.h"
#include "formats/surface.h"

namespace rc::formats {

inline constexpr std::string_view gsf_magic = "Gwyddion Simple Field 1.0\n";
inline constexpr std::string_view npy_magic = "\x93NUMPY";

inline constexpr double missing_height = std::numeric_limits<double>::quiet_NaN();

Surface read_container(std::string_view file, const BareUnit& unit);
Surface read_gsf(std::string_view file, const BareUnit& unit);
#ifdef RC_READ_HDF5
Surface read_hdf5(std::string_view file, const BareUnit& unit);
#endif
#ifdef RC_READ_PICTURES
Surface read_png(std::string_view file, const BareUnit& unit);
Surface read_tiff(std::string_view file, const BareUnit& unit);
#endif
Surface read_netcdf(std::string_view file, const BareUnit& unit);
Surface read_npy(std::string_view file, const BareUnit& unit);
Surface read_plu(std::string_view file, const BareUnit& unit);
Surface read_sdf(std::string_view file, const BareUnit& unit);
Surface read_sur(std::string_view file, const BareUnit& unit);
Surface read_text(std::string_view file, const BareUnit& unit);
Surface read_text_or_points(std::string_view file, const BareUnit& unit);  // read_xyz where the columns look like points
Surface read_x3p(std::string_view file, const BareUnit& unit);
Surface read_xyz(std::string_view file, const BareUnit& unit);

// Tells three heights of a map from points x, y, z.
enum class Columns { heights, points, unclear };
Columns kind_of_columns(const std::vector<double>& rows);

// For messages on files that no reader here reads. The Python package hands over files if a message contains it.
inline constexpr std::string_view other_readers = "Gwyddion and the Python package SurfaceTopography read more formats";

// Throws unless nx, ny >= 1 and `available` bytes hold nx*ny numbers; returns their size in bytes.
std::size_t data_size(std::int64_t nx, std::int64_t ny, std::size_t bytes_per_number, std::size_t available);

// The same where nothing may follow the data.
void check_data_size(std::int64_t nx, std::int64_t ny, std::size_t bytes_per_number, std::size_t available);

// How many bytes may be unpacked from a file of that size, and the most that its heights may take as doubles. Measured heights
// are taken to shrink to a sixty-fourth at most (deflate shrinks zeros to a thousandth), but the smallest file may hold any map
// up to 2048 x 2048.
constexpr std::uint64_t most_unpacked(std::uint64_t file_size) { return (std::uint64_t{1} << 25) + 64 * file_size; }

// Throws unless nx, ny >= 1 and a packed file of that size may hold nx*ny numbers; returns their size in bytes.
std::size_t packed_data_size(std::int64_t nx, std::int64_t ny, std::size_t bytes_per_number, std::size_t file_size);

// Metres per unit that the file names for its "heights", "pitch" or "lengths"; `unit` if the name is empty. Adds it to the
// surface's lengths. Throws if it is not a length. what: a literal.
double file_unit(Surface& surface, std::string_view what, std::string_view name, const BareUnit& unit);

// A pitch or scale in metres, stored under `key`; throws unless it is positive and finite.
double file_length(std::string_view key, double metres);

}  // namespace rc::formats
