// Through the interface: what is done with certificate and bounds.
#include <cmath>

#include "known_answers.h"
#include "problems.h"

namespace mutants {

namespace {

std::int32_t product_of(const double* x, double* y, std::int64_t n, void* diagonal) {
  double sum = 0;
  for (std::int64_t i = 0; i < n; ++i) sum += x[i];
  for (std::int64_t i = 0; i < n; ++i) y[i] = *static_cast<double*>(diagonal) * x[i] + 0.1 * sum;
  return 0;
}

void put(Figures& figures, rc_status status, const rc_result& r, const std::vector<double>& p, const std::vector<double>& gap,
         bool solved) {
  figures.exact("status", status);
  if (status < 0) return;
  figures.near("load", r.load);
  figures.near("displacement", r.displacement);
  figures.near("mean", r.mean_pressure);
  figures.near("energy", r.energy);
  figures.exact("contacts", static_cast<double>(r.contacts));
  figures.exact("candidates", static_cast<double>(r.candidates));
  figures.exact("applications", static_cast<double>(r.applications));
  figures.exact("area", r.contact_area);
  figures.exact("modelled", static_cast<double>(r.modelled));
  figures.exact("tolerance", r.tolerance);
  figures.exact("estimate", r.error_estimate);
  figures.exact("infinite", std::isinf(r.load_upper));
  figures.exact("remarks", static_cast<double>(std::string(r.note).size()));
  figures.near("stiffness", r.stiffness);
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += p[i] * static_cast<double>(i + 1) + gap[i] * static_cast<double>(2 * i + 1);
  figures.near("fields", sum);
  if (solved) return;
  figures.near("kkt_primal", r.kkt_primal);
  figures.near("kkt_dual", r.kkt_dual);
  figures.near("kkt_complementarity", r.kkt_complementarity);
  figures.near("kkt_control", r.kkt_control);
  figures.near("lower", r.load_lower);
  figures.near("upper", r.load_upper);
}

}  // namespace

void figures_of_results(Figures& figures) {
  double diagonal = 1;
  std::vector<Small> all;
  for (const std::int64_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    all.emplace_back(5, 4);
    all.back().given.boundary = static_cast<std::int32_t>(boundary);
    all.back().given.hx = 0.7;
  }
  all.emplace_back(9, 1);
  all.back().make_dense(0.2);
  for (Small& small : all)
    if (!small.matrix.empty()) small.given.dense = small.matrix.data();
  all.emplace_back(6, 1);
  all.back().given.op = RC_OPERATOR_CALLBACK;
  all.back().given.apply = product_of;
  all.back().given.user = &diagonal;

  int number = 0;
  for (Small& small : all) {
    ++number;
    const bool periodic = small.given.boundary == RC_BOUNDARY_PERIODIC;
    double mean = 0;
    for (const double h : small.gap) mean += h / static_cast<double>(small.points());
    for (const double datum : {0.0, 0.3})
      for (const double tol : {1e-9, 1e-2}) {
        if (datum > 0 && tol > 1e-5) continue;
        for (const bool masked : {false, true})
          for (const std::int32_t control : {RC_CONTROL_DISPLACEMENT, RC_CONTROL_LOAD})
            for (const double size : {0.2, mean - 1e-3, 1e-9, 0.0, 30.0}) {
              if (periodic && control == RC_CONTROL_DISPLACEMENT && size > 1) continue;
              rc_options* options = nullptr;
              rc_options_create(nullptr, &options);
              rc_options_set_text(options, "backend", number == 4 ? "callback" : "dense");
              rc_options_set_text(options, "solver", "nnls");
              rc_options_set_real(options, "tol", tol);
              rc_options_set_int(options, "stiffness", tol < 1e-5);
              if (masked && size > 0.1) rc_options_set_text(options, "certify_backend", number == 4 ? "callback" : "dense");
              std::vector<double> gap = small.gap, p(gap.size()), deformed(gap.size());
              for (double& h : gap) h += datum;
              std::vector<std::uint8_t> mask(gap.size(), 1);
              mask[1] = mask[4] = 0;
              rc_contact* contact = nullptr;
              rc_contact_create(&small.given, options, &contact);
              rc_step step = RC_STEP_INIT;
              step.control = control;
              step.target = control == RC_CONTROL_LOAD ? size : size + datum;
              step.gap = gap.data();
              step.mask = masked ? mask.data() : nullptr;
              rc_result r{};
              r.struct_size = sizeof r;
              r.p = p.data();
              r.gap = deformed.data();
              const std::string name = std::to_string(number) + "/" + std::to_string(datum) + "/" + std::to_string(tol) +
                                       (masked ? "/mask" : "") + (control == RC_CONTROL_LOAD ? "/load" : "/approach") +
                                       std::to_string(size * 1e9);
              figures.section("solved/" + name);
              rc_status status = rc_contact_solve(contact, &step, &r);
              put(figures, status, r, p, deformed, true);
              // Without the gap, a certificate over the unknowns alone.
              r = {};
              r.struct_size = sizeof r;
              r.p = p.data();
              step.warm_start = 0;
              figures.section("unknowns/" + name);
              status = rc_contact_solve(contact, &step, &r);
              put(figures, status, r, p, deformed, true);
              r.gap = deformed.data();
              const std::vector<double> right = p;
              for (const double spoilt : {0.1, 1e-4}) {
                p = right;
                for (std::size_t i = 0; i < p.size(); ++i)
                  if (!masked || mask[i])
                    p[i] += spoilt * static_cast<double>(i % 3) * (p[i] + (i == 2 ? -0.3 : i == 3 ? 0.1 : 0));
                figures.section("given/" + name + "/" + std::to_string(spoilt));
                status = rc_contact_certify(contact, &step, &r);
                put(figures, status, r, p, deformed, false);
              }
              // A pressure more everywhere.
              p = right;
              for (std::size_t i = 0; i < p.size(); ++i)
                if (!masked || mask[i]) p[i] += 3;
              figures.section("more/" + name);
              status = rc_contact_certify(contact, &step, &r);
              put(figures, status, r, p, deformed, false);
              if (number == 4) {
                for (const double worse : {-0.1, -0.6, -1.0}) {
                  diagonal = worse;
                  p.assign(p.size(), 0.0);
                  p[0] = 1e-170;
                  p[3] = -2e-170;
                  figures.section("indefinite/" + name + std::to_string(worse));
                  status = rc_contact_certify(contact, &step, &r);
                  put(figures, status, r, p, deformed, false);
                }
                diagonal = 1;
              }
              rc_contact_destroy(contact);
              rc_options_destroy(options);
            }
      }
  }
}

}  // namespace mutants
