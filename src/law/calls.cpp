// rc_law_*
#include <roughcontact/law.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "abi/arrays.h"
#include "abi/guard.h"
#include "abi/sized_struct.h"
#include "core/files.h"
#include "law/cards.h"
#include "law/create.h"
#include "law/law_file.h"
#include "law/table.h"

namespace {

using namespace rc;

const Law& valid(const rc_law* law) {
  if (!law) fail(RC_ERR_ARGUMENT, "law is null");
  return *law;
}

// Returns the status of a law that was made or read; a law that is not certified sets the message.
rc_status concluded(const Law& law) {
  clear_message();
  if (law.status > 0) set_message(law.remark.c_str());
  return law.status;
}

// The law of that name. The first call for a name reads it; if that throws, the name stays unknown. The list is never destroyed:
// threads may evaluate laws while the process ends.
const rc_law& named_law(const char* name, const char* path) {
  static auto& lock = *new std::mutex;
  static auto& laws = *new std::map<std::string, std::unique_ptr<const rc_law>, std::less<>>;
  const std::lock_guard locked(lock);
  auto found = laws.find(name);
  if (found == laws.end()) found = laws.emplace(name, read_law(path)).first;
  return *found->second;
}

// scale: the law's, see table.h
void add_conductance(rc_law_point& point, double scale) {
  point.conductance = scale * point.slope;
  point.conductance_lower = scale * point.slope_lower;
  point.conductance_upper = scale * point.slope_upper;
}

// The message of an evaluation, which is a number or a missing argument at fault.
rc_status refused(const char* where, const char* what) {
  return guard(where, [&]() -> rc_status { fail(RC_ERR_ARGUMENT, what); });
}
bool refuses(double x) { return !(x <= std::numeric_limits<double>::max()); }
constexpr const char* null_or_nan = "law or an output is null, or the number is NaN or infinite";

}  // namespace

extern "C" {

rc_status rc_law_create(const rc_system* system, const rc_options* options, const rc_law_spec* spec, rc_law** out) {
  return guard("rc_law_create", [&]() -> rc_status {
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    *out = nullptr;
    const rc_system patch = read<rc_system>(system, "rc_system", RC_SYSTEM_INIT);
    if (patch.creep_terms != 0)
      fail(RC_ERR_INCOMPATIBLE, "rc_system.creep_terms = ", patch.creep_terms,
           ": a contact law is without time; make one of the elastic bodies at once, or with the modulus after all creep");
    const rc_law_spec wanted = read<rc_law_spec>(spec, "rc_law_spec", RC_LAW_SPEC_INIT);
    check_reserved(wanted.reserved, "rc_law_spec.reserved");
    check_host_arrays<rc_const_array>({{"rc_law_spec.undeformed_gap", wanted.undeformed_gap}, {"rc_law_spec.mask", wanted.mask}});
    *out = create_law(patch, options, wanted).release();
    return concluded(**out);
  });
}

void rc_law_destroy(rc_law* law) { delete law; }

rc_status rc_law_describe(const rc_law* law, rc_law_info* out) {
  return guard("rc_law_describe", [&] {
    check_size(out, "rc_law_info");
    write(out, valid(law).info);
    return RC_OK;
  });
}

rc_status rc_law_describe_node(const rc_law* law, int64_t i, rc_law_point* out) {
  return guard("rc_law_describe_node", [&] {
    const std::vector<rc_law_point>& nodes = valid(law).nodes;
    check_size(out, "rc_law_point");
    if (i < 0 || i >= static_cast<std::int64_t>(nodes.size()))
      fail(RC_ERR_ARGUMENT, "i = ", i, " is none of ", nodes.size(), " nodes");
    rc_law_point node = nodes[static_cast<std::size_t>(i)];
    add_conductance(node, law->conductance());
    write(out, node);
    return RC_OK;
  });
}

rc_status rc_law_pressure(const rc_law* law, double x, double* p, double* slope, double* energy) {
  const int status = law && p ? roughcontact_law_pressure(law->table.data(), x, p, slope, energy) : RC_ERR_ARGUMENT;
  return status >= 0 ? status : refused("rc_law_pressure", null_or_nan);
}

rc_status rc_law_pressures(const rc_law* law, int64_t n, rc_const_array x, rc_array p, rc_array slope, rc_array energy) {
  if (!law || (!x.data && n > 0) || n < 0) return refused("rc_law_pressures", "law or x is null, or n < 0");
  if (!is_plain(x) || !is_plain(p) || !is_plain(slope) || !is_plain(energy))
    return guard("rc_law_pressures", [&] {
      check_host_array(x, "x");
      check_host_arrays<rc_array>({{"p", p}, {"slope", slope}, {"energy", energy}});
      return RC_OK;
    });
  const double* const at = values_of<double>(x);
  double *const to_p = values_of<double>(p), *const to_slope = values_of<double>(slope),
                *const to_energy = values_of<double>(energy);
  int worst = RC_OK;
  for (std::int64_t i = 0; i < n; ++i) {
    double pressure = 0;
    const int status = roughcontact_law_pressure(law->table.data(), at[i], to_p ? to_p + i : &pressure,
                                                 to_slope ? to_slope + i : nullptr, to_energy ? to_energy + i : nullptr);
    if (status < 0)
      return guard("rc_law_pressures", [&]() -> rc_status { fail(RC_ERR_ARGUMENT, "x[", i, "] = ", at[i], " is not finite"); });
    worst = std::max(worst, status);
  }
  return worst;
}

rc_status rc_law_overclosure(const rc_law* law, double p, double* x) {
  const int status = law && x ? roughcontact_law_overclosure(law->table.data(), p, x) : RC_ERR_ARGUMENT;
  return status >= 0 ? status : refused("rc_law_overclosure", null_or_nan);
}

rc_status rc_law_gap_conductance(const rc_law* law, double p, double rho1, double rho2, double* conductance) {
  if (!law || !conductance) return refused("rc_law_gap_conductance", null_or_nan);
  if (!(rho1 >= 0 && rho2 >= 0 && rho1 + rho2 > 0))
    return refused("rc_law_gap_conductance", "rho1 and rho2 must be >= 0, not both 0");
  const double scale = law->conductance();
  if (std::isnan(scale)) return refused("rc_law_gap_conductance", no_conductance);
  double slope = 0;
  const int status = roughcontact_law_slope(law->table.data(), p, &slope);
  if (status < 0) return refused("rc_law_gap_conductance", null_or_nan);
  *conductance = scale * slope / (rho1 + rho2);
  return status;
}

rc_status rc_law_evaluate(const rc_law* law, double x, rc_law_point* out) {
  rc_law_point point = RC_LAW_POINT_INIT;
  if (!law || !out || out->struct_size != sizeof point || refuses(x)) {
    const rc_status status = guard("rc_law_evaluate", [&] {
      valid(law);
      check_size(out, "rc_law_point");
      if (refuses(x)) fail(RC_ERR_ARGUMENT, "x = ", x, " is not finite");
      return RC_OK;
    });
    if (status != RC_OK) return status;
  }
  const double* const table = law->table.data();
  const int status = roughcontact_law_pressure(table, x, &point.p, &point.slope, &point.energy);
  point.x = x;
  if (x > 0) {
    roughcontact_law_bounds bounds{};
    roughcontact_law_bounds_at(table, x, point.p, &bounds);
    point.p_lower = bounds.p_lower;
    point.p_upper = bounds.p_upper;
    point.area_fraction = bounds.area;
    point.area_lower = bounds.area_lower;
    point.area_upper = bounds.area_upper;
    const bool unbounded = bounds.slope_upper >= std::numeric_limits<double>::max();
    point.slope_lower = point.between_lower = bounds.slope_lower;
    point.slope_upper = point.between_upper = unbounded ? std::numeric_limits<double>::infinity() : bounds.slope_upper;
    point.bounds = law->nodes[static_cast<std::size_t>(bounds.node)].bounds;
  }
  add_conductance(point, law->conductance());
  write(out, point);
  return status;
}

rc_status rc_law_save(const rc_law* law, const char* path) {
  return guard("rc_law_save", [&] {
    const Law& saved = valid(law);
    if (!path) fail(RC_ERR_ARGUMENT, "path is null");
    write_file(path, text_of(saved));
    return RC_OK;
  });
}

rc_status rc_law_load(const char* path, rc_law** out) {
  return guard("rc_law_load", [&] {
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    *out = nullptr;
    if (!path) fail(RC_ERR_ARGUMENT, "path is null");
    *out = read_law(path).release();
    return concluded(**out);
  });
}

rc_status rc_law_export(const rc_law* law, const char* path, rc_law_export_spec* spec) {
  return guard("rc_law_export", [&] {
    const Law& exported = valid(law);
    if (!path) fail(RC_ERR_ARGUMENT, "path is null");
    rc_law_export_spec cards = read<rc_law_export_spec>(spec, "rc_law_export_spec", RC_LAW_EXPORT_SPEC_INIT);
    check_reserved(cards.reserved, "rc_law_export_spec.reserved");
    write_file(path, cards_of(exported, cards));
    spec->error = cards.error;
    return RC_OK;
  });
}

rc_status rc_law_open(const char* name, const char* path, const rc_law** out) {
  return guard("rc_law_open", [&] {
    if (!out) fail(RC_ERR_ARGUMENT, "out is null");
    *out = nullptr;
    if (!name || name[0] == '\0') fail(RC_ERR_ARGUMENT, "name is null or empty");
    *out = &named_law(name, path ? path : join(name, ".law").c_str());
    return concluded(**out);
  });
}

}  // extern "C"
