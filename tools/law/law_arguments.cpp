#include "law/law_arguments.h"

#include <algorithm>

#include "arguments/shared_options.h"

namespace cli {

namespace {

constexpr const char* law_help = R"(
FILE is a map of heights, whose law is made, or a law that was made before: it is then printed, evaluated, drawn and exported.

A law has the nominal pressure of the patch against its overclosure, which is 0 at first touch, with proven bounds. Laws of this
command are in m, N and Pa; a law from elsewhere has the units of --law-units.

Exit code: 0 the law is within the tolerance, proven, 1 wrong input or a failed call, 2 it is not proven or not within it, or was
asked beyond its range (all is written nevertheless). An interrupted command has written nothing.
)";

void add_making(Command& command, LawArguments& arguments) {
  SolveArguments& contact = arguments.contact;
  add_surface(command, contact.surface, "Missing points: reject (default), fill (interpolate) or exclude (from contact)");
  add_other_body(command, contact.surface);
  add_shape(command, contact.surface);
  add_elasticity(command, contact);
  command.add(
      "Law",
      {{"--pressure", &contact.pressure, "LOWER..UPPER", "Nominal pressures between which the tolerance holds, 1MPa..500MPa"},
       {"--tolerance", &arguments.tolerance, "SHARE", "Half the width of the bounds of the pressure (default 0.1%)"},
       {"--conductance-tolerance", &arguments.conductance_tolerance, "SHARE",
        "The same of the conductance (default: as it comes)"},
       {"--bulk", &arguments.bulk, "NAME or STIFFNESS",
        "What the half-space yields as a whole, which is not in the overclosure: auto (default), none, mean (the overclosure "
        "is the change of the mean gap; free boundaries), or force over deflection in N/m"},
       {"--max-nodes", &arguments.max_nodes, "N", "Stop at N nodes, with the bounds that they give (default 10000)"}});
  add_boundary(command, contact);
  add_method(command, contact);
}

}  // namespace

Command law_command(LawArguments& arguments) {
  Command law{"law", "Pressure against overclosure of a rough patch, for finite element programs", law_help};
  add_making(law, arguments);
  law.options.front().help = "File of heights, see roughcontact formats, or of a law";
  law.add("Evaluation",
          {{"--at", &arguments.at, "TARGETS", "Rows to print, at overclosures (1um,2um) or pressures (1MPa:100MPa:5log)"},
           {"--law-units", &arguments.law_units, "LENGTH,FORCE", "Units of a law that this command has not made (default m,N)"}});
  law.add("Output", {{"-o,--output", &arguments.output, "FILE", "File of the law, for rc_law_load, rc.Law.load and this command"},
                     {"--export", &arguments.exports, "FORMAT=FILE",
                      "Tables for other programs, separated by commas: csv, calculix, abaqus, moose or table"},
                     {"--deck-units", &arguments.deck_units, "LENGTH,FORCE", "Units of the exported tables, mm,N (default m,N)"},
                     {"--conductivity", &arguments.conductivity, "K or K1,K2",
                      "Conductivities of the bodies in units of the deck, for a conductance in the tables"},
                     {"--rows", &arguments.rows, "N", "Rows of a table (default 200, which is the most for calculix)"},
                     {"--beyond", &arguments.beyond, "TIMES",
                      "One more row at this multiple of the last overclosure (default 100; 1: none)"},
                     {"--json", &arguments.json, "FILE", "Write the facts, the nodes and the rows"},
                     {"--picture", &arguments.picture, "FILE", "Draw the law with its bounds (PNG, needs gnuplot)"}});
  add_quiet(law, arguments.contact);
  return law;
}

std::string given_for_making(LawArguments arguments) {
  Command making;
  add_making(making, arguments);
  const auto found = std::ranges::find_if(making.options, given);
  return found == making.options.end() ? "" : names_of(*found).back();
}

}  // namespace cli
