// Records as an aligned text table.
#pragma once

#include <string>
#include <vector>

#include "child.h"

namespace bench {

struct Column {
  std::string title;
  std::string key;              // of the record; missing values stay blank
  const char* format = "%.0f";  // of numbers; text is printed as it is
};

std::string table(const std::vector<Column>& columns, const Json& records);

}  // namespace bench
