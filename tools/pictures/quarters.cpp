#include "pictures/quarters.h"

#include "text.h"

namespace cli {

std::string quarters(const std::string& heading) {
  return "set terminal pngcairo size 1320,1000 font 'Sans,14' background rgb 'white'\nset encoding utf8\nset label 10 '" +
         heading +
         "' at screen 0.5,0.965 center font ',18' noenhanced\nset multiplot\nset border linewidth 1.2\n"
         "set grid linecolor rgb '#e0e0e0'\nset format '%g'\n";
}

std::string quarter(int place, const std::string& title, const std::string& x_label, const std::string& y_label) {
  const double left = 0.5 * (place % 2), down = 0.46 * (place / 2);
  return format(
             "set lmargin at screen %.4f\nset rmargin at screen %.4f\nset tmargin at screen %.4f\nset bmargin at screen %.4f\n",
             0.105 + left, 0.475 + left, 0.895 - down, 0.55 - down) +
         (place == 1 ? "unset label 10\n" : "") + "set title '" + title + "'\nset xlabel '" + x_label + "'\nset ylabel '" +
         y_label + "'\n";
}

}  // namespace cli
