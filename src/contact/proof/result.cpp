#include "contact/proof/result.h"

#include <algorithm>

#include "core/text.h"

namespace rc {

Totals Totals::operator+(const Totals& b) const {
  return {sum + b.sum,
          energy + b.energy,
          overlap + b.overlap,
          std::max(max_pressure, b.max_pressure),
          std::max(largest_p, b.largest_p),
          std::max(largest_product, b.largest_product),
          on_rim + b.on_rim,
          std::max(largest_on_rim, b.largest_on_rim),
          contacts + b.contacts,
          capped + b.capped};
}

void Numbers::multiply_lengths(double by) {
  for (double* const length : {&totals.energy, &totals.overlap, &totals.largest_product, &approach, &bounds.duality_gap,
                               &bounds.gap_error, &mean_gap, &accuracy.left_out})
    *length *= by;
  for (double* const per_length : {&stiffness.value, &stiffness.lower, &stiffness.upper, &punch_stiffness}) *per_length /= by;
}

std::string note_from(const std::vector<std::string>& remarks, std::size_t room) {
  constexpr std::size_t reserved = sizeof "; 999 more remarks" - 1;
  std::size_t whole = 0;
  for (const std::string& remark : remarks) whole += (whole > 0 ? 2 : 0) + remark.size();
  const std::size_t most = whole <= room ? room : room - reserved;
  std::string note;
  std::size_t more = 0;
  for (const std::string& remark : remarks) {
    const std::string next = (note.empty() ? "" : "; ") + remark;
    if (note.size() + next.size() <= most)
      note += next;
    else
      ++more;
  }
  if (more > 0) note += join(note.empty() ? "" : "; ", more, more == 1 ? " more remark" : " more remarks");
  return note;
}

void write(const Numbers& numbers, const System& system, rc_result& result) {
  const Totals& totals = numbers.totals;
  const double area = system.cell_area(), points = static_cast<double>(system.points());
  result.status = numbers.status;
  result.homogeneous = system.homogeneous();
  result.iterations = numbers.work.iterations;
  result.products = numbers.work.products;
  result.points = system.points();
  result.candidates = numbers.candidates;
  result.modelled = numbers.modelled;
  result.contacts = totals.contacts;
  result.load = totals.sum * area;
  result.approach = numbers.approach;
  result.mean_pressure = totals.sum / points;
  result.contact_area = static_cast<double>(totals.contacts) * area;
  result.energy = numbers.energy(system);
  result.stiffness = numbers.stiffness.value;
  result.kkt_primal = numbers.certificate.primal;
  result.kkt_dual = numbers.certificate.dual;
  result.kkt_complementarity = numbers.certificate.complementarity;
  result.kkt_control = numbers.certificate.control;
  result.seconds = numbers.work.seconds;
  result.setup_seconds = numbers.work.setup_seconds;
  copy_text(result.solver, numbers.solver);
  copy_text(result.backend, numbers.backend);
  copy_text(result.kernel, system.kernel.name.c_str());
  copy_text(result.note, numbers.note);
  result.duality_gap = numbers.bounds.duality_gap;
  result.gap_error = numbers.bounds.gap_error;
  result.load_lower = numbers.bounds.load_lower;
  result.load_upper = numbers.bounds.load_upper;
  result.area_lower = numbers.bounds.area_lower;
  result.area_upper = numbers.bounds.area_upper;
  result.proven_contacts = numbers.bounds.proven_contacts;
  result.proven_open = numbers.bounds.proven_open;
  result.undecided = numbers.bounds.undecided;
  result.levels = numbers.work.levels;
  result.tolerance = numbers.tolerance;
  result.stiffness_lower = numbers.stiffness.lower;
  result.stiffness_upper = numbers.stiffness.upper;
  result.capped = totals.capped;
  result.plastic_volume = totals.overlap * area;
  result.proven_capped = numbers.bounds.proven_capped;
  result.area_fraction = static_cast<double>(totals.contacts) / points;
  result.max_pressure = totals.max_pressure;
  result.mean_gap = numbers.mean_gap;
  result.punch_stiffness = numbers.punch_stiffness;
  result.model_nx = numbers.accuracy.nx;
  result.model_ny = numbers.accuracy.ny;
  result.error_estimate = numbers.accuracy.error;
  result.area_estimate = numbers.accuracy.area_error;
  result.left_out = numbers.accuracy.left_out;
}

}  // namespace rc
