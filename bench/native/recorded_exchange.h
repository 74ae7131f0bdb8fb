/* Between these two calls what a rank does is written to the file $RC_RECORD_TO/RANK; without that variable nothing is. */
#ifndef RECORDED_EXCHANGE_H
#define RECORDED_EXCHANGE_H

#include "exchange.h"

void record_begin(void);
void record_end(void);

#endif
