// The exception that unwinds a cancelled thread, for a catch clause that rethrows it.
#pragma once

#include <cxxabi.h>

namespace rc {

#ifdef __GLIBCXX__
using Cancelled = abi::__forced_unwind;
#else
struct Cancelled {};  // other C++ libraries end threads without an exception
#endif

}  // namespace rc
