// Zip archives: X3P with its XML, and containers of NetCDF files. Bytes that begin as a zip archive are read as they are, others
// become an archive with the right checksums: NetCDF files the map of a container, all else main.xml, the heights and the bits
// of valid points of an X3P, each ended by a zero and a one.
#include <zlib.h>

#include "formats/readers.h"
#include "formats/zip_archive.h"
#include "reader.h"

namespace {

constexpr std::string_view part_end("\0\1", 2);

void append(std::string& file, std::uint64_t number, int bytes) {
  for (int k = 0; k < bytes; ++k, number >>= 8) file.push_back(static_cast<char>(number & 0xff));
}

// An archive of stored entries.
class Archive {
 public:
  void add(std::string_view name, std::string_view contents) {
    std::string common;
    append(common, 20, 2);  // version
    append(common, 0, 8);   // flags, stored, time and date
    append(common, crc32(0, reinterpret_cast<const Bytef*>(contents.data()), static_cast<uInt>(contents.size())), 4);
    append(common, contents.size(), 4);
    append(common, contents.size(), 4);
    append(common, name.size(), 2);
    append(common, 0, 2);  // extra field

    directory_ += "PK\1\2";
    append(directory_, 20, 2);
    directory_ += common;
    append(directory_, 0, 10);  // comment, disk, attributes
    append(directory_, file_.size(), 4);
    directory_ += name;
    file_ += "PK\3\4" + common;
    file_ += name;
    file_ += contents;
    ++entries_;
  }

  std::string finished() const {
    std::string all = file_ + directory_ + "PK\5\6";
    append(all, 0, 4);  // disks
    append(all, entries_, 2);
    append(all, entries_, 2);
    append(all, directory_.size(), 4);
    append(all, file_.size(), 4);
    append(all, 0, 2);  // comment
    return all;
  }

 private:
  std::string file_, directory_;
  std::uint64_t entries_ = 0;
};

std::string_view take_part(std::string_view& rest) {
  const auto end = std::min(rest.find(part_end), rest.size());
  const auto part = rest.substr(0, end);
  rest.remove_prefix(std::min(end + part_end.size(), rest.size()));
  return part;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest = fuzz::text(data, size);
  if (rest.starts_with("PK")) {
    rc::formats::zip_has_main_xml(rest);
    rc::formats::zip_has_netcdf(rest);
    fuzz::check_reader(rc::formats::read_x3p, rest);
    fuzz::check_reader(rc::formats::read_container, rest);
    return 0;
  }
  Archive archive;
  if (rest.starts_with("CDF")) {
    archive.add("meta.yml", "a: 1\n");
    archive.add("m.nc", rest);
    fuzz::check_reader(rc::formats::read_container, archive.finished());
    return 0;
  }
  archive.add("main.xml", take_part(rest));
  archive.add("bindata/data.bin", take_part(rest));
  archive.add("bindata/valid.bin", rest);
  fuzz::check_reader(rc::formats::read_x3p, archive.finished());
  return 0;
}
