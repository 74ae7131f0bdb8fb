/* A good plugin whose file changes places with another one as soon as it is loaded. */
#define _GNU_SOURCE
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>

__attribute__((constructor)) static void replace(void) {
  const char *const own = getenv("RC_TEST_REPLACED"), *const other = getenv("RC_TEST_BY");
  if (own && other && renameat2(AT_FDCWD, other, AT_FDCWD, own, RENAME_EXCHANGE) != 0) perror(own);
}

#include "fixture.c"
