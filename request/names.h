// Names of other folders that this one uses as its own.
#pragma once

#include "formats/error.h"
#include "formats/numbers.h"
#include "formats/wording.h"

namespace rc::request {

// Declared one by one: the core has an Error and a split of its own.
using formats::Error;
using formats::finite_number;
using formats::format;
using formats::in_quotes;
using formats::leading_number;
using formats::lower_case;
using formats::split;
using formats::to_integer;
using formats::to_number;
using formats::trimmed;

}  // namespace rc::request
