// The contact law of one Gauss point: a rough patch pressed against a half-space. To be copied into a finite element code.
#pragma once

#include <roughcontact/law.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The library's message; a finite element code cuts its step.
struct ContactLawError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class ContactLaw {
 public:
  struct Answer {
    double force = 0, tangent = 0;  // F and dF/d(displacement)
    double contact_area = 0;
    bool tabulated = false;  // from the law of tabulate(), not from the solver
  };

  // Where a step has ended, and all that a restart file needs.
  struct State {
    std::vector<double> pressures;    // of the last step that was solved: they save time; empty: none
    std::vector<double> indentation;  // plastic, with a hardness; empty: none
    double deepest = 0;               // the largest displacement
    double indented = 0;  // the displacement that the indentation is of; smaller than `deepest` after steps by the law
  };

  // Options of the library and their values as text, see `roughcontact options`.
  using Options = std::vector<std::pair<std::string, std::string>>;

  // heights: nx by ny of the system, x fastest, towards the other body. tol is 1e-10 unless an option says otherwise: Newton's
  // method of the finite element code wants forces more exact than its own tolerance.
  ContactLaw(const rc_system& system, const std::vector<double>& heights, const Options& options = {});

  // The mesh deforms under the force of the patch as well. With the patch's stiffness as a whole, force over displacement, what
  // the half-space below it deforms as a whole is taken off: displacement is then that of the roughness alone. 0 (default): not.
  void subtract_bulk(double stiffness) { bulk_stiffness_ = stiffness; }
  // The stiffness of a flat square punch of this side; the number is Love's constant for the square in the limit of fine grids.
  static double square_stiffness(double modulus, double side) { return modulus * side / 0.86783; }

  // Makes the contact law of the patch (<roughcontact/law.h>) between these nominal pressures. From then on evaluate() takes it
  // where the history allows it, which takes 10 to 100 ns:
  //   without a hardness   always, because elastic contact without friction has no history
  //   with one             at displacements that no step has exceeded, because a law describes first loading
  // All other trials are solved: unloading, loading again up to the largest displacement, and pressures beyond the law's. Forces
  // by the law are within the tolerance of those by the solver. subtract_bulk() comes before.
  void tabulate(double p_lower, double p_upper, double tolerance = 1e-3);

  // At a displacement from first touch, > 0 into the other body. A trial: it starts from the committed state, so that the answer
  // depends on that and the displacement alone, not on the trials before.
  Answer evaluate(double displacement);

  // Makes the last trial the state from which the next ones start, when the step is accepted.
  void commit() { state_ = trial_; }
  const State& state() const { return state_; }
  void restore(State state) { state_ = std::move(state); }

  double area() const { return area_; }

 private:
  struct Destroy {
    void operator()(rc_contact* contact) const { rc_contact_destroy(contact); }
    void operator()(rc_options* options) const { rc_options_destroy(options); }
    void operator()(rc_law* law) const { rc_law_destroy(law); }
  };

  bool law_holds(double displacement) const;
  Answer press(double approach);
  Answer solve(double displacement);

  rc_system system_;
  std::unique_ptr<rc_options, Destroy> options_;
  std::unique_ptr<rc_contact, Destroy> contact_;
  std::unique_ptr<rc_law, Destroy> law_;
  double law_from_ = 0, law_to_ = 0;  // displacements of its first and last node
  std::vector<double> gap_, indented_gap_;
  State state_, trial_;
  double area_ = 0, bulk_stiffness_ = 0;
};

// All points at once: point i is evaluated by thread i modulo threads, with the same bits whatever their number.
std::vector<ContactLaw::Answer> evaluate_all(std::vector<ContactLaw>& laws, const std::vector<double>& displacements,
                                             int threads);
