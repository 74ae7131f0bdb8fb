#include "session.h"

#include "names.h"

namespace rc_cuda {

Settings::Settings(const rc_host* host, const rc_options* options)
    : index(roughcontact::option_int(host, options, names::index)),
      limit(1048576 * roughcontact::option_real(host, options, names::memory_limit)) {}

Borrowed::Borrowed(const rc_host* host, const Settings& settings)
    : pool_(roughcontact::shared<Engines>(host, component,
                                          std::string(component.name) + " engines " + std::to_string(settings.index),
                                          [] { return std::make_unique<Engines>(); })),
      engine_(pool_->take()) {
  if (!engine_) engine_ = std::make_unique<Engine>(host, settings.index);
  engine_->device().enter();
}

}  // namespace rc_cuda
