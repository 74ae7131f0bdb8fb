/* A program without the library: table.c and the numbers of a file. Prints p, slope and energy, the
 * overclosure of p, and both shears after slips of a tenth and a twentieth of x from one x to the next. */
#include <stdio.h>
#include <stdlib.h>

void rclawp_(const double* table, const double* x, double* p, double* slope, double* energy, int* status);
void rclawx_(const double* table, const double* p, double* x, int* status);
void rclawq_(const double* table, const double* mu, const double* nu, const double* before, const double* x, const double* slip,
             double* after, double* forces, int* status);

int main(int argc, char** argv) {
  FILE* file = argc > 1 ? fopen(argv[1], "r") : NULL;
  int n = 0, i, status = 0;
  double* table;
  double state[64] = {0}, forces[10];
  if (!file || fscanf(file, "%d", &n) != 1 || n < 1 || !(table = malloc((size_t)n * sizeof *table))) return 1;
  for (i = 0; i < n; ++i)
    if (fscanf(file, "%lf", table + i) != 1) return 1;
  fclose(file);
  for (i = 2; i < argc; ++i) {
    const double x = atof(argv[i]);
    double p = 0, slope = 0, energy = 0, back = 0;
    rclawp_(table, &x, &p, &slope, &energy, &status);
    rclawx_(table, &p, &back, &status);
    {
      const double mu = 0.3, nu = 0.3, slip[2] = {x / 10, x / 20};
      rclawq_(table, &mu, &nu, state, &x, slip, state, forces, &status);
      printf("%.17g %.17g %.17g %.17g %.17g %.17g\n", p, slope, energy, back, forces[1], forces[2]);
    }
  }
  free(table);
  return 0;
}
