#include "request/history.h"

#include <fstream>

#include "core/error.h"
#include "platform/files.h"
#include "request/choices.h"
#include "request/names.h"

namespace rc::request {

namespace {

constexpr std::string_view column_names[] = {"approach", "load", "pressure", "area", "time"};

std::vector<std::string_view> fields_of(std::string_view line) {
  for (const char separator : {';', '\t'})
    if (line.find(separator) != line.npos) return split(line, separator);
  return split(line, ',');
}

// "time [s]": the name and the unit of the numbers below it, "" if it has none.
struct Column {
  std::string_view name, unit;
};

Column column_of(std::string_view head) {
  const auto open = head.find('['), close = head.find(']');
  if (open == head.npos || close == head.npos || close < open) return {trimmed(head), ""};
  return {trimmed(head.substr(0, open)), trimmed(head.substr(open + 1, close - open - 1))};
}

std::string contents(const std::string& where, const char* file) {
  constexpr std::size_t most = 1 << 26;
  std::ifstream stream(rc_platform::path_of(file), std::ios::binary);
  if (!stream) throw Error(where, " cannot be opened");
  std::string text;
  char block[1 << 16];
  while (stream.read(block, sizeof block), stream.gcount() > 0) {
    text.append(block, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > most) throw Error(where, " has more than ", most, " bytes");
  }
  if (stream.bad()) throw Error(where, " cannot be read");
  return text;
}

// Ratios and times of a series, checked.
void add_term(const std::string& where, double ratio, double time, rc_request& request) {
  if (!(ratio >= 0)) throw Error(where, ": the ratio ", ratio, " is negative");
  if (!(time > 0)) throw Error(where, ": the time ", time, " is not positive");
  request.creep_ratio.push_back(ratio);
  request.creep_time.push_back(time);
}

void read_terms(const std::string& where, std::string_view text, rc_request& request) {
  std::vector<std::string_view> ratios, times;
  for (const std::string_view each : split(text, ',')) {
    const auto colon = each.find(':');
    if (colon == each.npos) throw Error(where, ": ", in_quotes(each), " has not the form RATIO:TIME");
    ratios.push_back(each.substr(0, colon));
    times.push_back(each.substr(colon + 1));
  }
  const auto read_times = read_quantities(where, times, Dimension::time);
  for (std::size_t k = 0; k < ratios.size(); ++k)
    add_term(where, read_quantity(where, ratios[k], Dimension::share).si(), read_times[k].si(), request);
}

}  // namespace

void set_creep(const Words& words, rc_request& request) {
  const Given *const compliances = words.find("creep"), *const moduli = words.find("relaxation");
  if (compliances && moduli)
    throw Error("give either ", words.spelt("creep"), " or ", words.spelt("relaxation"),
                ", not both: they say the same in two ways");
  const Given* const given = compliances ? compliances : moduli;
  if (!given) return;
  const std::string where = words.spelt(given->name);
  if (given->text) {
    read_terms(where, given->text, request);
  } else {
    if (given->numbers.size() % 2 != 0)
      throw Error(where, " has ", given->numbers.size(), " numbers, pairs of ratio and time are needed");
    for (std::size_t k = 0; k + 1 < given->numbers.size(); k += 2)
      add_term(where, given->numbers[k], given->numbers[k + 1], request);
  }
  double sum = 0;
  for (const double ratio : request.creep_ratio) sum += ratio;
  if (moduli && !(sum < 1)) throw Error(where, ": the ratios sum up to ", sum, ", of a solid they are below 1");
  rc_system& system = request.view.system;
  system.creep_by = moduli ? RC_CREEP_MODULI : RC_CREEP_COMPLIANCES;
  system.creep_terms = static_cast<std::int32_t>(request.creep_ratio.size());
  system.creep_ratio = RC_IN(request.creep_ratio.data());
  system.creep_time = RC_IN(request.creep_time.data());
}

StepTable step_table(const Words& words) {
  StepTable table;
  const Given* const given = words.find("steps");
  if (!given) return table;
  table.file = join(words.spelt("steps"), ": ", given->shown());
  const std::string text = contents(table.file, given->text);
  std::vector<Column> columns;
  std::int64_t number = 0;
  for (std::string_view line : split(text, '\n')) {
    ++number;
    line = trimmed(line);
    if (line.empty() || line.starts_with('#')) continue;
    const auto fields = fields_of(line);
    const std::string here = join(table.file, ", line ", number);
    if (columns.empty()) {
      for (const std::string_view head : fields) {
        columns.push_back(column_of(head));
        const std::string name(column_names[choice(here, columns.back().name, column_names)]);
        if (name != "time" && !table.loading.empty())
          throw Error(here, " has both ", table.loading, " and ", name, ", give one of them");
        if (name != "time") table.loading = name;
      }
      if (table.loading.empty()) throw Error(here, " names no column approach, load, pressure or area");
      continue;
    }
    if (fields.size() != columns.size()) throw Error(here, " has ", fields.size(), " values, ", columns.size(), " are needed");
    for (std::size_t k = 0; k < fields.size(); ++k) {
      std::string& texts = columns[k].name == "time" ? table.times : table.targets;
      texts += join(texts.empty() ? "" : ",", trimmed(fields[k]), to_number(trimmed(fields[k])) ? columns[k].unit : "");
    }
  }
  if (table.targets.empty()) throw Error(table.file, " has no step");
  return table;
}

void set_times(const Words& words, const StepTable& table, bool needed, rc_request& request) {
  const bool creeps = request.view.system.creep_terms > 0, batch = words.call == RC_CALL_BATCH;
  const bool of_table = !table.times.empty();
  const Given column = StepTable::as_word("time", table.times);
  const Given* const given = of_table ? &column : words.find("time");
  const std::string time = words.spelt("time");
  if (of_table && words.find("time")) throw Error(table.file, " has times, and ", time, " is given; leave it out");
  if (!given) {
    if (needed && creeps && !batch) throw Error(time, " is missing: the bodies creep, so that each step needs its time");
    return;
  }
  if (needed && !creeps)
    throw Error(time, " is of bodies that creep, give ", words.spelt("creep"), " or ", words.spelt("relaxation"));
  for (const Quantity& each : words.quantities(*given, Dimension::time)) request.times.push_back(each.si());
  if (batch) return;
  std::vector<double>&times = request.times, &targets = request.targets;
  if (targets.size() == 1) targets.resize(times.size(), targets.front());
  if (targets.size() != times.size())
    throw Error(time, " has ", times.size(), " values, ", words.spelt(request.loading), " ", targets.size(),
                ": one time for each step is needed");
  for (std::size_t k = 1; k < times.size(); ++k)
    if (times[k] < times[k - 1])
      throw Error(time, ": step ", k + 1, " is at ", times[k], ", before step ", k, " at ", times[k - 1],
                  "; bodies that creep have no way back");
}

}  // namespace rc::request
