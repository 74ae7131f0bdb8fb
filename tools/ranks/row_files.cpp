#include "row_files.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>

#include "files/array_files.h"
#include "formats/error.h"
#include "platform/output.h"
#include "text.h"

namespace cli {

namespace {

using rc::formats::NpyLayout;

constexpr std::size_t piece_bytes = std::size_t{1} << 26;  // MPI counts in int

// A file that all ranks have open. Calls on it say what failed: by default MPI returns errors of files.
class RankFile {
 public:
  RankFile(const Communicator& ranks, const std::string& name, int mode) : name_(name) {
    const int code = MPI_File_open(ranks.get(), name.c_str(), mode, MPI_INFO_NULL, &file_);
    if (code != MPI_SUCCESS) file_ = MPI_FILE_NULL;
    ranks.together([&] { check(code, "open"); });
  }
  ~RankFile() {
    if (file_ != MPI_FILE_NULL) MPI_File_close(&file_);
  }
  RankFile(const RankFile&) = delete;
  RankFile& operator=(const RankFile&) = delete;

  MPI_File get() const { return file_; }

  void check(int code, const char* what) const {
    if (code == MPI_SUCCESS) return;
    char text[MPI_MAX_ERROR_STRING] = "";
    int length = 0;
    MPI_Error_string(code, text, &length);
    throw Error("cannot ", what, " ", in_quotes(name_), ": ", std::string_view(text, static_cast<std::size_t>(length)));
  }

  void read(std::uint64_t offset, char* bytes, std::size_t size) const {
    MPI_Status status;
    check(MPI_File_read_at(file_, static_cast<MPI_Offset>(offset), bytes, static_cast<int>(size), MPI_BYTE, &status), "read");
    int got = 0;
    MPI_Get_count(&status, MPI_BYTE, &got);
    if (static_cast<std::size_t>(got) != size) throw Error(name_, ": the file ended while it was read");
  }

  void write(std::uint64_t offset, const void* bytes, std::size_t size) const {
    MPI_Status status;
    check(MPI_File_write_at(file_, static_cast<MPI_Offset>(offset), bytes, static_cast<int>(size), MPI_BYTE, &status), "write");
    int put = 0;
    MPI_Get_count(&status, MPI_BYTE, &put);
    if (static_cast<std::size_t>(put) != size) throw Error("cannot write ", in_quotes(name_), ": the disk took a part of it");
  }

 private:
  const std::string& name_;
  MPI_File file_ = MPI_FILE_NULL;
};

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string beginning(const std::string& name, std::uint64_t& size) {
  const std::unique_ptr<std::FILE, Close> file{rc_platform::open_to_read(rc_platform::path_of(name))};
  if (!file) throw Error("cannot read ", in_quotes(name), ": ", std::strerror(errno));
  size = rc_platform::size_of(file.get());
  std::string bytes(rc::formats::npy_longest_header + 12, '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  return bytes;
}

void check_layout(const NpyLayout& layout, std::uint64_t size) {
  if (!layout.floating) throw Error("the numbers are integers, roughcontact-mpi reads float32 and float64: convert the file");
  if (layout.fortran_order)
    throw Error(
        "the file is in Fortran order, in which no rank has whole rows: write it in C order, as numpy.ascontiguousarray gives "
        "it");
  if (layout.nx < 1 || layout.ny < 1) throw Error("shape (", layout.ny, ", ", layout.nx, ") has no points");
  const auto data = size - layout.data, row = static_cast<std::uint64_t>(layout.nx) * layout.size;
  if (layout.nx > (std::int64_t{1} << 40) || data / row != static_cast<std::uint64_t>(layout.ny) || data % row != 0)
    throw Error(format("the file has %llu bytes of data, %lld x %lld points of %zu bytes need %.0f",
                       static_cast<unsigned long long>(data), static_cast<long long>(layout.nx),
                       static_cast<long long>(layout.ny), layout.size,
                       static_cast<double>(layout.nx) * static_cast<double>(layout.ny) * static_cast<double>(layout.size)));
}

}  // namespace

NpyLayout read_layout(const Communicator& ranks, const std::string& file) {
  std::uint64_t size = 0;
  std::string bytes;
  ranks.on_first([&] { bytes = beginning(file, size); });
  bytes = ranks.of_first(std::move(bytes));
  size = static_cast<std::uint64_t>(ranks.of_first(static_cast<std::int64_t>(size)));
  try {  // every rank comes to the same end
    const NpyLayout layout = rc::formats::npy_layout(bytes);
    check_layout(layout, size);
    return layout;
  } catch (const Error& error) {
    throw Error(file, ": ", error.what());
  }
}

std::vector<double> read_rows(const Communicator& ranks, const std::string& file, const NpyLayout& layout, Rows rows) {
  const RankFile source{ranks, file, MPI_MODE_RDONLY};
  std::vector<double> values;
  ranks.together([&] {
    values.resize(static_cast<std::size_t>(rows.count * layout.nx));
    std::string bytes;
    const std::size_t most = piece_bytes / layout.size;
    for (std::size_t begin = 0; begin < values.size(); begin += most) {
      const std::size_t count = std::min(most, values.size() - begin);
      bytes.resize(count * layout.size);
      source.read(layout.data + (static_cast<std::uint64_t>(rows.first * layout.nx) + begin) * layout.size, bytes.data(),
                  bytes.size());
      for (std::size_t k = 0; k < count; ++k) values[begin + k] = layout.number(bytes.data() + k * layout.size);
    }
  });
  return values;
}

void write_rows(const Communicator& ranks, const std::filesystem::path& path, std::span<const double> values, std::int64_t nx,
                std::int64_t ny, Rows rows) {
  std::optional<rc_platform::Output> output;  // on the first rank
  const auto check_output = [&] {
    if (!output->failure().empty()) throw Error("cannot write ", in_quotes(path.string()), ": ", output->failure());
  };
  ranks.on_first([&] {
    output.emplace(path);
    check_output();
  });
  const std::string name = ranks.of_first(output ? output->temporary().string() : "");
  const std::string header = npy_header(nx, ny, std::endian::native == std::endian::little ? "<f8" : ">f8");
  {
    const RankFile target{ranks, name, MPI_MODE_WRONLY};
    ranks.together([&] {
      if (ranks.first()) target.write(0, header.data(), header.size());
      const std::size_t most = piece_bytes / sizeof(double);
      for (std::size_t begin = 0; begin < values.size(); begin += most) {
        const auto part = values.subspan(begin, std::min(most, values.size() - begin));
        target.write(header.size() + (static_cast<std::uint64_t>(rows.first * nx) + begin) * sizeof(double), part.data(),
                     part.size_bytes());
      }
    });
    const int code = MPI_File_sync(target.get());
    ranks.together([&] { target.check(code, "write"); });
  }
  ranks.on_first([&] {
    output->finish();
    check_output();
  });
}

}  // namespace cli
