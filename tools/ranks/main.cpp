// The command `roughcontact-mpi`: arguments in, the same exit code on every rank out.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "platform/terminal.h"
#include "press.h"
#include "refusal.h"
#include "solve_options.h"
#include "standard_streams.h"
#include "text.h"

namespace cli {

const char command_name[] = "roughcontact-mpi";

}  // namespace cli

namespace {

constexpr const char* help = R"(
Started by mpirun. Every rank reads and writes its rows of the files. Lengths, pressures and forces may have a unit with any SI prefix:
39nm, 210GPa, 1mN. Numbers alone are in m (or --unit), Pa and N. A target is a number, a list a,b,c or a range a:b:n of n points.

Exit code, on every rank: 0 every step is certified, 1 wrong input or a failed call, 2 a step is not certified (its results are
written, marked by their status). A run that was ended goes on with --resume.
)";

void add_options(CLI::App& app, cli::RankArguments& arguments) {
  app.footer(help);
  app.allow_windows_style_options(false);  // "/x" is a path
  cli::SolveArguments& solve = arguments.solve;
  cli::add_surface(app, solve.surface, "Missing points: reject (default) or exclude (from contact)", true);
  cli::add_other_body(app, solve.surface);
  cli::add_loading(app, solve);
  cli::add_method(app, solve, "Threads of each rank; 1");
  app.add_option("--out", solve.out, "Folder for summary.json, steps.csv, pressure-K.npy, gap-K.npy")
      ->type_name("DIR")
      ->group("Output");
  app.add_option("--checkpoint", arguments.checkpoint, "Write the pressures of a step every N iterations")
      ->type_name("N")
      ->group("Output");
  cli::add_resume(app, solve);
  cli::add_quiet(app, solve);
}

int run(const cli::Communicator& ranks, const std::vector<std::string>& words) {
  CLI::App app{"Normal contact of a rough surface that the ranks of an MPI program share", "roughcontact-mpi"};
  cli::RankArguments arguments;
  add_options(app, arguments);
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // it takes the last one first
  } catch (const CLI::Success& success) {
    return ranks.first() ? app.exit(success) : cli::exit_certified;
  } catch (const CLI::ParseError& error) {
    if (ranks.first()) cli::report(cli::refusal(app, words, error));
    return cli::exit_error;
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
