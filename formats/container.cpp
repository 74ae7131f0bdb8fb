// The zip archive that contact.engineering hands out: meta.yml and one NetCDF file for each measurement. The first is read.
#include "formats/error.h"
#include "formats/readers.h"
#include "formats/wording.h"
#include "formats/zip_archive.h"

namespace rc::formats {

Surface read_container(std::string_view file, const BareUnit& unit) {
  const ZipArchive archive{file};
  const auto maps = netcdf_entries(archive.names());
  if (maps.empty()) throw Error("the zip archive holds no file *.nc; unpack it and give one of its files");
  const std::string& name = archive.names()[maps.front()];
  try {
    const std::string map = archive.contents(maps.front(), most_unpacked(file.size()));
    Surface surface = read_netcdf(map, unit);
    surface.add_note(in_quotes(name) + " of the archive is read");
    if (maps.size() > 1) surface.note += join(", the first of ", maps.size(), " measurements; unpack it for the others");
    return surface;
  } catch (const Error& error) {
    throw Error(in_quotes(name), " in the archive: ", error.what());
  }
}

}  // namespace rc::formats
