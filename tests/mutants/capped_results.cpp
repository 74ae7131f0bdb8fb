// Results with a hardness through the C interface, and the interval of the stiffness.
#include <algorithm>

#include "known_answers.h"
#include "problems.h"

namespace mutants {

namespace {

void put_capped(Figures& figures, const std::string& name, rc_status status, const rc_result& r, const std::vector<double>& p,
                const std::vector<double>& gap, bool solved) {
  figures.section("capped_result/" + name);
  put(figures, status, r, p, gap, solved);
  if (status < 0) return;
  figures.exact("capped", static_cast<double>(r.capped));
  figures.exact("proven_capped", static_cast<double>(r.proven_capped));
  figures.near("plastic_volume", r.plastic_volume);
  figures.near("stiffness_lower", r.stiffness_lower);
  figures.near("stiffness_upper", r.stiffness_upper);
}

}  // namespace

void figures_of_capped_results(Figures& figures) {
  std::vector<Small> all;
  for (const std::int32_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    all.emplace_back(5, 4);
    all.back().given.boundary = boundary;
    all.back().given.hx = 0.7;
  }
  all.emplace_back(9, 1);
  all.back().make_dense(0.2);
  all.back().given.dense = all.back().matrix.data();
  for (Small& small : all) {
    if (!small.matrix.empty()) small.given.dense = small.matrix.data();
    const double scale = small.matrix.empty() ? small.given.modulus : 1;
    for (const double c : {0.1, 0.5, 1e3})
      for (const double depth : {0.2, 0.45, 0.9})
        for (const std::int64_t stiffness : {0, 1, 2})
          for (const std::int32_t control : {RC_CONTROL_APPROACH, RC_CONTROL_LOAD})
            for (const bool masked : {false, true}) {
              if (c > 1 && small.given.boundary == RC_BOUNDARY_PERIODIC && depth > 0.5) continue;
              if (stiffness < 2 && (masked || c < 0.2 || control == RC_CONTROL_LOAD)) continue;
              const std::string name = std::to_string(small.points()) + std::to_string(small.given.boundary) + "/" +
                                       std::to_string(c) + "/" + std::to_string(depth) + "/" + std::to_string(stiffness) +
                                       (control == RC_CONTROL_LOAD ? "/load" : "/approach") + (masked ? "/mask" : "");
              if (!figures.wants("capped_result/" + name)) continue;
              small.given.hardness = c * scale;
              rc_options* options = nullptr;
              rc_options_create(nullptr, &options);
              rc_options_set_text(options, "backend", "dense");
              rc_options_set_text(options, "solver", "nnls");
              rc_options_set_number(options, "tol", 1e-9);
              rc_options_set_number(options, "stiffness", stiffness);
              rc_contact* contact = nullptr;
              rc_contact_create(&small.given, options, &contact);
              std::vector<double> p(small.points()), deformed(small.points());
              std::vector<std::uint8_t> mask(small.points(), 1);
              mask[2] = mask[5] = 0;
              rc_step step = RC_STEP_INIT;
              step.control = control;
              step.undeformed_gap.data = small.gap.data();
              step.mask.data = masked ? mask.data() : nullptr;
              step.target = control == RC_CONTROL_LOAD
                                ? depth * 0.5 * std::min(c, 1.0) * scale * small.given.hx * static_cast<double>(small.points())
                                : depth;
              rc_result r{};
              r.struct_size = sizeof r;
              r.p.data = p.data();
              r.gap.data = deformed.data();
              put_capped(figures, name, rc_contact_solve(contact, &step, &r), r, p, deformed, true);
              const std::vector<double> right = p;
              // The certificate is asked for pressures at which each end is missed, at the elastic and at the hard points.
              for (const double wrong : {1e-4, 0.4})
                for (const int way : {0, 1, 2}) {
                  p = right;
                  for (std::size_t i = 0; i < p.size(); ++i)
                    if (!masked || mask[i]) {
                      const double sign = way == 0 ? -1 : way == 1 ? 1 : i % 2 == 0 ? 1 : -1;
                      p[i] += sign * wrong * std::min(c, 1.0) * scale * (i % 3 == 0 ? 1.0 : 0.2);
                      if (way < 2) p[i] = std::clamp(p[i], 0.0, c * scale);
                    }
                  if (way == 0) p[3] = 0.03 * std::min(c, 1.0) * scale;  // no approach fits all
                  r = {};
                  r.struct_size = sizeof r;
                  r.p.data = p.data();
                  r.gap.data = deformed.data();
                  put_capped(figures, name + "/wrong" + std::to_string(wrong) + std::to_string(way),
                             rc_contact_certify(contact, &step, &r), r, p, deformed, false);
                }
              rc_contact_destroy(contact);
              rc_options_destroy(options);
            }
  }
}

}  // namespace mutants
