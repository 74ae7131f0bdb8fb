/* The evaluation of a contact law from its table. table.c and this file depend on nothing but sqrt, so that a program can compile
 * them in, and read the numbers that rc_law_export writes as RC_LAW_TABLE: first how many there are, then the numbers.
 *
 * A table consists of doubles: its head, its pieces, its nodes and its buckets. A bucket is the number of the last piece that
 * begins at or before a value of x; there are 64 such values an octave. Every function of type int returns 0, 106
 * (RC_OUTSIDE) beyond the last node or -1 (RC_ERR_ARGUMENT) for NaN and infinity. No function keeps anything. */
#ifndef ROUGHCONTACT_LAW_TABLE_H
#define ROUGHCONTACT_LAW_TABLE_H

#ifdef __cplusplus
extern "C" {
#endif

struct law_table_head {
  double numbers, pieces, nodes; /* how many: numbers in the table, pieces, nodes */
  double conductance;            /* 2 / E*: the conductance over dp/dx, times the sum of both resistivities; NaN: none */
  double first_bucket, buckets;  /* roughcontact_law_bucket of the first one, and how many there are */
  double hardness;               /* 0: none */
  double convex;                 /* 1: RC_LAW_CONVEX between all nodes, else 0 */
};

/* A parabola, up to where the next piece begins: two between two nodes, and one beyond the last node. */
struct law_table_piece {
  double x, p, slope, half_bend, energy; /* where it begins: x, p, dp/dx, half of d2p/dx2, and the integral of p over x */
};

struct law_table_node {
  double x, p_lower, p_upper;
  double between_lower, between_upper; /* bounds of dp/dx up to the next node; DBL_MAX: no bound is known */
  double above, below; /* up to the next node, at the share s of the interval, p is at most above s (1 - s) higher than the chord
                          of p_upper, and at most below s (1 - s) lower than that of p_lower */
  double p, area, area_lower, area_upper; /* areas over the nominal area */
};

static inline const struct law_table_head* law_head(const double* table) { return (const struct law_table_head*)table; }
static inline const struct law_table_piece* law_pieces(const double* table) {
  return (const struct law_table_piece*)(law_head(table) + 1);
}
static inline const struct law_table_piece* law_last_piece(const double* table) {
  return law_pieces(table) + ((int)law_head(table)->pieces - 1);
}
static inline const struct law_table_node* law_nodes(const double* table) {
  return (const struct law_table_node*)(law_last_piece(table) + 1);
}

/* In which of 64 buckets an octave a number > 0 is; exact in a double. */
double roughcontact_law_bucket(double x);

int roughcontact_law_pressure(const double* table, double x, double* p, double* slope,
                              double* energy); /* slope, energy: or NULL */
int roughcontact_law_overclosure(const double* table, double p, double* x);
int roughcontact_law_slope(const double* table, double p, double* slope); /* by the pressure */

struct roughcontact_law_bounds {
  double p_lower, p_upper, area, area_lower, area_upper, slope_lower, slope_upper;
  int node; /* the last one at or before the overclosure, from 0 */
};
/* At an overclosure > 0 and its pressure. */
void roughcontact_law_bounds_at(const double* table, double x, double p, struct roughcontact_law_bounds* bounds);

/* The bounds of p between two neighbouring nodes. */
void roughcontact_law_envelope(const struct law_table_node* node, const struct law_table_node* next, double x, double* p_lower,
                               double* p_upper);

/* Slip, see rc_law_slip. The patch at the overclosure x is a stack of layers, from first touch (0) to x. In a layer the share d
 * of the friction acts, a vector of length 0 to 1: the shear is mu times the sum of d times the rise of p in the layer, and the
 * slip that it holds is mu (2 - nu)/(2 - 2 nu) times the sum of d times the layer's thickness. Slip turns the uppermost layers.
 *
 * Ciavarella (1998), Jaeger (1998): equal shares in one direction; Aleshin, Bou Matar & Van Den Abeele (2015), Method of memory
 * diagrams: any history. */
enum { LAW_SLIP_LAYERS = 12, LAW_SLIP_NUMBERS = 4 + 5 * LAW_SLIP_LAYERS, LAW_SLIP_FORCES = 10 };

struct law_slip_layer {
  double x, p, energy; /* at its top */
  double d[2];
};

struct law_slip_state { /* LAW_SLIP_NUMBERS doubles; all 0 before the first step */
  double x, layers, dissipated;
  double joined; /* by how much joining layers may have changed the shear, over mu */
  struct law_slip_layer layer[LAW_SLIP_LAYERS];
};

/* A step to the overclosure x with the slip slip[2] in it. before and after may be the same. forces: p, shear[2], dp/dx,
 * dshear/dx [2], dshear/dslip [4] by rows. -1 also for mu < 0, nu outside 0 to 0.5, a state that no step has left, and a law with
 * a hardness or without a conductance. */
int roughcontact_law_slip(const double* table, double mu, double nu, const double* before, double x, const double* slip,
                          double* after, double* forces);
/* The bounds of the shear in a state. */
void roughcontact_law_slip_bounds(const double* table, double mu, const double* state, double* lower, double* upper);

#ifdef __cplusplus
}
#endif
#endif
