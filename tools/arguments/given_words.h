// The words of the request library that a command line gives, as options of the command.
#pragma once

#include <roughcontact/request.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "arguments/command.h"
#include "request/words.h"
#include "text.h"

namespace cli {

struct GivenWords {
  std::string surface;                                                // the file, by its place
  std::vector<std::optional<std::string>> texts{all_words().size()};  // in the order of the table; words without dashes

  const std::optional<std::string>& operator[](std::string_view word) const { return texts[place(word)]; }
  static std::size_t place(std::string_view word) { return static_cast<std::size_t>(find_word(word) - all_words().data()); }

  // Those of one kind or all but that.
  std::vector<rc_given> of_request() const;
};

// The options of all words that a call takes. Parsing fills the words, which must live as long as the command.
void add_words(Command& command, GivenWords& words, std::int32_t call);

}  // namespace cli
