// A law for people and for programs: facts and rows as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "law/patch_law.h"

namespace cli {

void print_law(const PatchLaw& law, const std::vector<LawRow>& rows);
std::string law_document(const PatchLaw& law, const std::vector<LawRow>& rows);

}  // namespace cli
