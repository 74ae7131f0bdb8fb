#include "calls.h"

#include <cmath>
#include <numeric>

namespace pairs {

namespace {

rc_const_array array_of(const Field& values) { return RC_IN(values.empty() ? nullptr : values.data()); }

}  // namespace

Gradient gradient(const Contact& contact, std::size_t points, const Cotangents& given) {
  Gradient answer;
  answer.by_gap.assign(points, -7);
  answer.result.dJ_dp = array_of(given.p);
  answer.result.dJ_dgap = array_of(given.gap);
  answer.result.dJ_dload = given.load;
  answer.result.dJ_dapproach = given.approach;
  answer.result.dJ_dundeformed_gap = RC_OUT(answer.by_gap.data());
  answer.status = rc_contact_gradient(contact.handle(), &answer.result);
  answer.message = rc_last_error();
  return answer;
}

Tangent tangent(const Contact& contact, std::size_t points, const Change& given) {
  Tangent answer;
  answer.p.assign(points, -7);
  answer.gap.assign(points, -7);
  answer.result.dundeformed_gap = array_of(given.gap);
  answer.result.dtarget = given.target;
  answer.result.dmodulus = given.modulus;
  answer.result.dp = RC_OUT(answer.p.data());
  answer.result.dgap = RC_OUT(answer.gap.data());
  answer.status = rc_contact_tangent(contact.handle(), &answer.result);
  answer.message = rc_last_error();
  return answer;
}

double dot(const Field& a, const Field& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }
double norm(const Field& a) { return std::sqrt(dot(a, a)); }

}  // namespace pairs
