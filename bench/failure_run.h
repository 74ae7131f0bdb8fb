// One scene, one call of the library, whatever comes of it.
#pragma once

#include <string>

#include "failure_scenes.h"
#include "library.h"

namespace bench {

struct Solved {
  rc_result result{};
  rc_status status = RC_ERR_INTERNAL;
  Field p;
  std::string message;
  double cpu_seconds = 0;   // of the whole call
  double residual() const;  // the worst of the certificate's
  const char* name() const { return rc_status_name(status); }
  long long iterations() const { return result.iterations; }
  long long products() const { return result.applications; }
};

Solved solve(const Scene& scene, const Settings& settings, const Field* start = nullptr);
// By nnls on the dense backend, to 1e-12; throws if that is not certified.
Solved truth_of(const Scene& scene);
bool runs(const std::string& solver, const std::string& backend, const Scene& scene);

// Largest |a - b| over largest |b|.
double difference(const Field& a, const Field& b);
Field scaled(Field values, double factor);

}  // namespace bench
