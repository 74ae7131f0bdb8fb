// Preloaded into a program: writes a digest of every answer that the library returns to it.
// RC_DIGESTS names a folder. Each process appends to one file there, a line per answer: function, status, counts, hash of all
// numbers.
#include <dlfcn.h>
#include <fcntl.h>
#include <roughcontact/history.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

namespace {

// FNV-1a over bytes.
class Hash {
 public:
  void add_bytes(const void* data, std::size_t bytes) {
    const auto* byte = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i) value_ = (value_ ^ byte[i]) * 1099511628211U;
  }
  void add(double value) { add_bytes(&value, sizeof value); }
  void add(const double* values, std::int64_t n) {
    if (values && n > 0) add_bytes(values, static_cast<std::size_t>(n) * sizeof(double));
  }
  unsigned long long value() const { return value_; }

 private:
  unsigned long long value_ = 14695981039346656037U;
};

// The command line names the program: options decide what it solves.
std::string file_name() {
  std::ifstream in("/proc/self/cmdline", std::ios::binary);
  const std::string line{std::istreambuf_iterator<char>(in), {}};
  Hash hash;
  std::string kept;
  for (std::size_t begin = 0; begin < line.size(); begin += std::strlen(line.c_str() + begin) + 1) {
    const std::string word = line.c_str() + begin;
    kept += (word.find('/') == std::string::npos ? word : word.substr(word.rfind('/') + 1)) + ' ';
  }
  hash.add_bytes(kept.data(), kept.size());
  char digits[32];
  std::snprintf(digits, sizeof digits, "-%016llx", hash.value());
  return kept.substr(0, kept.find(' ')) + digits;
}

void write(const char* function, rc_status status, long long first, long long second, const Hash& hash) {
  const char* const folder = std::getenv("RC_DIGESTS");
  if (!folder) return;
  static const int file = open((std::string(folder) + "/" + file_name()).c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  char line[200];
  const int size = std::snprintf(line, sizeof line, "%s %s %lld %lld %016llx\n", function, rc_status_name(status), first, second,
                                 hash.value());
  if (file >= 0 && ::write(file, line, static_cast<std::size_t>(size)) < 0) return;
}

template <class Function> Function next(const char* name) { return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name)); }

void write(const char* function, rc_status status, const rc_result* result) {
  if (status < 0 || !result || result->struct_size < sizeof(rc_result)) return write(function, status, 0, 0, {});
  Hash hash;
  for (const double value : {result->approach, result->load, result->energy, result->kkt_primal, result->kkt_dual,
                             result->kkt_complementarity, result->load_lower, result->load_upper, result->stiffness})
    hash.add(value);
  hash.add(static_cast<double*>(result->p.data), result->points);
  hash.add(static_cast<double*>(result->gap.data), result->points);
  write(function, status, result->products, result->contacts, hash);
}

}  // namespace

extern "C" {

RC_API rc_status rc_solve(const rc_system* system, const rc_step* step, const rc_options* options, rc_result* result) {
  static const auto real = next<decltype(&rc_solve)>("rc_solve");
  const rc_status status = real(system, step, options, result);
  write("solve", status, result);
  return status;
}

RC_API rc_status rc_contact_solve(rc_contact* contact, const rc_step* step, rc_result* result) {
  static const auto real = next<decltype(&rc_contact_solve)>("rc_contact_solve");
  const rc_status status = real(contact, step, result);
  write("step", status, result);
  return status;
}

RC_API rc_status rc_contact_certify(rc_contact* contact, const rc_step* step, rc_result* result) {
  static const auto real = next<decltype(&rc_contact_certify)>("rc_contact_certify");
  const rc_status status = real(contact, step, result);
  write("certify", status, result);
  return status;
}

RC_API rc_status rc_contact_solve_history(rc_contact* contact, rc_history* path) {
  static const auto real = next<decltype(&rc_contact_solve_history)>("rc_contact_solve_history");
  const rc_status status = real(contact, path);
  Hash hash;
  for (const rc_array& values : {path->columns.load, path->columns.approach, path->columns.contact_area, path->columns.stiffness})
    hash.add(static_cast<double*>(values.data), path->completed);
  write("path", status, path->completed, path->n, hash);
  return status;
}

RC_API rc_status rc_batch_solve(const rc_system* system, const rc_options* options, rc_batch* batch) {
  static const auto real = next<decltype(&rc_batch_solve)>("rc_batch_solve");
  const rc_status status = real(system, options, batch);
  Hash hash;
  if (status >= 0) {
    for (const rc_array& values : {batch->columns.load, batch->columns.approach, batch->columns.contact_area})
      hash.add(static_cast<double*>(values.data), batch->n * batch->steps);
    hash.add(static_cast<double*>(batch->p.data), batch->n * system->nx * system->ny);
  }
  write("batch", status, batch->n, batch->steps, hash);
  return status;
}

}  // extern "C"
