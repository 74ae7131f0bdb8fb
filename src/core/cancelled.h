// What unwinds a thread that is cancelled, for a catch clause that passes it on.
#pragma once

#include <cxxabi.h>

namespace rc {

#ifdef __GLIBCXX__
using Cancelled = abi::__forced_unwind;
#else
struct Cancelled {};  // other C++ libraries end threads without an exception
#endif

}  // namespace rc
