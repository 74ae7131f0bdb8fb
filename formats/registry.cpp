#include "formats/registry.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "core/text.h"
#include "formats/error.h"
#include "formats/numbers.h"
#include "formats/readers.h"
#include "formats/wording.h"
#include "formats/zip_archive.h"

namespace rc::formats {

namespace {

template <const char*... Magic> bool begins_with(std::string_view file) { return (file.starts_with(Magic) || ...); }

constexpr char sur_plain[] = "DIGITAL SURF", sur_compressed[] = "DSCOMPRESSED";
constexpr char iso_text[] = "aISO-1.0", bcr_text[] = "aBCR-1.0", npl_text[] = "aNPL-V1.0";
constexpr char iso_binary[] = "bISO-1.0", bcr_binary[] = "bBCR-1.0";
#ifdef RC_READ_HDF5
constexpr char hdf5_magic[] = "\x89HDF";
#endif
#ifdef RC_READ_PICTURES
constexpr char png_magic[] = "\x89PNG";
#endif
constexpr char netcdf_classic[] = "CDF\1", netcdf_offsets[] = "CDF\2", netcdf_sizes[] = "CDF\5";

bool is_gsf(std::string_view file) { return file.starts_with(gsf_magic); }
#ifdef RC_READ_PICTURES
bool is_tiff(std::string_view file) {
  return file.starts_with(std::string_view("II*\0", 4)) || file.starts_with(std::string_view("MM\0*", 4));
}
#endif
bool is_npy(std::string_view file) { return file.starts_with(npy_magic); }

constexpr Format formats[] = {
    {"gsf", "Gwyddion Simple Field", ".gsf", is_gsf, "pitch and unit", read_gsf},
    {"npy", "NumPy array (ny, nx)", ".npy", is_npy, "nothing", read_npy},
    {"text", "matrix of text, also MIRCO's", ".txt .csv .tsv .dat .asc", nullptr, "in the header of some exports", read_text},
    {"xyz", "three columns of text on a regular grid", ".xyz", nullptr, "pitch", read_xyz},
    {"x3p", "ISO 25178-72 (X3P)", ".x3p", zip_has_main_xml, "pitch and unit", read_x3p},
    {"sur", "Digital Surf", ".sur", begins_with<sur_plain, sur_compressed>, "pitch and unit", read_sur},
    {"sdf", "ISO 25178-71, BCR, NPL", ".sdf .bcr", begins_with<iso_text, bcr_text, npl_text, iso_binary, bcr_binary>,
     "pitch and unit", read_sdf},
    {"plu", "Sensofar PLu, Leica DCM3D", ".plu", nullptr, "pitch and unit", read_plu},
    {"nc", "NetCDF of contact.engineering", ".nc", begins_with<netcdf_classic, netcdf_offsets, netcdf_sizes>,
     "pitch and mostly unit", read_netcdf},
    {"container", "zip archive of contact.engineering", ".zip", zip_has_netcdf, "pitch and mostly unit", read_container},
#ifdef RC_READ_HDF5
    {"hdf5", "HDF5 with a data set surface", ".h5 .hdf5", begins_with<hdf5_magic>, "nothing", read_hdf5},
#endif
#ifdef RC_READ_PICTURES
    {"tiff", "TIFF, one grey channel", ".tif .tiff", is_tiff, "nothing", read_tiff},
    {"png", "PNG, one grey channel", ".png", begins_with<png_magic>, "nothing", read_png},
#endif
};

struct Foreign {
  std::string_view begin, name;
};

// Files that instruments and programs give suffixes such as .dat and .asc, or that have other suffixes of their own.
constexpr Foreign foreign_formats[] = {
    {"\x88\x1b\x03\x6f", "MetroPro file (Zygo)"},
    {"\x88\x1b\x03\x70", "MetroPro file (Zygo)"},
    {"\x88\x1b\x03\x71", "MetroPro file (Zygo)"},
    {"Wyko ASCII", "Wyko ASCII file (Veeco, Bruker)"},
    {{"\1\0Directory", 11}, "Wyko OPD file (Veeco, Bruker)"},
    {"VCA DATA", "OPDx file (Bruker)"},
    {"\\*File list", "NanoScope file (Bruker)"},
    {"\\*Force file list", "NanoScope file (Bruker)"},
    {"VK4_", "VK4 file (Keyence)"},
    {"VK6", "VK6 file (Keyence)"},
    {"AliconaImaging", "AL3D file (Alicona)"},
    {"GWYP", "file of Gwyddion (.gwy)"},
    {"GWYO", "file of Gwyddion (.gwy)"},
    {"\x89HDF", "HDF5 file (NetCDF-4 among them, which \"nccopy -k cdf5\" converts)"},
    {"MATLAB 5.0", "file of MATLAB (.mat)"},
    {"\x89PNG", "picture (PNG), which builds with RC_READ_PICTURES read"},
    {"\xff\xd8\xff", "picture (JPEG), which has no heights"},
    {{"II*\0", 4}, "picture (TIFF), which builds with RC_READ_PICTURES read"},
    {{"MM\0*", 4}, "picture (TIFF), which builds with RC_READ_PICTURES read"},
    {"\x1f\x8b", "file packed by gzip: unpack it first"},
};

}  // namespace

std::span<const Format> surface_formats() { return formats; }

const Format& named_format(std::string_view name) {
  const auto found = std::ranges::find(formats, name, &Format::name);
  if (found != std::end(formats)) return *found;
  std::vector<std::string> names;
  std::string known;
  for (const auto& f : formats) known += (known.empty() ? "" : ", ") + names.emplace_back(f.name);
  throw Error("format: ", in_quotes(name), " is not known", suggestion(name, names), "; give one of ", known);
}

const Format& recognised_format(std::string_view file, std::string_view extension) {
  const auto by_contents = [&](const Format& f) { return f.matches && f.matches(file); };
  if (const auto found = std::ranges::find_if(formats, by_contents); found != std::end(formats)) return *found;

  const auto foreign = std::ranges::find_if(foreign_formats, [&](const Foreign& f) { return file.starts_with(f.begin); });
  if (foreign != std::end(foreign_formats) && extension != ".nc")
    throw Error("the file is a ", foreign->name, "; ", other_readers);

  const auto by_extension = [&](const Format& f) {
    const auto all = split(f.extensions, ' ');
    return std::ranges::find(all, extension) != all.end();
  };
  const auto found = std::ranges::find_if(formats, by_extension);
  if (!extension.empty() && found != std::end(formats)) return *found;

  std::string known;
  for (const auto& f : formats)
    known += (known.empty() ? "" : ", ") + std::string(f.name) + " (" + std::string(f.extensions) + ")";
  throw Error("unknown format, readable are ", known, "; give the format if it is one of them");
}

#ifndef RC_READ_HDF5
void silence_hdf5() {}
#endif

}  // namespace rc::formats
