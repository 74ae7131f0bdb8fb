// The classic NetCDF format (CDF-1, CDF-2 and CDF-5): header and raw values. Everything is big-endian.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace rc::formats {

class NetcdfFile {
 public:
  struct Attribute {
    std::string_view name;
    std::uint32_t type;
    std::string_view values;
  };

  struct Variable {
    std::string_view name;
    std::vector<std::int64_t> shape;
    std::vector<std::string_view> dimensions;  // their names
    std::vector<Attribute> attributes;
    std::uint32_t type;
    std::string_view values;  // all of them
  };

  // Reads the header of the file, which must outlive this. Throws if it is damaged or of another kind.
  explicit NetcdfFile(std::string_view file);

  // The variable of that name, or null.
  const Variable* find(std::string_view name) const;

 private:
  std::vector<Variable> variables_;
};

// All values of a number type as doubles; an Error that names `what` for others.
std::vector<double> netcdf_numbers(std::uint32_t type, std::string_view values, std::string_view what);

// Text or the first number of an attribute; nothing if the variable does not have it (or is null).
std::string_view netcdf_text(const NetcdfFile::Variable* variable, std::string_view attribute);
std::optional<double> netcdf_number(const NetcdfFile::Variable* variable, std::string_view attribute);

// The value that marks missing values of that type if no attribute names one.
double netcdf_default_fill(std::uint32_t type);

}  // namespace rc::formats
