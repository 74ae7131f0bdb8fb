// Work in a process of its own: its peak memory is its own, and its end gives everything back.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

namespace bench {

using Json = nlohmann::ordered_json;

// What `work` returns, or {"error": text} if it throws or the process dies.
Json in_child(const std::function<Json()>& work);

// Of this process so far: peak resident memory [bytes], processor time of all threads [s].
double peak_memory();
double cpu_seconds();

}  // namespace bench
