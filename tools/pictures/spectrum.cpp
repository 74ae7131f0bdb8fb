#include "pictures/spectrum.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "platform/files.h"
#include "request/units.h"
#include "text.h"

namespace cli {

namespace {

struct Range {
  double low, high;
};

// Range of powers that is drawn: rings of mere round-off would squeeze the rest.
constexpr double drawn_range = 1e-16;

// Text in gnuplot's single quotes.
std::string quoted(const std::string& text) {
  std::string doubled;
  for (const char c : text) doubled.append(c == '\'' ? 2 : 1, c);
  return format("'%s'", doubled.c_str());
}

double power_law(const rc_surface_power_law& law, double q) { return law.prefactor * std::pow(q, law.slope); }

std::string wavelength_text(double q) { return with_prefix(wavelength(q), "m"); }

// A line across the picture; spectra fall, so there is room for a label at its upper end.
std::string mark(int number, double q, const char* text, double height) {
  if (!std::isfinite(q)) return "";
  return format(
             "set arrow %d from first %.9g,graph 0 to first %.9g,graph 1 nohead dashtype 2 linewidth 2 linecolor rgb '#707070'\n",
             number, q, q) +
         format("set label %d '%s %s' at first %.9g,graph %g offset 0.6,0\n", number, text, wavelength_text(q).c_str(), q,
                height);
}

std::string peaks(const rc_surface_power_law& law) {
  std::string text;
  for (std::int64_t k = 0; k < law.peaks; ++k) {
    const double q = std::hypot(law.peak_qx[k], law.peak_qy[k]);
    const int number = 20 + static_cast<int>(k);
    text += format("set arrow %d from first %.9g,graph 1 to first %.9g,graph 0.94 filled linewidth 2 linecolor rgb '#c04000'\n",
                   number, q, q);
  }
  return text;
}

}  // namespace

Gnuplot draw_spectrum(const Analysis& analysis, std::FILE* file) {
  const rc_surface_power_law& law = analysis.law;
  const Rings& rings = analysis.rings;
  const double largest = *std::ranges::max_element(rings.psd);
  Range q{rings.q.front(), rings.q.back()}, c{largest, largest};
  std::string data = "$psd << EOD\n";
  for (std::size_t i = 0; i < rings.q.size(); ++i) {
    if (!(rings.psd[i] > drawn_range * largest)) continue;
    c.low = std::min(c.low, rings.psd[i]);
    data += format("%.9g %.9g\n", rings.q[i], rings.psd[i]);
  }
  data += "EOD\n";
  q = {q.low / 1.3, q.high * 1.3};
  c = {c.low / 3, c.high * 5};

  std::string script = "set terminal pngcairo size 1000,750 font 'Sans,16' background rgb 'white'\nset encoding utf8\n" + data;
  script += "set logscale xyx2\nset border linewidth 1.2\nset key bottom left Left reverse samplen 2\n";
  script += format("set xrange [%.9g:%.9g]\nset x2range [%.9g:%.9g]\nset yrange [%.9g:%.9g]\n", q.low, q.high, wavelength(q.low),
                   wavelength(q.high), c.low, c.high);
  script +=
      "set format x '10^{%T}'\nset format x2 '10^{%T}'\nset format y '10^{%T}'\nset xtics nomirror\nset x2tics\nset grid xtics "
      "ytics linecolor rgb '#e0e0e0'\n";
  script += "set xlabel 'wave number q [1/m]'\nset x2label 'wavelength [m]'\nset ylabel 'C(q) [m^4]'\n";
  script += "set title " + quoted(rc_platform::path_of(analysis.input.file).filename().string()) + " noenhanced font ',20'\n";
  script += mark(1, law.q_rolloff, "roll-off", 0.9) + mark(2, law.q_cutoff, "cut-off", 0.83) + peaks(law);

  script += "plot $psd using 1:2 with points pointtype 7 pointsize 0.7 linecolor rgb '#4080c0' title 'mean over directions'";
  if (std::isfinite(law.hurst)) {
    script +=
        format(", [%.9g:%.9g] %.9g*(x/%.9g)**(%.9g) with lines linewidth 4 linecolor rgb '#e0002e' title 'H = %.3f +- %.3f'",
               law.q_min, law.q_max, power_law(law, law.q_min), law.q_min, law.slope, law.hurst, law.hurst_error);
  }
  if (law.peaks > 0) {
    script += format(", NaN with lines linewidth 2 linecolor rgb '#c04000' title 'texture, %s'",
                     wavelength_text(std::hypot(law.peak_qx[0], law.peak_qy[0])).c_str());
  }
  script += "\n";

  return run_gnuplot(script, file);
}

}  // namespace cli
