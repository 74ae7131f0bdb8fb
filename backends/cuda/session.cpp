#include "session.h"

#include "names.h"

namespace rc_cuda {

Settings::Settings(const rc_host* host, const rc_options* options)
    : index(roughcontact::option_int(host, options, names::index)),
      limit(1048576 * roughcontact::option_real(host, options, names::memory_limit)) {}

namespace {

std::unique_ptr<Engine> taken_or_made(const rc_host* host, const Settings& settings, const rc_team* team, Engines& pool) {
  std::unique_ptr<Engine> engine = pool.take();
  if (!engine) engine = std::make_unique<Engine>(host, settings.index);
  engine->device().serve(host, team);
  return engine;
}

}  // namespace

std::shared_ptr<Engines> engines_of(const rc_host* host, const Settings& settings) {
  return roughcontact::kept<Engines>(host, component, false,
                                     std::string(component.name) + " engines " + std::to_string(settings.index),
                                     [] { return std::make_unique<Engines>(); });
}

Borrowed::Borrowed(const rc_host* host, const Settings& settings, const rc_team* team)
    : pool_(engines_of(host, settings)), engine_(taken_or_made(host, settings, team, *pool_)), current_(engine_->device()) {}

}  // namespace rc_cuda
