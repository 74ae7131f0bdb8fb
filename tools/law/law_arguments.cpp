#include "law/law_arguments.h"

#include <algorithm>

#include "arguments/shared_options.h"

namespace cli {

namespace {

constexpr const char* law_help = R"(
If SURFACE is a map of heights, its law is made. If it is the file of a law, the law is printed, evaluated, drawn or exported.

A law has the nominal pressure of the patch against its overclosure, which is 0 at first touch, with proven bounds. This command
makes laws in m, N and Pa; give --law-units for a law that another program made in other units.

Exit code: 0 the law is proven to be within the tolerance, 1 wrong input or a failed call, 2 it is not, or a row is beyond its
last node (everything is written nevertheless). An interrupted command has written nothing.
)";

void add_making(Command& command, LawArguments& arguments) {
  SolveArguments& contact = arguments.contact;
  add_words(command, contact.words, RC_CALL_LAW);
  add_set(command, contact);
  command.add(
      "Law",
      {{"--tolerance", &arguments.tolerance, "SHARE",
        "Half the distance between the bounds of the pressure, relative (default 0.1%)"},
       {"--conductance-tolerance", &arguments.conductance_tolerance, "SHARE", "The same for the conductance (default: no limit)"},
       {"--bulk", &arguments.bulk, "NAME or STIFFNESS",
        "Deformation of the bulk, which the overclosure leaves out: auto (default), none, mean (overclosure is the change of the "
        "mean gap; not for periodic boundaries), or the stiffness of the bulk in N/m"},
       {"--max-nodes", &arguments.max_nodes, "N", "Largest number of nodes, even if the tolerance is not met (default 10000)"}});
}

}  // namespace

Command law_command(LawArguments& arguments) {
  Command law{"law", "Pressure against overclosure of a rough patch, for finite element programs", law_help};
  add_making(law, arguments);
  law.options.front().help = "File of heights, see roughcontact formats, or of a law";
  law.add("Evaluation",
          {{"--at", &arguments.at, "TARGETS", "Print rows at these overclosures (1um,2um) or pressures (1MPa:100MPa:5log)"},
           {"--law-units", &arguments.law_units, "LENGTH,FORCE", "Units of a law that another program made (default m,N)"}});
  law.add("Output",
          {{"-o,--output", &arguments.output, "FILE", "File of the law, for rc_law_load, rc.Law.load and this command"},
           {"--export", &arguments.exports, "FORMAT=FILE",
            "Tables for other programs, separated by commas: csv, calculix, abaqus, moose or table"},
           {"--deck-units", &arguments.deck_units, "LENGTH,FORCE", "Units of the exported tables, mm,N (default m,N)"},
           {"--conductivity", &arguments.conductivity, "K or K1,K2",
            "Conductivity of both bodies, or of each, in units of the deck: adds the conductance"},
           {"--friction", &arguments.friction, "MU,NU",
            "Coefficient of friction and Poisson's ratio: adds friction with its elastic slip to cards and csv"},
           {"--rows", &arguments.rows, "N", "Rows of a table (default 200, the most that CalculiX reads)"},
           {"--beyond", &arguments.beyond, "TIMES", "Add a row at this multiple of the last overclosure (default 100; 1: none)"},
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
