// A half-space under one cell with sides and modulus 1: tests change what they are about.
#pragma once

#include <roughcontact/roughcontact.h>

namespace support {

inline rc_system unit_system() {
  rc_system system = RC_SYSTEM_INIT;
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = 1;
  system.hx = system.hy = system.modulus = 1;
  return system;
}

}  // namespace support
