// The device: its memory, launches and transforms. Compiled by nvcc this is a CUDA device, by other compilers the host, which
// does the same in loops. Both offer
//
// - Device(host, index): the device of that number, or a failure in the driver's words;
// - Current(device): makes it the calling thread's until its end;
// - allocate, release, free_bytes, upload, download, clear;
// - found(address): where kernels find a caller's array on the device;
// - wait_for_all(): waits for all work on the device, whoever gave it;
// - each(n, f): f(i) for 0 <= i < n;
// - reduce<Part>(n, f): the sum of f(i) by Part::add, in fixed pieces; waits;
// - together(work): work(phase, i) for i < work.count(phase), one phase after the other, by one block of threads;
// - blocks(count, shared, work): work(block, k, fastest) for 0 <= k < count, each by a Block, which has each, reduce and
// together;
// - Lines<Real>(device, ...): transforms of lines.
#pragma once

#ifdef __CUDACC__
#include "runtime/cuda_device.h"
#else
#include "runtime/host_device.h"
#endif
