#include <assert.h>

int main(void) {
  assert(sizeof(char) == 1);
  return 0;
}
