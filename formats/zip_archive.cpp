#include "formats/zip_archive.h"

#include <algorithm>

#include "formats/error.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

constexpr std::string_view zip_magic = "PK\3\4";

// Deflate codes at most 258 bytes in 2 bits, a ratio of 1032.
constexpr std::uint64_t largest_ratio = 1032, zip_slack = 1024;

std::string message(zip_error_t& error) {
  std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  return text;
}

// macOS archivers add files of their own.
bool is_resource_fork(std::string_view name) { return name.find("__MACOSX") != std::string_view::npos; }

bool has_entry(std::string_view file, bool (*wanted)(const std::vector<std::string>&)) {
  if (!file.starts_with(zip_magic)) return false;
  try {
    return wanted(ZipArchive{file}.names());
  } catch (const Error&) {
    return false;  // the reader that the extension names says what is wrong
  }
}

}  // namespace

ZipArchive::ZipArchive(std::string_view bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (!source) throw Error("cannot be opened as a zip archive: ", message(error));
  archive_.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
  if (!archive_) {
    zip_source_free(source);
    throw Error("cannot be opened as a zip archive: ", message(error), "; it may be truncated");
  }
  zip_error_fini(&error);

  const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* const name = zip_get_name(archive_.get(), static_cast<zip_uint64_t>(i), ZIP_FL_ENC_GUESS);
    std::ranges::replace(names_.emplace_back(name ? name : ""), '\\', '/');  // as writers on Windows separate folders
  }
}

std::string ZipArchive::contents(std::size_t entry, std::uint64_t most) const {
  const std::string where = "entry " + in_quotes(names_[entry]);
  zip_stat_t stat;
  zip_stat_init(&stat);
  constexpr zip_uint64_t needed = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_COMP_METHOD;
  if (zip_stat_index(archive_.get(), entry, 0, &stat) != 0 || (stat.valid & needed) != needed) throw Error(where, " has no size");
  if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE) {
    throw Error(where, " is compressed by method ", stat.comp_method, ", only deflate can be read; pack it anew");
  }
  if (stat.comp_size > (std::uint64_t{1} << 60) || stat.size > largest_ratio * stat.comp_size + zip_slack) {
    throw Error(where, " claims ", stat.size, " bytes, more than ", stat.comp_size,
                " compressed ones can hold; the file is damaged");
  }
  if (stat.size > most) {
    throw Error(where, " unpacks to ", stat.size, " bytes, more than the ", most, " that are read of it; the file is damaged");
  }

  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> stream{zip_fopen_index(archive_.get(), entry, 0), zip_fclose};
  if (!stream) throw Error(where, " cannot be read: ", zip_strerror(archive_.get()));
  std::string bytes;
  bytes.reserve(stat.size);
  char block[1 << 16];
  zip_int64_t count = 0;
  while ((count = zip_fread(stream.get(), block, sizeof block)) > 0) {
    bytes.append(block, static_cast<std::size_t>(count));
    if (bytes.size() > stat.size) break;
  }
  if (count < 0) throw Error(where, " cannot be read: ", zip_file_strerror(stream.get()));
  if (bytes.size() != stat.size) {
    throw Error(where, " has ", bytes.size(), " bytes, its directory says ", stat.size, "; the file is damaged");
  }
  return bytes;
}

std::size_t main_xml_entry(const std::vector<std::string>& names) {
  const auto top = std::ranges::find(names, "main.xml");
  if (top != names.end()) return static_cast<std::size_t>(top - names.begin());
  const auto below =
      std::ranges::find_if(names, [](const std::string& name) { return name.ends_with("/main.xml") && !is_resource_fork(name); });
  return static_cast<std::size_t>(below - names.begin());
}

std::vector<std::size_t> netcdf_entries(const std::vector<std::string>& names) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].ends_with(".nc") && !is_resource_fork(names[i])) found.push_back(i);
  }
  return found;
}

bool zip_has_main_xml(std::string_view file) {
  return has_entry(file, [](const std::vector<std::string>& names) { return main_xml_entry(names) < names.size(); });
}

bool zip_has_netcdf(std::string_view file) {
  return has_entry(file, [](const std::vector<std::string>& names) { return !netcdf_entries(names).empty(); });
}

}  // namespace rc::formats
