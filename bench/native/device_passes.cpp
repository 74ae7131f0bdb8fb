// device_passes N: the time of each pass of haar-cg on the device over N x N cells, and the bytes that it has to move at least,
// as JSON. bench/device.py compares them with a copy.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "engine.h"
#include "kernels/products.h"
#include "machine.h"
#include "trees.h"

namespace rc_cuda {

namespace {

struct CopyAll {
  const float* from;
  float* to;
  RC_ANYWHERE void operator()(Index i) const { to[i] = from[i]; }
};

// The best of several runs [s].
template <class Pass> double time_of(Device& device, const Pass& pass) {
  double best = 1e300;
  for (int run = 0; run < 8; ++run) {
    device.wait();
    const auto begin = std::chrono::steady_clock::now();
    pass();
    device.wait();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    if (taken.count() < best) best = taken.count();
  }
  return best;
}

rc_host no_host() {
  rc_host host{};
  host.struct_size = sizeof host;
  host.lock = host.unlock = [](const rc_host*, const char*) {};
  return host;
}

rc::CouplingTable table_of(Index n) {
  rc::CouplingTable table{std::min<Index>(n, 64), std::min<Index>(n, 64), {}, 1, 1};
  for (Index i = 0; i < table.mx * table.my; ++i)
    table.k.push_back(1 / (1 + std::hypot(static_cast<double>(i % table.mx), static_cast<double>(i / table.mx))));
  return table;
}

void measure(Engine& engine, Index n) {
  Device& device = engine.device();
  const Current current(device);
  const Index cells = n * n;
  const Window box{n, n};
  const Torus torus = free_torus(n, n);
  const rc::CouplingTable table = table_of(n);
  const Spectrum spectrum(engine, torus, {table.mx, table.my}, true, 1e18,
                          [&](double* out) { std::copy(table.k.begin(), table.k.end(), out); });
  using M = DeviceMachine<float, WholeDevice>;
  Trees trees(n, n, table);
  engine.plan<float>(torus, box, box);
  engine.plan<double>(torus, box, box);
  engine.make_room({torus.bytes<double>(), M::bytes(cells, trees.bytes())}, 0, 1e18, "the timer");
  const M::Memory memory = M::place(engine.vectors(), cells, trees.bytes());
  trees.place(device, memory.trees);
  // One run of 64 cells in ten is in the free set.
  std::vector<std::uint8_t> state(static_cast<std::size_t>(cells), is_unknown);
  std::vector<double> u(state.size()), p(state.size());
  for (std::size_t i = 0; i < u.size(); ++i) {
    u[i] = i / 64 % 10 == 0 ? 1 : -1;
    p[i] = u[i] > 0 ? 0.1 : 0;
  }
  device.upload(memory.state, state.data(), state.size());
  device.upload(memory.u, u.data(), u.size() * sizeof(double));
  device.upload(memory.p, p.data(), p.size() * sizeof(double));
  WholeDevice whole(engine, spectrum, box, 0);
  M machine(whole, cells, 1e300, memory, trees.passes());
  machine.begin();
  machine.replace_and_measure(nullptr, 0);
  machine.choose_set(0);
  machine.set_up_trees(0);

  const char* between = "";
  const auto report = [&](const char* name, double bytes_of_cell, double seconds) {
    std::printf("%s\n    {\"pass\": \"%s\", \"bytes\": %.0f, \"seconds\": %.9f}", between, name,
                bytes_of_cell * static_cast<double>(cells), seconds);
    between = ",";
  };
  std::printf("{\"n\": %lld, \"build\": \"%s\", \"passes\": [", static_cast<long long>(n), component.name);
  report("copy", 8, time_of(device, [&] { device.each(cells, CopyAll{machine.t(), machine.q()}); }));
  // Trees: values of n/3 blocks beside the cells, with 20 bytes of shares and couplings above the finest level.
  report("trees: set up", 10.7, time_of(device, [&] { machine.set_up_trees(0); }));
  double level = 0;
  report("trees: apply", 41, time_of(device, [&] { machine.apply_trees(machine.w(), machine.q(), &level); }));
  report("turn", 17, time_of(device, [&] { machine.turn(0.5); }));
  report("inner", 9, time_of(device, [&] { machine.inner(machine.t(), machine.q()); }));
  report("advance", 32, time_of(device, [&] { machine.advance(0, false, false); }));
  report("advance and cut", 36, time_of(device, [&] { machine.advance(0, true, true); }));
  report("add and measure", 29, time_of(device, [&] { machine.add_and_measure(machine.y(), 0); }));
  report("choose", 13, time_of(device, [&] { machine.choose_set(0); }));
  report("total", 9, time_of(device, [&] { machine.total(machine.p()); }));
  report("product, single precision", 44, time_of(device, [&] { machine.product(machine.t(), machine.q()); }));
  report("product, double precision", 88, time_of(device, [&] { machine.product(machine.p(), machine.wide_spare()); }));
  std::printf("\n]}\n");
}

}  // namespace

// The exit status: 77 if there is no device.
int time_passes(Index n) {
  int status = 77;
  try {
    const rc_host host = no_host();
    Engine engine(&host, 0);
    status = 1;
    measure(engine, n);
    return 0;
  } catch (const roughcontact::Failure& failure) {
    std::fprintf(stderr, "%s\n", failure.message.c_str());
    return status;
  }
}

}  // namespace rc_cuda

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s N\n", argv[0]);
    return 2;
  }
  return rc_cuda::time_passes(std::atoll(argv[1]));
}
