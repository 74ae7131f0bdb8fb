// cmocka for C++ tests.
#pragma once

extern "C" {
// clang-format off
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
// clang-format on
}
#undef fail  // the name of a member function of every stream
