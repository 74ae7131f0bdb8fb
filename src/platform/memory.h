// The machine's memory, as the system reports it.
#pragma once

#include <cstddef>

namespace rc_platform {

// Bytes of the machine's memory that a process can address; infinity if the system does not say.
double machine_bytes();

// Advises large pages for these bytes, but for the parts of small pages at their ends. The system may take no notice.
void prefer_large_pages(void* begin, std::size_t bytes);

}  // namespace rc_platform
