// `roughcontact backends`, `solvers`, `kernels` and `options`: what the library has, as tables on standard output.
#pragma once

namespace cli {

void list_backends();
void list_solvers();
void list_kernels();
void list_options();

}  // namespace cli
