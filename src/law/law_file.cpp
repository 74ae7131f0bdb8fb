// roughcontact-law 1
// name value: a line for each number of the whole law and its status; then "nodes" with how many, and a line with the numbers of
// each sum and 16 hexadecimal digits: the checksum (FNV-1a, 64 bits) of all before it
#include "law/law_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/files.h"

namespace rc {

namespace {

constexpr std::string_view format_name = "roughcontact-law ";
constexpr long long newest_version = 1, most_nodes = 10'000'000;
constexpr std::uint64_t most_bytes = 4'000'000'000;  // of so many nodes

std::uint64_t checksum(std::string_view text) {
  std::uint64_t sum = 14695981039346656037u;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return sum;
}

std::string sum_line(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string line = "sum ";
  const std::uint64_t sum = checksum(text);
  for (int shift = 60; shift >= 0; shift -= 4) line += digits[(sum >> shift) & 15];
  return line + '\n';
}

// Each number of the whole law by its name.
template <class LawOrConst> auto numbers_of(LawOrConst& law) {
  auto& info = law.info;
  return std::array{std::pair{"modulus", &info.modulus},
                    std::pair{"hardness", &info.hardness},
                    std::pair{"area", &info.area},
                    std::pair{"bulk_stiffness", &info.bulk_stiffness},
                    std::pair{"mean_gap", &info.mean_gap},
                    std::pair{"tolerance", &law.tolerance},
                    std::pair{"tolerance_conductance", &law.tolerance_conductance}};
}

template <class Node> auto numbers_in(Node& node) {
  return std::array{&node.x,
                    &node.p,
                    &node.p_lower,
                    &node.p_upper,
                    &node.slope,
                    &node.slope_lower,
                    &node.slope_upper,
                    &node.energy,
                    &node.area_fraction,
                    &node.area_lower,
                    &node.area_upper,
                    &node.between_lower,
                    &node.between_upper};
}

class LawReader {
 public:
  explicit LawReader(std::string_view text) : rest_(text) {}

  std::string_view word() {
    const std::size_t begin = rest_.find_first_not_of(" \n");
    if (begin == rest_.npos) fail(RC_ERR_ARGUMENT, "the file ends too early");
    const std::size_t end = std::min(rest_.find_first_of(" \n", begin), rest_.size());
    const std::string_view found = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return found;
  }
  void expect(std::string_view name) {
    if (const std::string_view found = word(); found != name)
      fail(RC_ERR_ARGUMENT, "\"", found, "\" is there instead of \"", name, '"');
  }
  double real() {
    const std::string_view found = word();
    const std::optional<double> value = parse_real(found);
    if (!value || std::isnan(*value)) fail(RC_ERR_ARGUMENT, '"', found, "\" is not a number");
    return *value;
  }
  long long count(long long least, long long most) {
    const std::string_view found = word();
    const std::optional<long long> value = parse_int(found);
    if (!value || *value < least || *value > most)
      fail(RC_ERR_ARGUMENT, '"', found, "\" must be a number from ", least, " to ", most);
    return *value;
  }

 private:
  std::string_view rest_;
};

rc_status status_in(LawReader& reader) {
  const auto status = static_cast<rc_status>(reader.count(RC_OK, RC_UNCERTIFIED));
  if (status != RC_OK && status != RC_STOP_MAX_ITER && status != RC_STOP_STALLED && status != RC_UNCERTIFIED)
    fail(RC_ERR_ARGUMENT, "a law has no status ", status);
  return status;
}

void check_nodes(const std::vector<rc_law_point>& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const rc_law_point& node = nodes[i];
    const bool first = i == 0;
    if (first ? node.x != 0 || node.p != 0
              : !(node.x > nodes[i - 1].x && node.p >= nodes[i - 1].p && node.slope >= 0) || !std::isfinite(node.x) ||
                    !std::isfinite(node.p) || !std::isfinite(node.slope))
      fail(RC_ERR_ARGUMENT, "node ", i, " is not beyond the one before it");
  }
}

std::unique_ptr<rc_law> law_of(std::string_view text) {
  LawReader reader(text);
  if (!text.starts_with(format_name)) fail(RC_ERR_ARGUMENT, "not a file of a law: it does not begin with \"", format_name, '"');
  reader.word();
  const long long version = reader.count(1, 1'000'000);
  if (version > newest_version)
    fail(RC_ERR_ARGUMENT, "a law of version ", version, "; this library reads up to ", newest_version,
         ": a newer library is needed");
  const std::size_t end = text.rfind("sum ");
  if (end == text.npos || text.substr(end) != sum_line(text.substr(0, end)))
    fail(RC_ERR_ARGUMENT, "damaged: its checksum differs; copy it again as a binary file, or make the law again");
  auto law = std::make_unique<rc_law>();
  for (const auto& [name, number] : numbers_of(*law)) {
    reader.expect(name);
    *number = reader.real();
  }
  reader.expect("bulk");
  law->info.bulk = static_cast<std::int32_t>(reader.count(RC_LAW_BULK_NONE, RC_LAW_BULK_MEAN));
  reader.expect("solves");
  law->info.solves = reader.count(0, std::numeric_limits<long long>::max());
  std::string_view next = reader.word();
  if (next == "status") {
    law->status = status_in(reader);
    next = reader.word();
  }
  if (next != "nodes") fail(RC_ERR_ARGUMENT, "\"", next, "\" is there instead of \"nodes\"");
  const long long nodes = reader.count(2, most_nodes);
  for (long long i = 0; i < nodes; ++i) {
    rc_law_point& node = law->nodes.emplace_back(RC_LAW_POINT_INIT);
    for (double* number : numbers_in(node)) *number = reader.real();
    node.bounds = static_cast<std::int32_t>(reader.count(RC_LAW_CONVEX, RC_LAW_MONOTONE));
  }
  check_nodes(law->nodes);
  law->finish();
  return law;
}

}  // namespace

std::string text_of(const Law& law) {
  std::string text = join(format_name, newest_version, '\n');
  for (const auto& [name, number] : numbers_of(law)) text += join(name, ' ', exact(*number), '\n');
  text += join("bulk ", law.info.bulk, "\nsolves ", law.info.solves, "\nstatus ", law.status, "\nnodes ", law.nodes.size(), '\n');
  for (const rc_law_point& node : law.nodes) {
    for (const double* number : numbers_in(node)) text += exact(*number) + ' ';
    text += join(node.bounds, '\n');
  }
  return text + sum_line(text);
}

std::unique_ptr<rc_law> read_law(const char* path) {
  const std::string text = read_file(path, format_name, most_bytes);
  try {
    return law_of(text);
  } catch (const Error& error) {
    fail(error.code(), path, ": ", error.what());
  }
}

}  // namespace rc
