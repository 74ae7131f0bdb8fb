// How a command ends.
#pragma once

namespace cli {

enum ExitCode { exit_certified = 0, exit_error = 1, exit_uncertified = 2, exit_cancelled = 130 };

}  // namespace cli
