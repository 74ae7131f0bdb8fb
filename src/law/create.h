// Makes a law: nodes where the bounds between those that there are leave too much open.
#pragma once

#include <memory>

#include "law/law.h"

namespace rc {

struct LawMade {
  std::unique_ptr<Law> law;
  rc_status status = RC_OK;
  std::string remark;  // why the status is not RC_OK
};

// Throws Error.
LawMade create_law(const rc_system& system, const rc_options* options, const rc_law_spec& spec);

}  // namespace rc
