// The kernels behind the registry in kernel.cpp: one table-filling function each, arguments as in kernel.h.
#pragma once

#include <cstdint>

namespace rc::kernel {

void love(double hx, double hy, std::int64_t mx, std::int64_t my, double* out);
void galerkin(double hx, double hy, std::int64_t mx, std::int64_t my, double* out);

// Square cells: hy is hx.
void disc(double hx, double hy, std::int64_t mx, std::int64_t my, double* out);
void punch(double hx, double hy, std::int64_t mx, std::int64_t my, double* out);
void eq9(double hx, double hy, std::int64_t mx, std::int64_t my, double* out);

}  // namespace rc::kernel
