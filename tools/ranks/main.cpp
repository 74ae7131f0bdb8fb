// The command `roughcontact-mpi`: arguments in, the same exit code on every rank out.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "arguments/parser.h"
#include "arguments/shared_options.h"
#include "platform/terminal.h"
#include "press.h"
#include "text.h"

namespace cli {

const char command_name[] = "roughcontact-mpi";

}  // namespace cli

namespace {

constexpr const char* help = R"(
Started by mpirun. Every rank reads and writes its rows of the files. Lengths, pressures and forces may have a unit with any SI
prefix: 39nm, 210GPa, 1mN. Numbers without a unit are in m (or --unit), Pa and N. A target is a number, a list a,b,c or a range
a..b:n of n points or a..b:nlog of n points with equal ratios.

Exit code, on every rank: 0 every step is certified, 1 wrong input or a failed call, 2 a step is not certified (its results are
written, marked by their status). --resume continues an interrupted run.
)";

cli::Command whole_command(cli::RankArguments& arguments) {
  cli::Command command{"roughcontact-mpi", "Normal contact of a rough surface that the ranks of an MPI program share", help};
  cli::SolveArguments& solve = arguments.solve;
  cli::add_words(command, solve.words, RC_CALL_ROWS);
  cli::add_set(command, solve);
  command.add("Output", {{"--out", &solve.out, "DIR", "Folder for summary.json, steps.csv, pressure-K.npy, gap-K.npy"},
                         {"--checkpoint", &arguments.checkpoint, "N", "Write the pressures of a step every N iterations"}});
  cli::add_resume(command, solve);
  cli::add_quiet(command, solve);
  return command;
}

int run(const cli::Communicator& ranks, const std::vector<std::string>& words) {
  cli::RankArguments arguments;
  const cli::Parsed parsed = cli::parse(whole_command(arguments), words);
  if (!parsed.refusal.empty()) {
    if (ranks.first()) cli::report(parsed.refusal);
    return cli::exit_error;
  }
  if (!parsed.answer.empty()) {
    if (ranks.first()) std::fputs(parsed.answer.c_str(), stdout);
    return cli::exit_certified;
  }
  return cli::press(ranks, arguments);
}

}  // namespace

int main(int argc, char** argv) {
  rc_platform::open_standard_streams();
  int level = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &level);
  int code = cli::exit_error;
  {
    const cli::Communicator ranks{MPI_COMM_WORLD};
    const auto say = [&ranks](const char* text) {
      if (ranks.first()) cli::report(text);
    };
    try {
      const std::vector<std::string> words = rc_platform::arguments(argc, argv);
      code = run(ranks, {words.begin() + std::min<std::size_t>(words.size(), 1), words.end()});
    } catch (const std::bad_alloc&) {  // on this rank alone, so that the others wait for it
      cli::report("out of memory");
      MPI_Abort(MPI_COMM_WORLD, code);
    } catch (const std::exception& error) {
      say(error.what());
    }
    const bool printed = !ranks.first() || cli::finish_standard_output();
    if (ranks.of_first(std::int64_t{printed}) == 0 && code == cli::exit_certified) code = cli::exit_error;
  }
  MPI_Finalize();
  return code;
}
