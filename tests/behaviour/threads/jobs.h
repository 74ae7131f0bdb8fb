// The problems that the threads solve: neighbours differ in solver, backend, boundary and control.
#pragma once

#include <roughcontact/roughcontact.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace threads {

struct Job {
  std::vector<std::pair<const char*, const char*>> settings;
  std::int32_t op, boundary, control;
};
const std::vector<Job>& jobs();  // as many as there are threads

struct DestroyOptions {
  void operator()(rc_options* options) const { rc_options_destroy(options); }
};
struct DestroyContact {
  void operator()(rc_contact* contact) const { rc_contact_destroy(contact); }
};
using Options = std::unique_ptr<rc_options, DestroyOptions>;
using Contact = std::unique_ptr<rc_contact, DestroyContact>;

// Null where a setting is refused, as for a backend that is not there.
Options options_for(const Job& job, rc_context* context);

// A loading sequence of three steps on one contact: pressures of the last one, or a complaint.
struct Sequence {
  std::vector<double> p;
  std::string complaint;
};
Sequence solve(const Job& job, const rc_options* options, rc_progress_fn progress = nullptr, void* user = nullptr);

// "where: status: message" of the calling thread.
std::string complain(const char* where, rc_status status);

}  // namespace threads
