// Standard input, output and error: they are open from the start, and lost output is reported.
#pragma once

namespace cli {

// Opens those that are closed, so that no other file gets their numbers. Writing to them then fails.
void open_standard_streams();

// Whether everything printed was written; reports it if not.
bool finish_standard_output();

}  // namespace cli
