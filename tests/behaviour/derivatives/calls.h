// rc_contact_gradient and rc_contact_tangent with arrays of their own.
#pragma once

#include <roughcontact/derivatives.h>

#include "support/contact.h"

namespace pairs {

struct Gradient {
  rc_status status = RC_ERR_INTERNAL;
  rc_gradient result = RC_GRADIENT_INIT;
  Field by_gap;
  std::string message;
};

/** How J changes with the parts of an answer; empty arrays: 0. All zero: the gradient of load or approach. */
struct Cotangents {
  Field p, gap;
  double load = 0, approach = 0;
};

Gradient gradient(const Contact& contact, std::size_t points, const Cotangents& given = {});

struct Change {
  Field gap;  // empty: 0
  double target = 0, modulus = 0;
};

struct Tangent {
  rc_status status = RC_ERR_INTERNAL;
  rc_tangent result = RC_TANGENT_INIT;
  Field p, gap;
  std::string message;
};

Tangent tangent(const Contact& contact, std::size_t points, const Change& given);

double dot(const Field& a, const Field& b);
double norm(const Field& a);

}  // namespace pairs
