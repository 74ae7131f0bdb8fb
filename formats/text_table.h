// The numbers of a text file, row by row, and what the lines before them say.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "formats/text_header.h"

namespace rc::formats {

struct TextTable {
  TextHeader header;
  std::int64_t columns = 0, rows = 0;
  std::vector<double> values;        // [rows][columns], NaN where a field is empty or has a mark of a missing point
  std::vector<std::int64_t> lines;   // of the rows, in the file
  std::vector<std::int64_t> blocks;  // rows between blank lines
  bool more_headers = false;         // another map follows
  bool comma_pairs = true;           // every row is like "1,5"
  std::string note;
};

// Reads up to the header of a second map. points: rows are x, y, z, and messages name lines of the file.
TextTable read_table(std::string_view file, bool points);

}  // namespace rc::formats
