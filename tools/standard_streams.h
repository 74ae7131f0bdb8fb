// Standard output: what it lost is reported.
#pragma once

namespace cli {

// Whether everything printed was written; reports it if not.
bool finish_standard_output();

}  // namespace cli
