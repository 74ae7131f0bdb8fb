#include "table.h"

#include <float.h>
#include <math.h>
#include <stdint.h>

typedef struct law_table_head Head;
typedef struct law_table_piece Piece;
typedef struct law_table_node Node;

double roughcontact_law_bucket(double x) {
  union {
    double value;
    uint64_t bits;
  } of;
  of.value = x;
  return (double)(int64_t)(of.bits >> 46); /* exponent and six bits of the fraction */
}

static double smaller(double a, double b) { return a < b ? a : b; }
static double larger(double a, double b) { return a > b ? a : b; }

static const Piece* piece_at(const double* table, double x) {
  const Head* const head = law_head(table);
  const Piece *piece = law_pieces(table), *const last = law_last_piece(table);
  const double bucket = roughcontact_law_bucket(x) - head->first_bucket;
  if (bucket >= head->buckets) return last;
  if (bucket >= 0) {
    const double* const buckets = (const double*)(law_nodes(table) + (int)head->nodes);
    piece += (int)buckets[(int)bucket];
  }
  while (piece < last && piece[1].x <= x) ++piece;
  return piece;
}

/* The piece on which p first reaches a value > 0: of pieces that begin at the same p, all but the last are level. */
static const Piece* piece_of(const double* table, double p) {
  const Piece *const first = law_pieces(table), *piece = first;
  int n;
  for (n = (int)law_head(table)->pieces; n > 1; n -= n / 2) /* bisection without a branch */
    piece += piece[n / 2].p <= p ? n / 2 : 0;
  while (piece > first && piece->p >= p && piece[-1].p >= p) --piece;
  return piece;
}

static int status_on(const Piece* piece, const Piece* last, double excess) { return piece == last && excess > 0 ? 106 : 0; }

int roughcontact_law_pressure(const double* table, double x, double* p, double* slope, double* energy) {
  const Piece *piece, *last;
  double t, pressure;
  if (!(x > 0)) {
    if (x != x) return -1;
    *p = 0;
    if (slope) *slope = 0;
    if (energy) *energy = 0;
    return 0;
  }
  if (x > DBL_MAX) return -1;
  piece = piece_at(table, x);
  last = law_last_piece(table);
  t = x - piece->x;
  pressure = piece->p + t * (piece->slope + t * piece->half_bend);
  *p = piece < last ? smaller(pressure, piece[1].p) : pressure; /* round-off */
  if (slope) *slope = piece->slope + 2 * t * piece->half_bend;
  if (energy) *energy = piece->energy + t * (piece->p + t * (piece->slope / 2 + t * (piece->half_bend / 3)));
  return status_on(piece, last, t);
}

/* The slope squared is linear in p on each piece. If a square leaves double precision, the sum is taken of its roots. */
static double slope_on(const Piece* piece, double excess) {
  const double square = piece->slope * piece->slope + 4 * piece->half_bend * excess;
  if (square > 1e-280 && square < 1e300) return sqrt(square);
  {
    const double first = piece->slope, bent = 2 * sqrt(larger(piece->half_bend, -piece->half_bend)) * sqrt(larger(excess, 0));
    const double most = larger(first, bent), share = most > 0 ? smaller(first, bent) / most : 0;
    if (piece->half_bend >= 0) return most * sqrt(1 + share * share);
    return first > bent ? first * sqrt((1 - share) * (1 + share)) : 0;
  }
}

int roughcontact_law_overclosure(const double* table, double p, double* x) {
  const Piece *piece, *last;
  double excess, overclosure;
  if (!(p > 0)) {
    if (p != p) return -1;
    *x = 0;
    return 0;
  }
  if (p > DBL_MAX) return -1;
  piece = piece_of(table, p);
  last = law_last_piece(table);
  excess = p - piece->p;
  overclosure = excess > 0 ? piece->x + 2 * excess / (piece->slope + slope_on(piece, excess)) : piece->x;
  *x = piece < last ? smaller(overclosure, piece[1].x) : overclosure; /* round-off */
  return status_on(piece, last, excess);
}

int roughcontact_law_slope(const double* table, double p, double* slope) {
  const Piece* piece;
  if (!(p > 0)) {
    if (p != p) return -1;
    *slope = 0;
    return 0;
  }
  if (p > DBL_MAX) return -1;
  piece = piece_of(table, p);
  *slope = slope_on(piece, p - piece->p);
  return status_on(piece, law_last_piece(table), p - piece->p);
}

void roughcontact_law_envelope(const Node* node, const Node* next, double x, double* p_lower, double* p_upper) {
  const double h = next->x - node->x, t = x - node->x, rest = next->x - x, share = t / h, bow = share * (1 - share);
  *p_lower = larger(node->p_lower, node->p_lower + node->between_lower * t);
  *p_upper = smaller(next->p_upper, next->p_upper - node->between_lower * rest);
  if (!(node->between_upper < DBL_MAX)) return;
  *p_lower = larger(*p_lower, next->p_lower - node->between_upper * rest);
  *p_upper = smaller(*p_upper, node->p_upper + node->between_upper * t);
  *p_lower = larger(*p_lower, node->p_lower + (next->p_lower - node->p_lower) * share - node->below * bow);
  *p_upper = smaller(*p_upper, node->p_upper + (next->p_upper - node->p_upper) * share + node->above * bow);
}

void roughcontact_law_bounds_at(const double* table, double x, double p, struct roughcontact_law_bounds* bounds) {
  const Node* const node = law_nodes(table) + (piece_at(table, x) - law_pieces(table)) / 2; /* two pieces from node to node */
  const Node* const next = node + 1;
  bounds->node = (int)(node - law_nodes(table));
  bounds->slope_lower = larger(0, node->between_lower);
  bounds->slope_upper = node->between_upper;
  bounds->area_lower = node->area_lower;
  if (bounds->node == (int)law_head(table)->nodes - 1) { /* there is no next one: the area grows as p does */
    const double t = x - node->x;
    bounds->p_lower = node->p_lower + node->between_lower * t;
    bounds->p_upper = t > 0 ? HUGE_VAL : node->p_upper;
    bounds->area = smaller(1, node->area * p / node->p);
    bounds->area_upper = t > 0 ? 1 : node->area_upper;
    return;
  }
  {
    const double rise = next->p - node->p, share = rise > 0 ? (p - node->p) / rise : 0;
    roughcontact_law_envelope(node, next, x, &bounds->p_lower, &bounds->p_upper);
    bounds->area = node->area + (next->area - node->area) * larger(0, smaller(1, share));
    bounds->area_upper = next->area_upper;
    if (!(node->between_upper < DBL_MAX)) { /* the sets are not known to be nested */
      bounds->area_lower = smaller(node->area_lower, next->area_lower);
      bounds->area_upper = larger(node->area_upper, next->area_upper);
    }
  }
}

typedef struct law_slip_layer Layer;
typedef struct law_slip_state State;
typedef struct { /* what is below a height in a stack of layers: sums of d times thickness and of d times the rise of p */
  double x, p, held[2], shear[2];
} Below;

static double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1]; }

/* Adds a layer, or its lower part, up to where p is known. */
static void add_below(Below* below, const double* d, double x, double p) {
  int i;
  for (i = 0; i < 2; ++i) {
    below->held[i] += d[i] * (x - below->x);
    below->shear[i] += d[i] * (p - below->p);
  }
  below->x = x;
  below->p = p;
}

static int is_state(const State* state) {
  const int n = state->layers >= 0 && state->layers <= LAW_SLIP_LAYERS ? (int)state->layers : -1;
  return n == state->layers && state->x >= -DBL_MAX && state->x <= DBL_MAX &&
         (n == 0 ? !(state->x > 0) : state->x > 0 && state->layer[n - 1].x == state->x);
}

/* Joins the two neighbouring layers whose shear this changes least. The slip that they hold stays. */
static void join_layers(State* state) {
  const int n = (int)state->layers;
  double x = 0, p = 0, least = HUGE_VAL, share = 0;
  int k, i, at = 0;
  for (k = 0; k + 1 < n; ++k) {
    const Layer *const low = &state->layer[k], *const high = low + 1;
    const double w = low->x - x, v = high->x - low->x, rise = low->p - p, upper = high->p - low->p;
    const double a = low->d[0] - high->d[0], b = low->d[1] - high->d[1];
    const double change = sqrt(a * a + b * b) * fabs(v * rise - w * upper) / (w + v);
    if (change < least) least = change, share = w / (w + v), at = k;
    x = low->x;
    p = low->p;
  }
  for (i = 0; i < 2; ++i) state->layer[at + 1].d[i] = share * state->layer[at].d[i] + (1 - share) * state->layer[at + 1].d[i];
  for (k = at; k + 1 < n; ++k) state->layer[k] = state->layer[k + 1];
  state->layers = n - 1;
  state->joined += least;
}

static void put_layer(State* state, const Layer* top) {
  int n = (int)state->layers;
  if (n > 0 && state->layer[n - 1].d[0] == top->d[0] && state->layer[n - 1].d[1] == top->d[1]) --n; /* one layer */
  if (n == LAW_SLIP_LAYERS) join_layers(state), n = (int)state->layers;
  state->layer[n] = *top;
  state->layers = n + 1;
}

/* Up to which share of a layer's thickness w the layers above turn: |goal - held at x + s| = rest - s, where `goal` and `rest`
   are counted from the layer's bottom, and 0 <= s <= w. The form without cancellation. */
static double turned_from(const double* goal, const double* d, double rest, double w) {
  const double half = rest - dot(goal, d), square = rest * rest - dot(goal, goal);
  const double root = half * half - (1 - dot(d, d)) * square, sum = half + sqrt(larger(0, root));
  return sum > 0 ? larger(0, smaller(w, square / sum)) : 0;
}

typedef struct { /* a step while it is made: the layers up to the lower of both overclosures, and where they have to go */
  const double* table;
  double mu, unit; /* slip over the thickness of a layer that holds it with d = 1 */
  double slope, goal[2];
  Layer top;
  State* state;
  double *shear, *by_x, *by_goal; /* over mu */
} Step;

/* Nothing slips: what is new, or else nothing, holds the rest of the slip. */
static void press_on(Step* step, const Below* below, const double* rest) {
  const double thick = step->top.x - below->x, part = thick > 0 ? 1 / thick : 0, rise = step->top.p - below->p;
  const double chord = thick > 0 ? rise * part : step->slope;
  int i;
  for (i = 0; i < 2; ++i) {
    step->top.d[i] = rest[i] * part;
    step->shear[i] = below->shear[i] + step->top.d[i] * rise;
    step->by_x[i] = step->top.d[i] * (step->slope - chord);
    step->by_goal[3 * i] = chord;
  }
  if (thick > 0) put_layer(step->state, &step->top);
}

/* The layers from some height on turn to where the slip goes, all of them if k < 0; below[k] is the lowest that turns. */
static void turn(Step* step, const Below* below, int k) {
  State* const state = step->state;
  const Layer* const top = &step->top;
  const int first = k < 0 ? 0 : k;
  double v[2], *const e = step->top.d, d[2] = {0, 0}, slope = 0, lag, far, part, rise, secant, upper, sum = 0;
  Layer cut = {0, 0, 0, {0, 0}};
  Below at = below[0];
  int i, j;
  if (k >= 0) {
    for (i = 0; i < 2; ++i) cut.d[i] = d[i] = state->layer[k].d[i], v[i] = step->goal[i] - below[k].held[i];
    cut.x = below[k].x + turned_from(v, d, top->x - below[k].x, below[k + 1].x - below[k].x);
    roughcontact_law_pressure(step->table, cut.x, &cut.p, &slope, &cut.energy);
    at = below[k];
    add_below(&at, d, cut.x, cut.p);
  }
  for (i = 0; i < 2; ++i) v[i] = step->goal[i] - at.held[i];
  far = k < 0 ? sqrt(dot(v, v)) : top->x - cut.x;
  part = far > 0 ? 1 / far : 0;
  for (i = 0; i < 2; ++i) e[i] = v[i] * part;
  lag = 1 - dot(e, d);
  rise = top->p - cut.p;
  secant = rise * part;
  for (i = 0; i < 2; ++i) { /* a change of x and of the goal moves `cut` by (dx - e.dgoal)/lag */
    const double moved = k < 0        ? 0
                         : lag > 1e-9 ? -((e[i] - d[i]) * slope + secant * (d[i] - e[i] * (1 - lag))) / lag
                                      : -e[i] * slope;
    step->shear[i] = at.shear[i] + e[i] * rise;
    step->by_x[i] = e[i] * step->slope + moved;
    for (j = 0; j < 2; ++j) step->by_goal[2 * i + j] = secant * ((i == j) - e[i] * e[j]) - moved * e[j];
  }

  /* Each dissipates (1 - e.d) (2 integral of (p(x) - p) - (x - at) (p(x) - p(at))). What slides as a whole comes on top. */
  upper = (top->x - cut.x) * rise;
  for (j = first; j < (int)state->layers; ++j) {
    const Layer *const layer = &state->layer[j], *const low = j > first ? layer - 1 : &cut;
    const double left = (top->x - layer->x) * (top->p - layer->p);
    sum += (1 - dot(e, layer->d)) * (2 * (top->p * (layer->x - low->x) - (layer->energy - low->energy)) + left - upper);
    upper = left;
  }
  if (k < 0) sum = larger(0, sum) + (far - top->x) * top->p;
  state->dissipated += step->mu * step->unit * larger(0, sum);
  state->layers = first;
  if (k >= 0 && cut.x > below[k].x) put_layer(state, &cut);
  put_layer(state, top);
}

int roughcontact_law_slip(const double* table, double mu, double nu, const double* before, double x, const double* slip,
                          double* after, double* forces) {
  const State* const old = (const State*)before;
  const double x0 = old->x, low = smaller(x, x0), stiffness = (2 - 2 * nu) / (2 - nu);
  double share, rest[2] = {0, 0};
  Below below[LAW_SLIP_LAYERS + 1];
  Step step;
  State* const next = step.state = (State*)after;
  int status, n, k, i;
  if (!(mu >= 0 && mu <= DBL_MAX && nu >= 0 && nu <= 0.5) || !(x >= -DBL_MAX && x <= DBL_MAX) || !is_state(old)) return -1;
  if (!(fabs(slip[0]) <= DBL_MAX && fabs(slip[1]) <= DBL_MAX) || law_head(table)->hardness > 0) return -1;
  if (law_head(table)->conductance != law_head(table)->conductance) return -1;
  for (i = 0; i < LAW_SLIP_FORCES; ++i) forces[i] = 0;
  n = (int)old->layers;
  next->dissipated = old->dissipated;
  next->joined = x > 0 ? old->joined : 0;
  next->layers = 0;
  next->x = x;
  if (!(x > 0)) return 0; /* without contact nothing is held */
  status = roughcontact_law_pressure(table, x, &step.top.p, &step.slope, &step.top.energy);
  step.table = table;
  step.top.x = x;
  step.mu = mu;
  step.unit = mu / stiffness;
  step.shear = forces + 1, step.by_x = forces + 4, step.by_goal = forces + 6;
  share = x0 > 0 ? 1 : x / (x - x0); /* of the slip, after first touch */

  /* The layers that stay, and how much slip all of them hold. */
  below[0].x = below[0].p = below[0].held[0] = below[0].held[1] = below[0].shear[0] = below[0].shear[1] = 0;
  for (i = 0; i < 2; ++i) step.goal[i] = mu > 0 ? slip[i] * (share / step.unit) : 0;
  for (k = 0; k < n; ++k) {
    const Layer layer = old->layer[k];
    const double bottom = k > 0 ? old->layer[k - 1].x : 0;
    for (i = 0; i < 2; ++i) step.goal[i] += layer.d[i] * (layer.x - bottom);
    if (bottom >= low) continue;
    if (next != old) next->layer[k] = layer;
    below[k + 1] = below[k];
    add_below(&below[k + 1], layer.d, smaller(layer.x, low), layer.x <= low ? layer.p : step.top.p);
    next->layers = k + 1;
  }
  n = (int)next->layers;
  if (n > 0 && low == x) next->layer[n - 1].x = x, next->layer[n - 1].p = step.top.p, next->layer[n - 1].energy = step.top.energy;

  for (k = n; k >= 0; --k) { /* the first height from which on all could hold the rest */
    for (i = 0; i < 2; ++i) rest[i] = step.goal[i] - below[k].held[i];
    if (dot(rest, rest) <= (x - below[k].x) * (x - below[k].x)) break;
  }
  if (k == n) {
    press_on(&step, &below[n], rest);
  } else {
    turn(&step, below, k);
  }
  forces[0] = step.top.p;
  forces[3] = step.slope;
  for (i = 0; i < 2; ++i) {
    forces[1 + i] *= mu;
    if (x0 < 0 && mu > 0) step.by_x[i] -= dot(step.by_goal + 2 * i, slip) * x0 / ((x - x0) * (x - x0) * step.unit);
    step.by_x[i] *= mu;
  }
  for (i = 0; i < 4; ++i) step.by_goal[i] *= mu > 0 ? share * stiffness : 0; /* by the slip */
  return status;
}

void roughcontact_law_slip_bounds(const double* table, double mu, const double* state, double* lower, double* upper) {
  const State* const now = (const State*)state;
  const int convex = law_head(table)->convex > 0;
  struct roughcontact_law_bounds from = {0, 0, 0, 0, 0, 0, 0, 0}, to = from;
  double x = 0;
  int k, i;
  lower[0] = lower[1] = upper[0] = upper[1] = 0;
  for (k = 0; k < (int)now->layers; ++k, from = to) {
    const Layer* const layer = &now->layer[k];
    const double thick = layer->x - x;
    double least, most;
    roughcontact_law_bounds_at(table, layer->x, layer->p, &to);
    least = larger(0, to.p_lower - from.p_upper);
    most = to.p_upper - from.p_lower;
    if (convex) {
      least = larger(least, thick * from.slope_lower);
      if (to.slope_upper < DBL_MAX) most = smaller(most, thick * to.slope_upper);
    }
    for (i = 0; i < 2; ++i) {
      if (layer->d[i] == 0) continue;
      lower[i] += mu * layer->d[i] * (layer->d[i] > 0 ? least : most);
      upper[i] += mu * layer->d[i] * (layer->d[i] > 0 ? most : least);
    }
    x = layer->x;
  }
  for (i = 0; i < 2 && now->layers > 0; ++i) {
    lower[i] = larger(lower[i], -mu * to.p_upper);
    upper[i] = smaller(upper[i], mu * to.p_upper);
  }
}

#ifdef ROUGHCONTACT_LAW_FORTRAN /* CALL RCLAWP(TABLE, X, P, SLOPE, ENERGY, ISTAT), RCLAWX(TABLE, P, X, ISTAT), RCLAWS(TABLE, P, \
                                   SLOPE, ISTAT), RCLAWQ(TABLE, MU, NU, BEFORE, X, SLIP, AFTER, FORCES, ISTAT) */
void rclawp_(const double* table, const double* x, double* p, double* slope, double* energy, int* status) {
  *status = roughcontact_law_pressure(table, *x, p, slope, energy);
}
void rclawx_(const double* table, const double* p, double* x, int* status) {
  *status = roughcontact_law_overclosure(table, *p, x);
}
void rclaws_(const double* table, const double* p, double* slope, int* status) {
  *status = roughcontact_law_slope(table, *p, slope);
}
void rclawq_(const double* table, const double* mu, const double* nu, const double* before, const double* x, const double* slip,
             double* after, double* forces, int* status) {
  *status = roughcontact_law_slip(table, *mu, *nu, before, *x, slip, after, forces);
}
#endif
