/* Structs of another size than the library's: rc_..._init writes the bytes that it is told of and leaves what is behind them.
 * What a call does with such structs is in errors.table. */
#include <roughcontact/roughcontact.h>
#include <stdio.h>
#include <string.h>

static int checks, failures;

static void check(int holds, const char* what) {
  ++checks;
  if (holds) return;
  ++failures;
  fprintf(stderr, "FAILED: %s\n", what);
}

/* For the size of an older header, today's, and that of a newer one, whose end must be zero. */
#define CHECK_INIT(type, shorter)                                                                                   \
  do {                                                                                                              \
    static const size_t sizes[] = {shorter, sizeof(type), sizeof(type) + 40};                                       \
    union {                                                                                                         \
      type value;                                                                                                   \
      unsigned char bytes[sizeof(type) + 128];                                                                      \
    } u;                                                                                                            \
    size_t i, k, end;                                                                                               \
    for (i = 0; i < 3; ++i) {                                                                                       \
      memset(&u, 0xa5, sizeof u);                                                                                   \
      (type##_init)(&u.value, sizes[i]);                                                                            \
      check(u.value.struct_size == sizes[i], #type "_init says the size it was given");                             \
      for (end = sizeof u; end > 0 && u.bytes[end - 1] == 0xa5; --end) {                                            \
      }                                                                                                             \
      check(end <= sizes[i], #type "_init writes no more than the caller's struct");                                \
      check(end + 8 > sizes[i], #type "_init writes all of the caller's struct");                                   \
      for (k = sizeof(type); k < end; ++k) check(u.bytes[k] == 0, #type "_init leaves what it does not know zero"); \
    }                                                                                                               \
  } while (0)

int main(void) {
  CHECK_INIT(rc_system, 88);
  CHECK_INIT(rc_step, 48);
  CHECK_INIT(rc_result, 432);
  CHECK_INIT(rc_context_config, 40);
  CHECK_INIT(rc_path, 120);
  CHECK_INIT(rc_batch, 200);
  CHECK_INIT(rc_state, 72);
  CHECK_INIT(rc_level, 88);
  CHECK_INIT(rc_direct, 248);
  CHECK_INIT(rc_area, 40);
  CHECK_INIT(rc_patches, 96);
  CHECK_INIT(rc_histogram, 80);
  printf("%d checks, %d failed\n", checks, failures);
  return failures != 0;
}
