// Callers' arrays on the device.
#include "operator.h"
#include "session.h"

namespace rc_cuda {

namespace {

// copy(device), after all earlier work on the device, whoever gave it: it may write the arrays or read them.
template <class Copy> void with_device(const rc_host* host, const rc_options* options, const Copy& copy) {
  Borrowed engine(host, Settings(host, options));
  engine->device().wait_for_all();
  copy(engine->device());
  engine.give_back();
}

}  // namespace

void Operator::fetch(const rc_host* host, const rc_options* options, void* to_host, const void* from_device, std::int64_t bytes) {
  with_device(host, options,
              [&](Device& device) { device.download(to_host, device.found(from_device), static_cast<std::size_t>(bytes)); });
}

void Operator::store(const rc_host* host, const rc_options* options, void* to_device, const void* from_host, std::int64_t bytes) {
  with_device(host, options, [&](Device& device) {
    device.upload(const_cast<void*>(device.found(to_device)), from_host, static_cast<std::size_t>(bytes));
  });
}

}  // namespace rc_cuda
