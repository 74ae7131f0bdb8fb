// A surface as the command line asks for it, from the request library: read, with all that the words do to it done.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arguments/given_words.h"
#include "library.h"

namespace cli {

using Request = std::shared_ptr<const rc_request>;

// Throws an Error at the first word that is wrong, before the file is read. map: null, or in place of the file.
Request make_request(const GivenWords& words, std::int32_t call, const rc_map* maps = nullptr, std::int64_t n_maps = 0);
rc_problem_view problem_of(const Request& request);

// Heights on a grid [m]; excluded points are NaN.
struct Pressed {
  std::int64_t nx = 0, ny = 0;
  double hx = 0, hy = 0;
  std::span<const double> heights{};
  std::optional<bool> periodic{};  // as the file says
};

struct SurfaceInput {
  Request request;
  std::vector<std::pair<std::string, std::string>> words;  // as given
  std::string file, format;
  Pressed surface;
  std::string against;                 // file of the other body's heights, which were added; "" if it is flat
  std::string shape;                   // that was added, as given; "" if none
  std::string removed;                 // "none", "mean", "plane" or "quadric"
  std::int64_t missing = 0;            // points
  std::string missing_rule;            // what was done with them: "reject" (there are none), "fill" or "exclude"
  const std::uint8_t* mask = nullptr;  // 0: excluded; null if no point is
  std::vector<std::string> assumed;    // what was assumed of the words and files, is doubtful, or was read from headers
  std::vector<std::string> notes;      // what the user should know about the choices made

  // ", against other.gsf, plane removed, 12 missing points filled": what was done to the heights, for a line of text; "" if
  // nothing.
  std::string preparation() const;
  std::string assumptions() const;  // in one text
};

// A struct of the surface library with the grid of a surface.
template <class Struct> Struct on_grid(std::int64_t nx, std::int64_t ny, double hx, double hy, Struct made) {
  made.nx = nx;
  made.ny = ny;
  made.hx = hx;
  made.hy = hy;
  return made;
}

SurfaceInput input_of(const GivenWords& words, Request request);

}  // namespace cli
