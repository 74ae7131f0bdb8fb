#include "arguments/given_words.h"

#include "text.h"

namespace cli {

std::vector<rc_given> GivenWords::of_request() const {
  std::vector<rc_given> found{{"surface", surface.c_str(), nullptr, 0}};
  for (std::size_t k = 0; k < texts.size(); ++k)
    if (texts[k]) found.push_back({all_words()[k].name.data(), texts[k]->c_str(), nullptr, 0});
  return found;
}

void add_words(Command& command, GivenWords& words, std::int32_t call) {
  const Word* const surface = find_word("surface");
  command.options.push_back({"SURFACE", &words.surface, surface->form.data(), surface->help.data()});
  for (std::size_t k = 0; k < words.texts.size(); ++k) {
    const Word& word = all_words()[k];
    if ((word.calls & call) == 0 || word.group.empty()) continue;
    command.options.push_back(
        {"--" + std::string(word.name), &words.texts[k], word.form.data(), word.help.data(), word.group.data()});
  }
}

}  // namespace cli
