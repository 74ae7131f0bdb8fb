// Text helpers that do not depend on the locale.
#pragma once

#include <concepts>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rc {

// A part of a text: characters, a number or an address. Characters are referred to, not copied.
class TextPart {
 public:
  TextPart(std::string_view text) : kind_(Kind::text), text_(text) {}
  TextPart(const char* text) : TextPart(std::string_view(text ? text : "(null)")) {}
  TextPart(const std::string& text) : TextPart(std::string_view(text)) {}
  TextPart(const void* address) : kind_(Kind::address), address_(address) {}
  TextPart(char letter) : kind_(Kind::letter), letter_(letter) {}
  TextPart(double real) : kind_(Kind::real), real_(real) {}
  TextPart(std::signed_integral auto number) : kind_(Kind::integer), integer_(number) {}
  TextPart(std::unsigned_integral auto number) : kind_(Kind::count), count_(number) {}

  void append_to(std::string& text) const;

 private:
  enum class Kind { text, address, letter, real, integer, count } kind_;
  union {
    std::string_view text_;
    const void* address_;
    char letter_;
    double real_;
    long long integer_;
    unsigned long long count_;
  };
};

// The value in at most so many significant digits; "inf", "nan". It does not depend on the locale.
std::string in_digits(double value, int significant);
// The value in 17 digits, which tell any two numbers apart.
inline std::string exact(double value) { return in_digits(value, 17); }

std::string joined(std::initializer_list<TextPart> parts);
// join("nx = ", nx, " must be >= 1"); real numbers in at most 12 digits.
std::string join(const auto&... parts) { return joined({TextPart(parts)...}); }

std::vector<std::string> split(std::string_view text, char separator);

// The whole text as a number, a point as the decimal mark; nothing if it is not one.
std::optional<double> parse_real(std::string_view text);
std::optional<long long> parse_int(std::string_view text);

// `; did you mean "x"?` for the nearest of the candidates, empty if none is near. Dashes at the beginning are no letters.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace rc
