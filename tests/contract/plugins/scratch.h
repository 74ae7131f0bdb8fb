// Directories with plugins to load, and contexts that look into them.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "support/cmocka.hpp"
#include "support/contact.h"
#include "support/plugins.h"

extern "C" rc_status rc_builtin_linked(const rc_host* host, const rc_plugin** out);

namespace plugins {

// A new directory of one's own, removed at the end.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/rcb_" + name + RC_PLUGIN_SUFFIX; }
  // Copies fixtures into it; returns the last one's path.
  std::string put(const std::vector<std::string>& fixtures) const;
  std::string put_as(const std::string& fixture, const std::string& file) const;

 private:
  std::string path_;
};

// A context with its log.
class Registry {
 public:
  explicit Registry(const std::string& plugin_path, std::uint32_t flags = RC_CONTEXT_NO_ENVIRONMENT);

  rc_context* get() const { return context_.get(); }
  // Registers a plugin of one component, which must outlive the context.
  template <class Component> rc_status add(const Component& one) const { return support::add(get(), one); }
  // Creates a contact for a small grid with this backend; the message is rc_last_error().
  rc_status names(const std::string& backend) const;
  // Solves the small grid and returns the load, 0 if it is not certified.
  double load(const std::string& solver, const std::string& backend, std::int32_t boundary = RC_BOUNDARY_FREE,
              std::int32_t control = RC_CONTROL_APPROACH) const;
  std::string origin(const std::string& backend) const;  // "" if it is not listed
  bool lists(const std::string& backend) const { return !origin(backend).empty(); }
  const std::string& log() const { return *log_; }
  const rc_result& result() const { return result_; }

 private:
  std::unique_ptr<std::string> log_ = std::make_unique<std::string>();
  pairs::Context context_;
  mutable rc_result result_{};
};

// A contact of a registry's components: made, if it can be, and pressed by one step.
class Pressed {
 public:
  Pressed(const Registry& registry, const pairs::Problem& problem, const pairs::Settings& settings = {});

  void again();
  std::string pair() const { return std::string(result.solver) + " on " + result.backend; }
  std::string explanation() const;
  bool untouched() const { return result.points == 0 && p == pairs::Field(p.size(), -7); }

  rc_status status = RC_OK;
  rc_result result = RC_RESULT_INIT;
  pairs::Field p, gap;

 private:
  pairs::Problem problem_;
  std::unique_ptr<rc_contact, pairs::DestroyContact> contact_;
};

// The plugin that is linked into this program.
const rc_plugin& linked();
void assert_message_has(const std::string& part);
void assert_has(const std::string& text, const std::string& part);

std::vector<pairs::Test> good_tests(), refused_tests(), place_tests(), registration_tests(), choice_tests(), kernel_tests(),
    promise_tests(), many_liar_tests();

#define TEST(name) \
  { #name, name }

}  // namespace plugins
