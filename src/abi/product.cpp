// rc_product_*
#include "contact/calls/product.h"

#include <roughcontact/product.h>

#include "abi/arrays.h"
#include "abi/guard.h"
#include "abi/handles.h"
#include "abi/sized_struct.h"
#include "abi/steps.h"

struct rc_product {
  rc::Product product;
  rc::Entrance entrance = {};
};

extern "C" {

rc_status rc_product_create(const rc_system* system, const rc_options* options, rc_product** out) {
  using namespace rc;
  return guard("rc_product_create", [&] {
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    *out = nullptr;
    *out = new rc_product{{read_system(system), options_or_defaults(options)}};
    return RC_OK;
  });
}

void rc_product_destroy(rc_product* product) {
  const rc::HostsCall call;
  delete product;
}

rc_status rc_product_apply(rc_product* product, rc_const_array p, rc_array u) {
  using namespace rc;
  return exclusively("rc_product_apply", product, "product", [&](rc_product& entered) {
    const double* const pressures = host_values<double>(p, "p");
    double* const deflections = host_values<double>(u, "u");
    if (!pressures) fail(RC_ERR_ARGUMENT, "p is null");
    if (!deflections) fail(RC_ERR_ARGUMENT, "u is null");
    entered.product.apply(pressures, deflections);
    return RC_OK;
  });
}

}  // extern "C"
