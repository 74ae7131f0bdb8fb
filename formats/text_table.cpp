#include "formats/text_table.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "formats/column_names.h"
#include "formats/error.h"
#include "formats/readers.h"
#include "formats/text_rows.h"
#include "formats/wording.h"

namespace rc::formats {

namespace {

struct Row {
  std::int64_t fields, line;
  bool begins_empty, ends_empty, all_empty, after_blank;
};

bool is_empty(std::string_view field) { return without_quotes(field).empty(); }

// The number in a field, NaN for a mark of a missing point; nothing for words.
std::optional<double> value_of(std::string_view field) {
  const auto value = field_number(field);
  return value || !is_missing_mark(field) ? value : missing_height;
}

// The separator between the first two fields.
char separator_of(const std::vector<std::string_view>& fields) {
  if (fields.size() < 2) return ' ';
  for (const char separator : {';', '\t', ','})
    if (std::string_view(fields[0].data(), static_cast<std::size_t>(fields[1].data() - fields[0].data())).find(separator) !=
        std::string_view::npos)
      return separator;
  return ' ';
}

class TableReader {
 public:
  explicit TableReader(bool points) : points_(points) {}

  TextTable read(std::string_view file) {
    check_text(file);
    bool other_header = false;
    while (!file.empty()) {
      const auto whole = take_whole_line(file), line = trimmed(whole);
      ++line_;
      if (line.empty() || line == "\x1a") {  // DOS ended files with the latter
        after_blank_ = true;
      } else if (line.starts_with('#')) {
        TextHeader next;
        const bool begins_map = (rows_.empty() ? table_.header : next).read_comment(trimmed(line.substr(1)));
        other_header |= begins_map && !rows_.empty();
        if (unit_after_.empty() && next.names_unit()) unit_after_ = line;
      } else if (other_header && !points_) {
        table_.more_headers = true;
        break;
      } else {
        read_line(whole);
      }
    }
    if (rows_.empty() && !suspect_.empty()) throw Error(suspect_);
    if (rows_.empty()) throw Error(points_ ? "the file has no line with three numbers" : "the file has no numbers");
    settle();
    return std::move(table_);
  }

 private:
  void read_line(std::string_view whole) {
    const auto line = trimmed(whole);
    if (rows_.empty() && table_.header.read_line(line)) return;
    auto fields = row_fields(line.find('\t') == line.npos ? line : whole);
    const char between = separator_of(fields);
    std::vector<double> values;
    std::int64_t numbers = 0;
    for (const auto field : fields) {
      const auto value = value_of(field);
      numbers += value.has_value();
      if (value || is_empty(field)) values.push_back(value.value_or(missing_height));
    }
    const bool is_row = values.size() == fields.size() && (numbers > 0 || !rows_.empty()) && !is_rule(fields);
    if (!is_row && rows_.empty()) {
      suspect_ = numbers > 0 ? not_a_row(fields) : "";
      suspect_fields_ = fields.size() - (is_empty(fields.back()) ? 1 : 0);
      if (suspect_.empty()) {
        table_.header.read_words(line);
      } else if (table_.header.unclear_unit.empty() &&
                 mentions_unit(line)) {  // "* X [mm] Y [mm]", where "*" may be a missing point
        table_.header.unclear_unit = line;
      }
      return;
    }
    if (!is_row) {  // words that end the file, or what is before the numbers
      if (words_after_.empty()) words_after_ = not_a_row(fields);
      if (numbers > 0 && damaged_.empty()) damaged_ = not_a_row(fields);
      TextHeader after;
      if (!after.read_line(line)) after.read_words(line);
      if (unit_after_.empty() && after.names_unit()) unit_after_ = line;
      after_rows_.push_back(line);
      return;
    }
    if (!words_after_.empty()) drop_preamble(std::ssize(fields));
    if (!suspect_.empty() && suspect_fields_ == fields.size() - (is_empty(fields.back()) ? 1 : 0)) damaged_ = suspect_;
    suspect_.clear();

    table_.values.insert(table_.values.end(), values.begin(), values.end());
    table_.comma_pairs &= fields.size() == 2 && line.find(',') != line.npos && line.find_first_of(" .;\t") == line.npos;
    if (rows_.empty()) separator_ = between;
    rows_.push_back({std::ssize(fields), line_, between == '\t' && is_empty(fields.front()),
                     fields.size() > 1 && is_empty(fields.back()), numbers == 0, after_blank_});
    after_blank_ = false;
  }

  // The rows so far are lines of numbers in what is before the table, "12.5, 3", if words part them from rows of another length.
  void drop_preamble(std::int64_t fields) {
    const auto fits = [fields](const Row& row) { return row.fields == fields || (row.ends_empty && row.fields == fields + 1); };
    if (points_ || std::ranges::any_of(rows_, fits)) throw Error(damaged_.empty() ? words_after_ : damaged_);
    dropped_ += std::ssize(rows_);
    rows_.clear();
    table_.values.clear();
    table_.comma_pairs = true;
    for (const std::string_view line : after_rows_)
      if (!table_.header.read_line(line)) table_.header.read_words(line);
    after_rows_.clear();
    for (std::string* const text : {&words_after_, &damaged_, &unit_after_}) text->clear();
  }

  // A line of dashes or asterisks between words and numbers.
  bool is_rule(const std::vector<std::string_view>& fields) const {
    return rows_.empty() && fields.size() == 1 && fields.front().find_first_not_of("-*") == std::string_view::npos;
  }

  // Says which field is no number.
  std::string not_a_row(const std::vector<std::string_view>& fields) const {
    const auto found = std::ranges::find_if(fields, [](std::string_view each) { return !is_empty(each) && !value_of(each); });
    const auto column = found - fields.begin();
    const bool xyz = points_ && fields.size() == 3;
    if (points_ && !xyz && (rows_.empty() || rows_.front().fields != std::ssize(fields)))
      return wrong_count(std::ssize(fields), line_);
    const std::string where = points_ ? join("line ", line_) : join("row ", std::ssize(rows_) + 1);
    return join(where, xyz ? join(": ", "xyz"[column], ' ') : join(", column ", column + 1, ": "), in_quotes(trimmed(*found)),
                " is not a number");
  }

  static std::string wrong_count(std::int64_t fields, std::int64_t line) {
    return join("line ", line, " has ", fields,
                " columns, three are needed: x, y and z; give the format text if this is a matrix");
  }

  // Drops separators at the ends of all rows, empty rows at the end, and checks that all have as many fields.
  void settle() {
    if (!damaged_.empty()) throw Error(damaged_);
    const auto given = std::ssize(rows_);
    if (dropped_ >= given)
      throw Error("words part ", dropped_, " rows of numbers from ", given, " of another length: give a file with one table");
    std::int64_t end = given;
    while (end > 1 && rows_[static_cast<std::size_t>(end - 1)].all_empty) --end;
    if (end < given) table_.note = join(given - end, " rows at the end, whose fields are all empty, are not read");
    const auto add = [this](const std::string& text) { table_.note += (table_.note.empty() ? "" : "; ") + text; };
    if (!words_after_.empty()) add("words after the numbers are not read");
    if (dropped_ > 0)
      add(join(dropped_, dropped_ == 1 ? " line of numbers before the table is" : " lines of numbers before the table are",
               " not read"));
    rows_.resize(static_cast<std::size_t>(end));

    const bool indented = std::ranges::all_of(rows_, &Row::begins_empty);
    const auto whole = std::ranges::find(rows_, false, &Row::ends_empty);
    const std::int64_t first = indented ? 1 : 0;
    const std::int64_t last = whole == rows_.end() ? rows_.front().fields - 1 : whole->fields;
    table_.columns = last - first;
    std::size_t from = 0, to = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Row& row = rows_[i];
      if (row.fields != last && !(row.ends_empty && row.fields == last + 1)) refuse_count(static_cast<std::int64_t>(i) + 1, row);
      for (std::int64_t k = first; k < last; ++k) table_.values[to++] = table_.values[from + static_cast<std::size_t>(k)];
      from += static_cast<std::size_t>(row.fields);
      if (row.after_blank || table_.blocks.empty()) table_.blocks.push_back(0);
      ++table_.blocks.back();
      table_.lines.push_back(row.line);
    }
    table_.values.resize(to);
    table_.rows = end;
    table_.header.settle_columns(table_.columns, separator_);
    if (table_.header.unclear_unit.empty()) table_.header.unclear_unit = unit_after_;
  }

  [[noreturn]] void refuse_count(std::int64_t number, const Row& row) const {
    if (points_) throw Error(wrong_count(row.fields, row.line));
    const bool parted = row.after_blank && number > 1;
    throw Error("row ", number, parted ? ", after a blank line," : "", " has ", row.fields, " values, expected ",
                std::max<std::int64_t>(table_.columns, 1), " as in row 1", parted ? "; give a file with one map" : "");
  }

  bool points_;
  TextTable table_;
  std::vector<Row> rows_;
  std::int64_t line_ = 0;
  char separator_ = ' ';
  bool after_blank_ = false;
  std::string suspect_, words_after_;  // what is wrong with the last line before the rows that has numbers; with one after them
  std::string damaged_;                // with one after them that has numbers
  std::vector<std::string_view> after_rows_;
  std::int64_t dropped_ = 0;  // rows of the preamble
  std::string unit_after_;    // the first line after the rows that names a unit
  std::size_t suspect_fields_ = 0;
};

}  // namespace

TextTable read_table(std::string_view file, bool points) { return TableReader{points}.read(file); }

}  // namespace rc::formats
