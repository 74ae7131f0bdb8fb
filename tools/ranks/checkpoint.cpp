#include "checkpoint.h"

#include "files/json_text.h"
#include "files/outputs.h"

namespace cli {

namespace {

constexpr const char* note_name = "checkpoint.json";

}  // namespace

void Checkpoint::write(std::size_t step, std::int64_t iterations, const std::vector<double>& pressure) {
  ranks_.on_first([&] { run_->begin(); });
  write_rows(ranks_, folder_ / array_name(), pressure, row_.problem.system.nx, row_.problem.system.ny, row_.rows);
  ranks_.on_first([&] {
    JsonText note;
    note.add({{"step", static_cast<std::int64_t>(step)}, {"iterations", iterations}, {"second", second_}});
    write_output(folder_ / note_name, note.text());
  });
  second_ = !second_;
}

std::optional<std::int64_t> Checkpoint::read(std::size_t step, std::vector<double>& pressure) {
  std::int64_t iterations = -1, second = 0;
  ranks_.on_first([&] {
    const auto entries = read_json(run_->files().read(note_name));
    std::int64_t of_step = 0, found = -1;
    for (const auto& [place, value] : entries.value_or(std::vector<JsonEntry>{})) {
      const auto* const whole = std::get_if<std::int64_t>(&value);
      if (place == "/step" && whole) of_step = *whole;
      if (place == "/iterations" && whole) found = *whole;
      const auto* const truth = std::get_if<bool>(&value);
      if (place == "/second" && truth) second = *truth ? 1 : 0;
    }
    if (of_step == static_cast<std::int64_t>(step)) iterations = found;
  });
  iterations = ranks_.of_first(iterations);
  if (iterations < 0) return std::nullopt;
  second_ = ranks_.of_first(second) == 1;
  const std::string file = (folder_ / array_name()).string();
  pressure = read_step_rows(ranks_, file, row_);
  second_ = !second_;
  return iterations;
}

void Checkpoint::remove() {
  ranks_.on_first([&] {
    for (const char* name : {note_name, "checkpoint-a.npy", "checkpoint-b.npy"}) run_->files().remove(name);
  });
}

}  // namespace cli
