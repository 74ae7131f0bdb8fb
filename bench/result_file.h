// A file of results that a later run goes on with.
#pragma once

#include <cstdint>
#include <string>

#include "child.h"

namespace bench {

class ResultFile {
 public:
  // Takes over what the file holds, if it is one of this benchmark. Without a name nothing is read or written.
  ResultFile(std::string name, const char* benchmark, std::int64_t threads);

  Json& document() { return document_; }
  // The row of a list that has these values, or null.
  const Json* find(const char* list, const Json& values);
  // Puts a row in the place of the one with these values, or at the end, and writes the file whole.
  void put(const char* list, const Json& values, const Json& row);
  void save() const;

 private:
  Json* place(const char* list, const Json& values);

  std::string name_;
  Json document_;
};

}  // namespace bench
