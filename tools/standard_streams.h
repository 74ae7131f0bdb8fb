// Standard input, output and error: open from the start, and an output that was lost does not go unnoticed.
#pragma once

namespace cli {

// Opens those that are closed, so that no file of ours gets their numbers. What is written to them is lost, as an error.
void open_standard_streams();

// Whether all that was printed went out; otherwise reports it.
bool finish_standard_output();

}  // namespace cli
