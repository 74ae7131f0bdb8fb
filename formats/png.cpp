// PNG of one grey channel, by libpng from memory. Its whole numbers are heights once a height range is given; gamma, and
// resolutions, which are for print, are not applied.
#include <png.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include "formats/error.h"
#include "formats/pictures.h"

namespace rc::formats {

namespace {

// The file as libpng reads it, and what it says went wrong.
struct PngSource {
  std::string_view left;
  char message[200] = "";
};

void read_png_bytes(png_structp png, png_bytep to, std::size_t size) {
  auto& source = *static_cast<PngSource*>(png_get_io_ptr(png));
  if (size > source.left.size()) png_error(png, "the file is truncated");
  std::memcpy(to, source.left.data(), size);
  source.left.remove_prefix(size);
}

[[noreturn]] void keep_png_error(png_structp png, png_const_charp text) {
  auto& message = static_cast<PngSource*>(png_get_error_ptr(png))->message;
  std::strncpy(message, text, sizeof message - 1);
  png_longjmp(png, 1);
}

void drop_png_warning(png_structp, png_const_charp) {}

class PngReader {
 public:
  explicit PngReader(std::string_view file) : source_{file} {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, keep_png_error, drop_png_warning);
    if (png_) info_ = png_create_info_struct(png_);
    if (!png_ || !info_) {
      png_destroy_read_struct(&png_, &info_, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png_, &source_, read_png_bytes);
    png_set_user_limits(png_, 0x7fffffff, 0x7fffffff);
    png_set_chunk_malloc_max(png_, most_unpacked(file.size()));
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  void read_header() {
    if (!in_png(read_info, this)) damaged();
  }
  std::int64_t nx() const { return png_get_image_width(png_, info_); }
  std::int64_t ny() const { return png_get_image_height(png_, info_); }
  int bits() const { return png_get_bit_depth(png_, info_); }
  int channels() const { return png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE ? 3 : png_get_channels(png_, info_); }

  // Rows of the machine's byte order, each at an element of `rows`.
  void read_rows(std::vector<png_bytep>& rows) {
    rows_ = rows.data();
    if (!in_png(read_image, this)) damaged();
  }

 private:
  // libpng leaves a failure by a jump, which must not pass objects of C++: work(reader) has none.
  bool in_png(void (*work)(PngReader*), PngReader* reader) {
    if (setjmp(png_jmpbuf(png_))) return false;  // NOLINT: libpng's way
    work(reader);
    return true;
  }
  static void read_info(PngReader* reader) { png_read_info(reader->png_, reader->info_); }
  static void read_image(PngReader* reader) {
    if (std::endian::native == std::endian::little && png_get_bit_depth(reader->png_, reader->info_) == 16)
      png_set_swap(reader->png_);
    png_set_interlace_handling(reader->png_);
    png_read_update_info(reader->png_, reader->info_);
    png_read_image(reader->png_, reader->rows_);
    png_read_end(reader->png_, nullptr);
  }
  [[noreturn]] void damaged() const { throw Error("the PNG file is damaged: ", source_.message); }

  PngSource source_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  png_bytep* rows_ = nullptr;
};

}  // namespace

Surface read_png(std::string_view file, const BareUnit& unit) {
  PngReader reader{file};
  reader.read_header();
  const std::int64_t nx = reader.nx(), ny = reader.ny();
  const int bits = reader.bits();
  check_picture(nx, ny, reader.channels(), bits, Samples::whole);
  std::string bytes(packed_data_size(nx, ny, static_cast<std::size_t>(bits) / 8, file.size()), '\0');
  const std::size_t row = bytes.size() / static_cast<std::size_t>(ny);
  std::vector<png_bytep> rows(static_cast<std::size_t>(ny));
  for (std::size_t iy = 0; iy < rows.size(); ++iy) rows[iy] = reinterpret_cast<png_bytep>(bytes.data() + iy * row);
  reader.read_rows(rows);
  return surface_of_picture(nx, ny, bits, Samples::whole, bytes, unit);
}

}  // namespace rc::formats
