// One panel of a picture: where it is, its axes and its colour bar, as lines for gnuplot. Row 0 is at the top, as in Gwyddion.
#pragma once

#include <string>
#include <vector>

#include "pictures/raster.h"
#include "request/units.h"
#include "surface/input.h"

namespace cli {

struct Colour {
  double red, green, blue;  // 0 .. 255

  Colour mixed(const Colour& other, double share) const {
    return {red + share * (other.red - red), green + share * (other.green - green), blue + share * (other.blue - blue)};
  }
  std::string text() const;  // "#rrggbb"
};

// Equidistant colours, with straight lines between them.
struct Palette {
  std::vector<Colour> colours;

  Colour at(double place) const;  // 0 .. 1, beyond these the end's
  std::string text() const;       // for gnuplot
};

// Two panels of the same size, side by side or, if the surface is wide, above each other.
class Layout {
 public:
  explicit Layout(const Pressed& surface);

  Size canvas() const { return canvas_; }
  Size panel() const { return panel_; }
  Prefix length() const { return length_; }
  // Pixels from the left and the top.
  struct Place {
    double x, y;
  };
  Place corner(int panel) const;  // of the panel on the canvas

  bool narrow() const { return narrow_; }

  // Fractions of the canvas from its bottom left corner.
  std::string screen(double x, double y) const;

  // A panel's margins, axes and title, of two parts that stand below each other where the panel is narrow.
  std::string frame(int panel, const std::string& title, const std::string& more) const;
  std::string colour_bar(int panel, const Palette& palette, double low, double high) const;
  // How gnuplot is to plot the panel's pixels, three bytes each, that follow in the script; the range of the bar goes with them.
  std::string image() const;

 private:
  double x_length_, y_length_;  // in the display unit
  Prefix length_;
  Size panel_, canvas_;
  Place room_;   // that a panel has with its title, axes and colour bar
  double head_;  // height of the lines above the panels
  bool stacked_, narrow_, to_scale_;
};

}  // namespace cli
