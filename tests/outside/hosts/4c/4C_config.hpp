// Stand-ins of what the law in integrations/4c uses of 4C, by the same names.
#pragma once

#include <stdexcept>
#include <string>

#define FOUR_C_NAMESPACE_OPEN namespace FourC {
#define FOUR_C_NAMESPACE_CLOSE }
#define FOUR_C_THROW(format, text) throw std::runtime_error(text)
