#include "result_file.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "provenance.h"

namespace bench {

ResultFile::ResultFile(std::string name, const char* benchmark, std::int64_t threads) : name_(std::move(name)) {
  if (std::ifstream in(name_); !name_.empty() && in) {
    document_ = Json::parse(in, nullptr, false);
    if (document_.is_discarded() || document_.value("benchmark", "") != benchmark)
      throw std::runtime_error(name_ + " is no result of this benchmark; give another name, or remove it");
  }
  document_["benchmark"] = benchmark;
  document_["provenance"] = provenance(threads);
}

Json* ResultFile::place(const char* list, const Json& values) {
  Json& rows = document_[list];
  if (rows.is_null()) rows = Json::array();
  const auto same = [&](const Json& row) {
    return std::all_of(values.items().begin(), values.items().end(),
                       [&](const auto& item) { return row.contains(item.key()) && row.at(item.key()) == item.value(); });
  };
  const auto found = std::find_if(rows.begin(), rows.end(), same);
  return found == rows.end() ? nullptr : &*found;
}

const Json* ResultFile::find(const char* list, const Json& values) { return place(list, values); }

void ResultFile::put(const char* list, const Json& values, const Json& row) {
  if (Json* const old = place(list, values))
    *old = row;
  else
    document_[list].push_back(row);
  save();
}

void ResultFile::save() const {
  if (name_.empty()) return;
  const std::string part = name_ + ".part";
  std::ofstream out(part);
  out << document_.dump(1) << '\n';
  out.close();
  if (!out || std::rename(part.c_str(), name_.c_str()) != 0) throw std::runtime_error("cannot write " + name_);
}

}  // namespace bench
