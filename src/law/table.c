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
  bounds->slope_lower = larger(0, node->between_lower);
  bounds->slope_upper = node->between_upper;
  bounds->area_lower = node->area_lower;
  if (node == law_nodes(table) + ((int)law_head(table)->nodes - 1)) { /* there is no next one: the area grows as p does */
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

#ifdef ROUGHCONTACT_LAW_FORTRAN /* CALL RCLAWP(TABLE, X, P, SLOPE, ENERGY, ISTAT), RCLAWX(TABLE, P, X, ISTAT), RCLAWS(TABLE, P, \
                                   SLOPE, ISTAT) */
void rclawp_(const double* table, const double* x, double* p, double* slope, double* energy, int* status) {
  *status = roughcontact_law_pressure(table, *x, p, slope, energy);
}
void rclawx_(const double* table, const double* p, double* x, int* status) {
  *status = roughcontact_law_overclosure(table, *p, x);
}
void rclaws_(const double* table, const double* p, double* slope, int* status) {
  *status = roughcontact_law_slope(table, *p, slope);
}
#endif
