/* The evaluation of a contact law from its table. table.c and this file depend on nothing but sqrt, so that a program can compile
 * them in, and read the numbers that rc_law_export writes as RC_LAW_TABLE: first how many there are, then the numbers.
 *
 * The numbers of a table are, from 0 on:
 *   how many numbers   pieces   nodes   2 / E*   first bucket   buckets   0   0
 *   pieces: x, p, dp/dx, half of d2p/dx2 and energy where each begins; two for an interval between nodes, one beyond the last
 *   nodes: x, p_lower, p_upper, between_lower, between_upper, above, below, p, area, area_lower, area_upper; up to the next
 *     node, p is at most above s (1 - s) higher and below s (1 - s) lower than the chord, s being the share of the interval
 *   buckets: the last piece that begins at or before each of 64 values of x an octave
 * Every function returns 0, 106 (RC_OUTSIDE) beyond the last node or -1 (RC_ERR_ARGUMENT) for NaN and infinity, and keeps
 * nothing. */
#ifndef ROUGHCONTACT_LAW_TABLE_H
#define ROUGHCONTACT_LAW_TABLE_H

#ifdef __cplusplus
extern "C" {
#endif

enum { law_table_head = 8, law_table_piece = 5, law_table_node = 11 };

/* In which of 64 buckets an octave a number > 0 is; exact in a double. */
double roughcontact_law_bucket(double x);

int roughcontact_law_pressure(const double* table, double x, double* p, double* slope,
                              double* energy); /* slope, energy: or NULL */
int roughcontact_law_overclosure(const double* table, double p, double* x);
int roughcontact_law_slope(const double* table, double p, double* slope); /* by the pressure */

struct roughcontact_law_bounds {
  double p_lower, p_upper, area, area_lower, area_upper, slope_lower, slope_upper;
};
/* At an overclosure > 0 and its pressure. */
void roughcontact_law_bounds_at(const double* table, double x, double p, struct roughcontact_law_bounds* bounds);

/* The bounds of p between two neighbouring nodes of a table. */
void roughcontact_law_envelope(const double* node, const double* next, double x, double* p_lower, double* p_upper);

#ifdef __cplusplus
}
#endif
#endif
