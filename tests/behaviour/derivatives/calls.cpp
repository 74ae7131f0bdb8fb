#include "calls.h"

#include <cmath>
#include <numeric>

namespace pairs {

namespace {

const double* or_null(const Field& values) { return values.empty() ? nullptr : values.data(); }

}  // namespace

Gradient gradient(const Contact& contact, std::size_t points, const Cotangents& given) {
  Gradient answer;
  answer.by_gap.assign(points, -7);
  answer.result.dJ_dp = or_null(given.p);
  answer.result.dJ_dgap = or_null(given.gap);
  answer.result.dJ_dload = given.load;
  answer.result.dJ_dapproach = given.approach;
  answer.result.dJ_dundeformed_gap = answer.by_gap.data();
  answer.status = rc_contact_gradient(contact.handle(), &answer.result);
  answer.message = rc_last_error();
  return answer;
}

Tangent tangent(const Contact& contact, std::size_t points, const Change& given) {
  Tangent answer;
  answer.p.assign(points, -7);
  answer.gap.assign(points, -7);
  answer.result.dundeformed_gap = or_null(given.gap);
  answer.result.dtarget = given.target;
  answer.result.dmodulus = given.modulus;
  answer.result.dp = answer.p.data();
  answer.result.dgap = answer.gap.data();
  answer.status = rc_contact_tangent(contact.handle(), &answer.result);
  answer.message = rc_last_error();
  return answer;
}

double dot(const Field& a, const Field& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }
double norm(const Field& a) { return std::sqrt(dot(a, a)); }

}  // namespace pairs
