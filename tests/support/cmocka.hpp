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

#undef fail  // a member of the standard streams, and of rc_host
