#include "table.h"

#include <algorithm>
#include <cstdio>

namespace bench {

namespace {

std::string cell(const Column& column, const Json& record) {
  const auto it = record.find(column.key);
  if (it == record.end() || it->is_null()) return "";
  if (it->is_string()) return it->get<std::string>();
  char text[64];
  std::snprintf(text, sizeof text, column.format, it->get<double>());
  return text;
}

}  // namespace

std::string table(const std::vector<Column>& columns, const Json& records) {
  std::vector<std::vector<std::string>> lines(1);
  for (const Column& column : columns) lines.front().push_back(column.title);
  for (const Json& record : records) {
    lines.emplace_back();
    for (const Column& column : columns) lines.back().push_back(cell(column, record));
    if (record.contains("error")) lines.back().back() += record.at("error").get<std::string>();
  }
  std::string text;
  for (const auto& line : lines) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      std::size_t width = 0;
      for (const auto& other : lines) width = std::max(width, other[c].size());
      if (c > 0) text += "  ";
      text += std::string(width - line[c].size(), ' ') + line[c];
    }
    text += '\n';
  }
  return text;
}

}  // namespace bench
