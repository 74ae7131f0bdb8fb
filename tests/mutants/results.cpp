// Results through the C interface: how they carry the certificate and the bounds.
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "known_answers.h"
#include "problems.h"

namespace mutants {

namespace {

// A number that differs between texts.
double sum_of(const char* text) {
  double sum = 0;
  for (const char* c = text; *c; ++c) sum = std::fmod(31 * sum + *c, 1e9);
  return sum;
}

}  // namespace

void put(Figures& figures, rc_status status, const rc_result& r, const std::vector<double>& p, const std::vector<double>& gap,
         bool solved) {
  figures.exact("status", status);
  figures.exact("told", std::string(rc_last_error()).find("kkt_primal") != std::string::npos);
  if (status < 0) {
    figures.exact("message", sum_of(rc_last_error()));
    return;
  }
  figures.near("load", r.load);
  figures.near("approach", r.approach);
  figures.near("mean", r.mean_pressure);
  figures.near("energy", r.energy);
  figures.exact("contacts", static_cast<double>(r.contacts));
  figures.exact("candidates", static_cast<double>(r.candidates));
  figures.exact("products", static_cast<double>(r.products));
  figures.exact("area", r.contact_area);
  figures.exact("modelled", static_cast<double>(r.modelled));
  figures.exact("tolerance", r.tolerance);
  figures.exact("estimate", r.error_estimate);
  figures.exact("area_estimate", r.area_estimate);
  figures.exact("left_out", r.left_out);
  figures.exact("homogeneous", r.homogeneous);
  figures.exact("points", static_cast<double>(r.points));
  figures.exact("model_nx", static_cast<double>(r.model_nx));
  figures.exact("model_ny", static_cast<double>(r.model_ny));
  figures.exact("solver", sum_of(r.solver));
  figures.exact("backend", sum_of(r.backend));
  figures.exact("bounded", !std::isnan(r.load_lower));
  figures.exact("infinite", std::isinf(r.load_upper));
  figures.exact("remarks", static_cast<double>(std::string(r.note).size()));
  figures.exact("status_of_result", r.status);
  figures.exact("iterations", static_cast<double>(r.iterations));
  figures.exact("levels", r.levels);
  figures.exact("timed", r.seconds > 0 && r.setup_seconds >= 0);
  figures.exact("kernel", sum_of(r.kernel));
  figures.exact("area_fraction", r.area_fraction);
  figures.near("max_pressure", r.max_pressure);
  figures.near("mean_gap", r.approach + r.mean_gap);  // alone it may be rounding
  figures.near("punch_stiffness", r.punch_stiffness);
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
  figures.near("duality_gap", r.duality_gap);
  figures.near("gap_error", r.gap_error);
  figures.exact("area_lower", r.area_lower);
  figures.exact("area_upper", r.area_upper);
  figures.exact("proven_contacts", static_cast<double>(r.proven_contacts));
  figures.exact("proven_open", static_cast<double>(r.proven_open));
  figures.exact("undecided", static_cast<double>(r.undecided));
}

namespace {

std::int32_t product_of(const double* x, double* y, std::int64_t n, void* diagonal) {
  double sum = 0;
  for (std::int64_t i = 0; i < n; ++i) sum += x[i];
  for (std::int64_t i = 0; i < n; ++i) y[i] = *static_cast<double*>(diagonal) * x[i] + 0.1 * sum;
  return 0;
}

// Values that an earlier result left in a struct.
void spoil(rc_result& r) {
  r.seconds = r.setup_seconds = -5;
  r.levels = -5;
  r.homogeneous = 5;
  r.left_out = -5;
  r.points = -5;
  r.load_lower = r.load_upper = r.duality_gap = r.gap_error = r.area_lower = r.area_upper = -5;
  r.proven_contacts = r.proven_open = r.undecided = -5;
}

struct Handle {
  rc_options* options = nullptr;
  rc_contact* contact = nullptr;

  Handle(const Small& small, const char* backend, const char* solver) {
    rc_options_create(nullptr, &options);
    rc_options_set_text(options, "backend", backend);
    rc_options_set_text(options, "solver", solver);
    rc_contact_create(&small.given, options, &contact);
  }
  ~Handle() {
    rc_contact_destroy(contact);
    rc_options_destroy(options);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
};

// Products and pressures whose load alone, or whose energy alone, exceeds double precision.
void beyond_double_precision(Figures& figures) {
  double diagonal = 1;
  Small small(3, 1);
  small.given.op = RC_OPERATOR_CALLBACK;
  small.given.hx = small.given.hy = 1e10;
  small.given.apply = [](const double* x, double* y, std::int64_t n, void* user) {
    for (std::int64_t i = 0; i < n; ++i) y[i] = *static_cast<double*>(user) * x[i];
    return std::int32_t{0};
  };
  small.given.user = &diagonal;
  Handle handle(small, "callback", "nnls");
  const std::vector<double> flat(3, 0.0);
  for (const auto& [size, factor] : {std::pair{1e100, 1.0}, {1e300, 1e-320}, {1e150, 1.0}, {1e-170, 1.0}}) {
    diagonal = factor;
    std::vector<double> p(3, size), deformed(3);
    rc_step step = RC_STEP_INIT;
    step.control = RC_CONTROL_APPROACH;
    step.undeformed_gap.data = factor < 1 ? flat.data() : small.gap.data();
    step.target = factor < 1 ? 1e-25 : 0.4;
    rc_result r{};
    r.struct_size = sizeof r;
    r.p.data = p.data();
    figures.section("beyond/" + std::to_string(std::log10(size)));
    const rc_status status = rc_contact_certify(handle.contact, &step, &r);
    put(figures, status, r, p, deformed, true);
  }
}

// Solvers stopped after a step from large pressures: the certificate holds for all points, also outside the trial set.
void stopped_far_from_the_answer(Figures& figures) {
  for (const char* solver : {"polonsky-keer", "admm", "nnls", "gp", "greedy"})
    for (const double start : {0.0, 0.02, 5.0})
      for (const std::int32_t control : {RC_CONTROL_APPROACH, RC_CONTROL_LOAD}) {
        Small small(7, 5);
        Handle handle(small, "dense", solver);
        rc_options_set_number(handle.options, "max_iter", 1);
        rc_contact_set_options(handle.contact, handle.options);
        std::vector<double> p(small.points()), p0(small.points(), start), deformed(small.points());
        rc_step step = RC_STEP_INIT;
        step.control = control;
        step.undeformed_gap.data = small.gap.data();
        step.target = 0.1;
        step.p0.data = p0.data();
        rc_result r{};
        r.struct_size = sizeof r;
        r.p.data = p.data();
        figures.section(std::string("stopped/") + solver + std::to_string(start) + std::to_string(control));
        const rc_status status = rc_contact_solve(handle.contact, &step, &r);
        put(figures, status, r, p, deformed, true);
        figures.near("kkt_primal", r.kkt_primal);
        figures.near("kkt_dual", r.kkt_dual);
      }
}

// No point counts, or one does.
void masks_that_leave_little(Figures& figures) {
  Small small(4, 3);
  Handle handle(small, "dense", "nnls");
  for (const bool one : {false, true})
    for (const std::int32_t control : {RC_CONTROL_APPROACH, RC_CONTROL_LOAD}) {
      std::vector<double> gap = small.gap, p(small.points()), deformed(small.points());
      for (double& h : gap) h += 0.25;
      std::vector<std::uint8_t> mask(small.points(), 0);
      mask[5] = one;
      rc_step step = RC_STEP_INIT;
      step.control = control;
      step.undeformed_gap.data = gap.data();
      step.mask.data = mask.data();
      step.target = control == RC_CONTROL_APPROACH ? 2 : one ? 0.3 : 0;
      rc_result r{};
      r.struct_size = sizeof r;
      r.p.data = p.data();
      figures.section(std::string("little/") + std::to_string(one) + std::to_string(control));
      const rc_status status = rc_contact_solve(handle.contact, &step, &r);
      put(figures, status, r, p, deformed, true);
    }
}

// Free edges: the rim bears more of the load than its share, or less; the largest pressure is there, or is not.
void remarks_on_edges(Figures& figures) {
  Small small(20, 17);
  const auto n = static_cast<std::size_t>(small.given.nx);
  Handle handle(small, "dense", "nnls");
  for (const auto& [name, at_x, at_y, curvature] : {std::tuple{"centre", 10.0, 8.0, 1e-3},
                                                    {"edge", 0.0, 8.0, 1e-2},
                                                    {"corner", 20.0, 17.0, 1e-3},
                                                    {"ring", 10.0, 8.0, -1e-2},
                                                    {"punch", 0.0, 0.0, 0.0}})
    for (const double load : {0.5, 20.0}) {
      const std::string section = name + std::to_string(load);
      if (!figures.wants("edges/" + section) && !figures.wants("edges_given/" + section)) continue;
      std::vector<double> gap(small.points()), p(gap.size()), deformed(gap.size());
      for (std::size_t i = 0; i < gap.size(); ++i) {
        const double x = static_cast<double>(i % n) - at_x, y = static_cast<double>(i / n) - at_y;
        gap[i] = 2 + curvature * (x * x + y * y + 0.1 * static_cast<double>(i * i % 7));
      }
      rc_step step = RC_STEP_INIT;
      step.control = RC_CONTROL_LOAD;
      step.undeformed_gap.data = gap.data();
      step.target = load;
      rc_result r{};
      r.struct_size = sizeof r;
      r.p.data = p.data();
      r.gap.data = deformed.data();
      figures.section("edges/" + section);
      const rc_status status = rc_contact_solve(handle.contact, &step, &r);
      put(figures, status, r, p, deformed, true);
      figures.exact("note", sum_of(r.note));
      for (double& value : p) value *= 1.5;  // spoilt pressures on the rim are added up, too
      p[0] = -1;
      p[n + 1] = 0.3;
      figures.section("edges_given/" + section);
      put(figures, rc_contact_certify(handle.contact, &step, &r), r, p, deformed, true);
      figures.exact("note", sum_of(r.note));
    }
}

// Periodic, with a hardness and the approach at the mean plane, where the scale of the residual is the compression, or next to
// it, where it is less unless some points are excluded.
void solved_near_the_mean_plane(Figures& figures) {
  Small small(4, 2);
  small.given.boundary = RC_BOUNDARY_PERIODIC;
  small.given.hardness = 0.5;
  for (std::size_t i = 0; i < small.points(); ++i) small.gap[i] = 0.25 * static_cast<double>(i % 3 == 2 ? 2 : i % 2);
  double mean = 0;
  for (const double h : small.gap) mean += h / static_cast<double>(small.points());
  Handle handle(small, "dense", "nnls");
  for (const bool masked : {false, true})
    for (const double beyond : {0.0, 1e-9}) {
      std::vector<double> p(small.points(), 0), deformed(small.points());
      for (std::size_t i = 0; i < p.size(); i += 3) p[i] = 0.03;
      std::vector<std::uint8_t> mask(small.points(), 1);
      if (masked) p[3] = mask[3] = 0;
      rc_step step = RC_STEP_INIT;
      step.control = RC_CONTROL_APPROACH;
      step.undeformed_gap.data = small.gap.data();
      step.mask.data = masked ? mask.data() : nullptr;
      step.target = mean + beyond;
      rc_result r{};
      r.struct_size = sizeof r;
      r.p.data = p.data();
      r.gap.data = deformed.data();
      figures.section(std::string("mean_plane/") + (masked ? "mask/" : "") + std::to_string(beyond * 1e9));
      put(figures, rc_contact_certify(handle.contact, &step, &r), r, p, deformed, false);
      figures.near("kkt_dual", r.kkt_dual);
      figures.near("kkt_complementarity", r.kkt_complementarity);
    }
}

}  // namespace

void figures_of_results(Figures& figures) {
  beyond_double_precision(figures);
  stopped_far_from_the_answer(figures);
  masks_that_leave_little(figures);
  remarks_on_edges(figures);
  solved_near_the_mean_plane(figures);
  double diagonal = 1;
  std::vector<Small> all;
  for (const std::int64_t boundary : {RC_BOUNDARY_FREE, RC_BOUNDARY_PERIODIC}) {
    all.emplace_back(5, 4);
    all.back().given.boundary = static_cast<std::int32_t>(boundary);
    all.back().given.hx = 0.7;
  }
  all.push_back(all.back());  // nearly flat: in full contact the load alone sets the scale
  for (double& h : all.back().gap) h *= 1e-3;
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
          for (const std::int32_t control : {RC_CONTROL_APPROACH, RC_CONTROL_LOAD})
            for (const double size : {0.2, mean - 1e-3, 1e-9, 0.0, 30.0}) {
              if (periodic && control == RC_CONTROL_APPROACH && size > 1) continue;
              const std::string name = std::to_string(number) + "/" + std::to_string(datum) + "/" + std::to_string(tol) +
                                       (masked ? "/mask" : "") + (control == RC_CONTROL_LOAD ? "/load" : "/approach") +
                                       std::to_string(size * 1e9);
              const auto wanted = [&](const char* kind) { return figures.wants(kind + name); };
              if (std::ranges::none_of(std::array{"solved/", "unknowns/", "given/", "more/", "none/", "indefinite/"}, wanted))
                continue;
              rc_options* options = nullptr;
              rc_options_create(nullptr, &options);
              rc_options_set_text(options, "backend", number == 5 ? "callback" : "dense");
              rc_options_set_text(options, "solver", "nnls");
              rc_options_set_number(options, "tol", tol);
              rc_options_set_number(options, "stiffness", tol < 1e-5);
              rc_options_set_number(options, "bounds", tol < 1e-5 || !masked);
              rc_options_set_number(options, "accuracy", tol > 1e-5 && !masked ? 0.3 : 0);
              if (masked && size > 0.1) rc_options_set_text(options, "certify_backend", number == 5 ? "callback" : "dense");
              std::vector<double> gap = small.gap, p(gap.size()), deformed(gap.size());
              for (double& h : gap) h += datum;
              std::vector<std::uint8_t> mask(gap.size(), 1);
              mask[1] = mask[4] = 0;
              rc_contact* contact = nullptr;
              rc_contact_create(&small.given, options, &contact);
              rc_step step = RC_STEP_INIT;
              step.control = control;
              step.target = control == RC_CONTROL_LOAD ? size : size + datum;
              step.undeformed_gap.data = gap.data();
              step.mask.data = masked ? mask.data() : nullptr;
              rc_result r{};
              r.struct_size = sizeof r;
              r.p.data = p.data();
              r.gap.data = deformed.data();
              figures.section("solved/" + name);
              rc_status status = rc_contact_solve(contact, &step, &r);
              put(figures, status, r, p, deformed, true);
              // Without the gap, a certificate over the unknowns alone.
              r = {};
              r.struct_size = sizeof r;
              r.p.data = p.data();
              step.warm_start = 0;
              figures.section("unknowns/" + name);
              status = rc_contact_solve(contact, &step, &r);
              put(figures, status, r, p, deformed, true);
              r.gap.data = deformed.data();
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
              // A uniform pressure is added everywhere.
              p = right;
              for (std::size_t i = 0; i < p.size(); ++i)
                if (!masked || mask[i]) p[i] += 3;
              p[2] = 1;
              spoil(r);
              figures.section("more/" + name);
              status = rc_contact_certify(contact, &step, &r);
              put(figures, status, r, p, deformed, false);
              p.assign(p.size(), 0.0);
              figures.section("none/" + name);
              status = rc_contact_certify(contact, &step, &r);
              put(figures, status, r, p, deformed, false);
              if (number == 5) {
                for (const double worse : {-0.05, -0.1, -0.6, -1.0, 0.0})
                  for (const auto& [first, second] : {std::pair{1e-170, -2e-170}, {-1e-170, -2e-170}, {1e-170, -1e-170}}) {
                    diagonal = worse;
                    p.assign(p.size(), 0.0);
                    p[0] = first;
                    p[3] = second;
                    figures.section("indefinite/" + name + std::to_string(worse) + std::to_string(first / second));
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
