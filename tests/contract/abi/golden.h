/* The binary interface, in golden.txt: every constant, struct size and member offset where pointers have 64 bits, as C that
 * golden.py writes. Nothing there may change while RC_ABI and RC_PLUGIN_ABI_MAJOR stay as they are; members may only be added at
 * the end of a sized struct. Compiles as C99 to C17, C++17 and C++20. The tests of the bindings read the same numbers. */
#include <stddef.h>

/* An array of negative size where the condition does not hold: the one assertion that all three languages have. */
#define VALUE(name, value) typedef char value_of_##name[(name) == (value) ? 1 : -1]
#define SIZE(type, bytes) typedef char size_of_##type[sizeof(void*) != 8 || sizeof(type) == (bytes) ? 1 : -1]
#define AT(type, member, offset) \
  typedef char type##_at_##member[sizeof(void*) != 8 || offsetof(type, member) == (offset) ? 1 : -1]
