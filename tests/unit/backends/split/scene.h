// Sets of points, an operator of the backend on them, and the products by summing over all sources.
#pragma once

#include <roughcontact/plugin.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "contract/backends/stand_in_host.h"

namespace split {

using Vector = std::vector<double>;
using Floats = std::vector<float>;
using Index = std::vector<std::int64_t>;

const rc_backend& backend();

struct Grid {
  std::int64_t nx, ny;
  double hx = 1.0, hy = 1.0;
  std::string kernel = "love";

  std::int64_t points() const { return nx * ny; }
};

// H by its coefficients.
class Reference {
 public:
  explicit Reference(const Grid& grid);
  // (H x) at points, x over the domain.
  Vector product(const Index& points, const Index& domain, const Vector& x) const;

 private:
  Grid grid_;
  Vector table_;
};

class Operator {
 public:
  Operator(const Grid& grid, const std::string& spacing = "auto", const std::string& threads = "1");
  ~Operator();
  Operator(const Operator&) = delete;
  Operator& operator=(const Operator&) = delete;

  void bind(const Index& domain);
  Vector apply(const Vector& x);
  Floats apply_float(const Vector& x);
  Vector field(const Vector& x);
  void screen(const Vector& x, rc_screen& request);
  std::int64_t modelled() { return backend().modelled(self_); }

 private:
  contract::StandInHost host_;
  rc_system system_;
  std::string kernel_;
  rc::ThreadTeam team_;
  rc_operator_spec spec_;
  void* self_ = nullptr;
  Index domain_;
};

using Random = std::mt19937;
double uniform(Random& random);

// Round islands that cover about `share` of the grid.
Index islands(const Grid& grid, double share, Random& random);
// Positive at about half of the points, 0 at the others.
Vector pressures(const Index& domain, Random& random);
Index every_point(const Grid& grid);
// At most `count` of the points, evenly.
Index some_of(const Index& points, std::size_t count);

double largest(const Vector& values);
double largest_difference(const Vector& a, const Vector& b);
double largest_difference(const Floats& a, const Vector& b);

// 1: all; smaller in slow builds.
double effort();

// The tests.
void every_kernel_is_accurate(void** state);
void every_spacing_is_accurate(void** state);
void cells_need_not_be_square(void** state);
void any_domain_is_accurate(void** state);
void rebinding_equals_a_fresh_operator(void** state);
void a_growing_domain_equals_a_fresh_operator(void** state);
void pressure_far_from_the_domain_s_middle_counts(void** state);
void results_do_not_depend_on_threads(void** state);
void long_cells_are_refused(void** state);
void periodic_grids_are_refused(void** state);
void modelled_points_follow_the_domain(void** state);
void screen_finds_what_overlaps(void** state);
void screen_proves_no_more_than_holds(void** state);
void screen_counts_beyond_its_room(void** state);
void screen_respects_the_mask(void** state);
void screen_of_nothing_finds_all_below_the_approach(void** state);
void known_lowest_gaps_change_nothing(void** state);
void tiles_known_to_lie_apart_are_not_looked_at(void** state);
void rows_are_screened_alone(void** state);
void any_allocation_may_fail(void** state);

}  // namespace split
