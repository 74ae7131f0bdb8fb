// TIFF of one grey channel, by libtiff from memory: the first picture of the file. Whole numbers are heights once a height range
// is given; floats are lengths. Resolutions are for print, and not read.
#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "formats/error.h"
#include "formats/pictures.h"

namespace rc::formats {

namespace {

// The file as libtiff reads it, and what it says went wrong.
struct TiffSource {
  std::string_view file;
  std::uint64_t at = 0;
  char message[200] = "";
};

tmsize_t read_tiff(thandle_t handle, void* to, tmsize_t size) {
  auto& source = *static_cast<TiffSource*>(handle);
  const std::uint64_t left = source.at < source.file.size() ? source.file.size() - source.at : 0;
  const std::uint64_t count = std::min<std::uint64_t>(left, static_cast<std::uint64_t>(std::max<tmsize_t>(size, 0)));
  if (count > 0) std::memcpy(to, source.file.data() + source.at, count);
  source.at += count;
  return static_cast<tmsize_t>(count);
}

tmsize_t write_tiff(thandle_t, void*, tmsize_t) { return 0; }

toff_t seek_tiff(thandle_t handle, toff_t offset, int whence) {
  auto& source = *static_cast<TiffSource*>(handle);
  source.at = offset + (whence == SEEK_CUR ? source.at : whence == SEEK_END ? source.file.size() : 0);
  return source.at;
}

int close_tiff(thandle_t) { return 0; }

toff_t size_of_tiff(thandle_t handle) { return static_cast<TiffSource*>(handle)->file.size(); }

int keep_tiff_error(TIFF*, void* source, const char*, const char* form, va_list arguments) {
  auto& message = static_cast<TiffSource*>(source)->message;
  if (*message == '\0') std::vsnprintf(message, sizeof message, form, arguments);  // the first is the cause
  return 1;
}

int drop_tiff_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

[[noreturn]] void tiff_damaged(const TiffSource& source) {
  std::string cause(source.message);
  std::ranges::replace_if(
      cause, [](char c) { return c >= 0 && c < ' '; }, ' ');
  throw Error("the TIFF file is damaged", cause.empty() ? "" : ": ", cause);
}

using Tiff = std::unique_ptr<TIFF, void (*)(TIFF*)>;

Tiff open_tiff(TiffSource& source) {
  const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options{TIFFOpenOptionsAlloc(), TIFFOpenOptionsFree};
  if (!options) throw std::bad_alloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_tiff_error, &source);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), drop_tiff_warning, nullptr);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), static_cast<tmsize_t>(most_unpacked(source.file.size())));
  Tiff tiff{TIFFClientOpenExt("TIFF", "rm", &source, read_tiff, write_tiff, seek_tiff, close_tiff, size_of_tiff, nullptr, nullptr,
                              options.get()),
            TIFFClose};
  if (!tiff) tiff_damaged(source);
  return tiff;
}

unsigned int tiff_number(TIFF* tiff, ttag_t tag) {
  std::uint16_t value = 0;
  TIFFGetFieldDefaulted(tiff, tag, &value);
  return value;
}

}  // namespace

Surface read_tiff(std::string_view file, const BareUnit& unit) {
  TiffSource source{file};
  const Tiff tiff = open_tiff(source);
  std::uint32_t nx = 0, ny = 0;
  if (!TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &nx) || !TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &ny))
    tiff_damaged(source);
  const auto bits = static_cast<int>(tiff_number(tiff.get(), TIFFTAG_BITSPERSAMPLE));
  const unsigned int kind = tiff_number(tiff.get(), TIFFTAG_SAMPLEFORMAT), colours = tiff_number(tiff.get(), TIFFTAG_PHOTOMETRIC),
                     upright = tiff_number(tiff.get(), TIFFTAG_ORIENTATION);
  if (kind != SAMPLEFORMAT_UINT && kind != SAMPLEFORMAT_VOID && kind != SAMPLEFORMAT_IEEEFP)
    throw Error("the picture has samples of format ", kind, ", read are whole numbers without a sign (1) and floats (3)");
  const Samples samples = kind == SAMPLEFORMAT_IEEEFP ? Samples::real : Samples::whole;
  check_picture(nx, ny, static_cast<int>(tiff_number(tiff.get(), TIFFTAG_SAMPLESPERPIXEL)), bits, samples);
  if (colours != PHOTOMETRIC_MINISBLACK)
    throw Error("the picture has colours (photometric interpretation ", colours, "); heights are grey, 0 the lowest (1)");
  if (upright != ORIENTATION_TOPLEFT) throw Error("the picture is turned (orientation ", upright, "); save it upright (1)");
  if (TIFFIsTiled(tiff.get())) throw Error("the picture is stored in tiles; save it in strips");

  const std::size_t size = packed_data_size(nx, ny, static_cast<std::size_t>(bits) / 8, file.size());
  const std::size_t row = size / ny;
  if (TIFFScanlineSize64(tiff.get()) != row) tiff_damaged(source);
  std::string rows(size, '\0');
  for (std::uint32_t iy = 0; iy < ny; ++iy)
    if (TIFFReadScanline(tiff.get(), rows.data() + iy * row, iy, 0) != 1) tiff_damaged(source);
  Surface surface = surface_of_picture(nx, ny, bits, samples, rows, unit);
  if (!TIFFLastDirectory(tiff.get())) surface.add_note("the first of several pictures in the file is read");
  return surface;
}

}  // namespace rc::formats
