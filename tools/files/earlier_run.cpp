#include "files/earlier_run.h"

#include <algorithm>
#include <string_view>

#include "formats/error.h"
#include "text.h"

namespace cli {

namespace {

std::string_view take_part(std::string_view& place) {
  place.remove_prefix(1);
  const std::string_view part = place.substr(0, place.find('/'));
  place.remove_prefix(part.size());
  return part;
}

void add_to_step(const JsonEntry& entry, std::string_view field, EarlierStep& step) {
  const auto* const text = std::get_if<std::string>(&entry.value);
  if (field == "/status" && text) step.status = *text;
  if (field == "/approach") step.approach = number_in(entry.value, step.approach);
  if (field == "/load") step.load = number_in(entry.value, step.load);
  step.fields.push_back(entry);
}

std::string text_at(const std::vector<JsonEntry>& entries, const std::string& place) {
  for (const JsonEntry& entry : entries) {
    if (entry.place == place) return dumped(entry.value);
  }
  return "nothing";
}

}  // namespace

std::optional<EarlierRun> read_earlier_run(const std::string& text) {
  const auto entries = read_json(text);
  if (!entries) return std::nullopt;
  EarlierRun run;
  std::string step_now;
  bool in_order = true;
  for (const JsonEntry& entry : *entries) {
    std::string_view rest = entry.place;
    const std::string_view room = take_part(rest);
    if (room == "input" && rest.starts_with("/targets/")) {
      run.targets.push_back(number_in(entry.value, 0));
    } else if (room == "input" && rest.starts_with("/times/")) {
      run.times.push_back(number_in(entry.value, 0));
    } else if (room == "input" && rest != "/file" && rest != "/against" && !rest.starts_with("/assumed/") &&
               !rest.starts_with("/words/")) {
      run.input.push_back(entry);
    } else if (room == "steps" && !rest.empty()) {
      const std::string_view step = take_part(rest);
      if (step != step_now) {
        in_order = in_order && step == std::to_string(run.steps.size());
        run.steps.emplace_back();
      }
      step_now = step;
      add_to_step(entry, rest, run.steps.back());
    } else if (const auto* const count = std::get_if<std::int64_t>(&entry.value); room == "removing" && count && *count >= 0) {
      run.removing = static_cast<std::size_t>(*count);
    }
  }
  const bool complete = std::all_of(run.steps.begin(), run.steps.end(), [](const EarlierStep& step) { return step.complete(); });
  const bool ours = text_at(run.input, "/input/library_version") != "nothing" && !run.targets.empty() && complete && in_order;
  return ours ? std::optional{std::move(run)} : std::nullopt;
}

void check_continues(const EarlierRun& earlier, const EarlierRun& now, std::size_t steps, const std::string& name) {
  const auto refuse = [&](const std::string& what, const std::string& before, const std::string& here) {
    throw Error("--resume: ", name, " is of a run with ", what, " ", before, ", this one has ", here,
                ": give the same arguments, or leave --resume out to begin anew");
  };
  const auto compare = [&](const std::vector<JsonEntry>& one) {
    for (const auto& [place, value] : one) {
      const std::string before = text_at(earlier.input, place), here = text_at(now.input, place);
      if (before != here) refuse(place.substr(place.rfind('/') + 1), before, here);
    }
  };
  compare(earlier.input);
  compare(now.input);
  if (now.targets.size() < steps) {
    refuse("complete steps", std::to_string(steps), std::to_string(now.targets.size()));
  }
  const auto compare_steps = [&](const char* what, const std::vector<double>& before, const std::vector<double>& here) {
    const auto number = [](const std::vector<double>& of, std::size_t k) {
      return k < of.size() ? format("%.17g", of[k]) : std::string("nothing");
    };
    for (std::size_t k = 0; k < steps; ++k)
      if (number(before, k) != number(here, k)) refuse(format("%s of step %zu", what, k + 1), number(before, k), number(here, k));
  };
  compare_steps("target", earlier.targets, now.targets);
  compare_steps("time", earlier.times, now.times);
}

}  // namespace cli
