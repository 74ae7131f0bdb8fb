#include "table.h"

#include <float.h>
#include <math.h>
#include <stdint.h>

double roughcontact_law_bucket(double x) {
  union {
    double value;
    uint64_t bits;
  } of;
  of.value = x;
  return (double)(int64_t)(of.bits >> 46); /* exponent and six bits of the fraction */
}

static const double* pieces(const double* table) { return table + law_table_head; }
static const double* nodes(const double* table) { return pieces(table) + law_table_piece * (int)table[1]; }
static const double* buckets(const double* table) { return nodes(table) + law_table_node * (int)table[2]; }

static double smaller(double a, double b) { return a < b ? a : b; }
static double larger(double a, double b) { return a > b ? a : b; }

/* The last of n records, stride numbers apart, that begins at or before a value: bisection without a branch. */
static const double* last_at(const double* record, int n, int stride, double value) {
  while (n > 1) {
    const int half = n / 2;
    record += record[half * stride] <= value ? half * stride : 0;
    n -= half;
  }
  return record;
}

static const double* last_piece(const double* table) { return pieces(table) + law_table_piece * ((int)table[1] - 1); }

static const double* piece_at(const double* table, double x) {
  const double* const last = last_piece(table);
  const double bucket = roughcontact_law_bucket(x) - table[4];
  const double* piece = pieces(table);
  if (bucket >= table[5]) return last;
  if (bucket >= 0) piece += law_table_piece * (int)buckets(table)[(int)bucket];
  while (piece < last && piece[law_table_piece] <= x) piece += law_table_piece;
  return piece;
}

static int outside(const double* table, const double* piece, double excess) {
  return piece == last_piece(table) && excess > 0 ? 106 : 0;
}

int roughcontact_law_pressure(const double* table, double x, double* p, double* slope, double* energy) {
  const double* piece;
  double t;
  if (!(x > 0)) {
    if (x != x) return -1;
    *p = 0;
    if (slope) *slope = 0;
    if (energy) *energy = 0;
    return 0;
  }
  if (x > DBL_MAX) return -1;
  piece = piece_at(table, x);
  t = x - piece[0];
  *p = piece[1] + t * (piece[2] + t * piece[3]);
  if (piece < last_piece(table)) *p = smaller(*p, piece[law_table_piece + 1]); /* round-off */
  if (slope) *slope = piece[2] + 2 * t * piece[3];
  if (energy) *energy = piece[4] + t * (piece[1] + t * (piece[2] / 2 + t * (piece[3] / 3)));
  return outside(table, piece, t);
}

/* The slope squared is linear in p on each piece. If a square leaves double precision, the sum is taken of its roots. */
static double slope_on(const double* piece, double excess) {
  const double square = piece[2] * piece[2] + 4 * piece[3] * excess;
  if (square > 1e-280 && square < 1e300) return sqrt(square);
  {
    const double first = piece[2], bent = 2 * sqrt(larger(piece[3], -piece[3])) * sqrt(larger(excess, 0));
    const double most = larger(first, bent), share = most > 0 ? smaller(first, bent) / most : 0;
    if (piece[3] >= 0) return most * sqrt(1 + share * share);
    return first > bent ? first * sqrt((1 - share) * (1 + share)) : 0;
  }
}

/* The piece on which p first reaches a value: of pieces that begin at the same p, all but the last are level. */
static const double* piece_of(const double* table, double p) {
  const double* piece = last_at(pieces(table) + 1, (int)table[1], law_table_piece, p) - 1;
  while (piece > pieces(table) && piece[1] >= p && piece[1 - law_table_piece] >= p) piece -= law_table_piece;
  return piece;
}

int roughcontact_law_overclosure(const double* table, double p, double* x) {
  const double* piece;
  double excess;
  if (!(p > 0)) {
    if (p != p) return -1;
    *x = 0;
    return 0;
  }
  if (p > DBL_MAX) return -1;
  piece = piece_of(table, p);
  excess = p - piece[1];
  *x = excess > 0 ? piece[0] + 2 * excess / (piece[2] + slope_on(piece, excess)) : piece[0];
  if (piece < last_piece(table)) *x = smaller(*x, piece[law_table_piece]);
  return outside(table, piece, excess);
}

int roughcontact_law_slope(const double* table, double p, double* slope) {
  const double* piece;
  if (!(p > 0)) {
    if (p != p) return -1;
    *slope = 0;
    return 0;
  }
  if (p > DBL_MAX) return -1;
  piece = piece_of(table, p);
  *slope = slope_on(piece, p - piece[1]);
  return outside(table, piece, p - piece[1]);
}

void roughcontact_law_envelope(const double* node, const double* next, double x, double* p_lower, double* p_upper) {
  const double t = x - node[0], rest = next[0] - x, share = t / (next[0] - node[0]), bow = share * (1 - share);
  *p_lower = larger(node[1], node[1] + node[3] * t);
  *p_upper = smaller(next[2], next[2] - node[3] * rest);
  if (node[4] < DBL_MAX) { /* a bound is known */
    *p_lower = larger(*p_lower, next[1] - node[4] * rest);
    *p_upper = smaller(*p_upper, node[2] + node[4] * t);
    *p_lower = larger(*p_lower, node[1] + (next[1] - node[1]) * share - node[6] * bow);
    *p_upper = smaller(*p_upper, node[2] + (next[2] - node[2]) * share + node[5] * bow);
  }
}

void roughcontact_law_bounds_at(const double* table, double x, double p, struct roughcontact_law_bounds* bounds) {
  const double* const node = nodes(table) + law_table_node * (int)((piece_at(table, x) - pieces(table)) / (2 * law_table_piece));
  const double* const next = node + law_table_node;
  const double t = x - node[0];
  bounds->slope_lower = larger(0, node[3]);
  bounds->slope_upper = node[4];
  bounds->area_lower = node[9];
  if (node == nodes(table) + law_table_node * ((int)table[2] - 1)) {
    bounds->p_lower = node[1] + node[3] * t;
    bounds->p_upper = t > 0 ? HUGE_VAL : node[2];
    bounds->area = smaller(1, node[8] * p / node[7]);
    bounds->area_upper = t > 0 ? 1 : node[10];
    return;
  }
  {
    const double rise = next[7] - node[7], share = rise > 0 ? (p - node[7]) / rise : 0;
    roughcontact_law_envelope(node, next, x, &bounds->p_lower, &bounds->p_upper);
    bounds->area = node[8] + (next[8] - node[8]) * larger(0, smaller(1, share));
    bounds->area_upper = next[10];
    if (!(node[4] < DBL_MAX)) { /* the sets are not known to be nested */
      bounds->area_lower = smaller(node[9], next[9]);
      bounds->area_upper = larger(node[10], next[10]);
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
