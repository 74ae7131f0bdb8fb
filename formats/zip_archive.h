// Entries of a zip archive in memory, with libzip. Sizes are checked before memory is taken.
#pragma once

#include <zip.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rc::formats {

class ZipArchive {
 public:
  // The bytes must outlive the archive. Throws if they are no zip archive.
  explicit ZipArchive(std::string_view bytes);

  const std::vector<std::string>& names() const { return names_; }

  // The contents of the entry of that number, with the checksum checked. Throws if they are longer than `most` bytes.
  std::string contents(std::size_t entry, std::uint64_t most) const;

 private:
  struct Close {
    void operator()(zip_t* archive) const { zip_discard(archive); }
  };
  std::unique_ptr<zip_t, Close> archive_;
  std::vector<std::string> names_;
};

// Whether the bytes are a zip archive with an X3P's main.xml, or with a file *.nc.
bool zip_has_main_xml(std::string_view file);
bool zip_has_netcdf(std::string_view file);

// Number of the entry main.xml, in the top folder or below another; names().size() where there is none.
std::size_t main_xml_entry(const std::vector<std::string>& names);

// Numbers of the entries *.nc.
std::vector<std::size_t> netcdf_entries(const std::vector<std::string>& names);

}  // namespace rc::formats
