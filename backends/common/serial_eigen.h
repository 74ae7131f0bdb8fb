// Eigen without threads of its own, whatever the compiler flags: results must not depend on the number of threads.
#pragma once

#ifndef EIGEN_DONT_PARALLELIZE
#define EIGEN_DONT_PARALLELIZE
#endif
#include <Eigen/Core>
