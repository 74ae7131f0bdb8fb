/* What rc_solve(z, opts) asks for, as rc_solve_mex.c collects it. A function that fails returns a status other than RC_OK and
 * leaves its text in rc_request.message. */
#ifndef ROUGHCONTACT_REQUEST_H
#define ROUGHCONTACT_REQUEST_H

#include <roughcontact/roughcontact.h>

typedef struct rc_request {
  rc_system system;
  rc_step step;
  rc_options* options;
  uint8_t* mask; /* NULL: all points */
  double* undeformed_gap;
  rc_accuracy accuracy; /* out */
  char* explanation;    /* of rc_contact_explain, after a solve */
  char message[1024];
} rc_request;

/* z is nx by ny, first index fastest. Close it in any case. */
rc_status rc_request_open(rc_request* request, int64_t nx, int64_t ny);
void rc_request_close(rc_request* request);

/* A field of opts: hx, hy, modulus, displacement, load, boundary, or an option of the library with '_' for '.'. */
rc_status rc_request_number(rc_request* request, const char* field, double value);
rc_status rc_request_text(rc_request* request, const char* field, const char* value);

/* 0: this point carries no pressure and its height is ignored. */
rc_status rc_request_mask(rc_request* request, int64_t nx, int64_t ny, const uint8_t* mask);

/* The binding's own objections, with printf's formats. */
rc_status rc_request_refuse(rc_request* request, rc_status status, const char* format, ...);

/* heights and p0 (may be NULL) have nx*ny values, as has p; gap may be NULL. interrupted is asked in every iteration. */
rc_status rc_request_solve(rc_request* request, const double* heights, const double* p0, double* p, double* gap,
                           rc_progress_fn interrupted, rc_result* result);

#endif
