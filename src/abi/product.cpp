// rc_product_*
#include "contact/calls/product.h"

#include <roughcontact/product.h>

#include "abi/guard.h"
#include "abi/handles.h"
#include "abi/sized_struct.h"

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
    *out = new rc_product{{read<rc_system>(system, "rc_system", RC_SYSTEM_INIT), options_or_defaults(options)}};
    return RC_OK;
  });
}

void rc_product_destroy(rc_product* product) {
  const rc::HostsCall call;
  delete product;
}

rc_status rc_product_apply(rc_product* product, const double* p, int64_t p_x, int64_t p_y, double* u, int64_t u_x, int64_t u_y) {
  using namespace rc;
  return exclusively("rc_product_apply", product, "product", [&](rc_product& entered) {
    if (!p) fail(RC_ERR_ARGUMENT, "p is null");
    if (!u) fail(RC_ERR_ARGUMENT, "u is null");
    entered.product.apply({p, p_x, p_y}, {u, u_x, u_y});
    return RC_OK;
  });
}

}  // extern "C"
