! The constants of the headers but surface.h, formats.h, flow.h, ranks.h, mpi.h and plugin.h, name for name.
! Written by scripts/bindings.py.
module roughcontact_constants
  use, intrinsic :: iso_c_binding
  implicit none

  integer, parameter :: rc_status = c_int32_t  ! the kind of a status
  integer(c_int32_t), parameter :: RC_VERSION_MAJOR = 0, RC_VERSION_MINOR = 1, RC_VERSION_PATCH = 0, RC_ABI = 0
  integer(c_int32_t), parameter :: RC_OK = 0, RC_WITHIN_GOAL = 100, RC_STOP_MAX_ITER = 101, RC_STOP_TIME = 102, &
    RC_STOP_CANCELLED = 103, RC_STOP_STALLED = 104, RC_UNCERTIFIED = 105, RC_OUTSIDE = 106, RC_ERR_ARGUMENT = -1, &
    RC_ERR_SHAPE = -2, RC_ERR_OPTION = -3, RC_ERR_NO_BACKEND = -4, RC_ERR_NO_SOLVER = -5, RC_ERR_INCOMPATIBLE = -6, &
    RC_ERR_PLUGIN = -7, RC_ERR_MEMORY = -8, RC_ERR_INFEASIBLE = -9, RC_ERR_NUMERIC = -10, RC_ERR_EXTERNAL = -11, &
    RC_ERR_BUSY = -12, RC_ERR_INTERNAL = -99
  integer(c_int32_t), parameter :: RC_NATIVE = 0, RC_SINGLE = 1
  integer(c_int32_t), parameter :: RC_OPERATOR_HALFSPACE = 1, RC_OPERATOR_DENSE = 2, RC_OPERATOR_CALLBACK = 3
  integer(c_int32_t), parameter :: RC_BOUNDARY_FREE = 1, RC_BOUNDARY_PERIODIC = 2, RC_BOUNDARY_PERIODIC_X = 3, &
    RC_BOUNDARY_PERIODIC_Y = 4
  integer(c_int32_t), parameter :: RC_CONTROL_APPROACH = 1, RC_CONTROL_LOAD = 2, RC_CONTROL_AREA = 4, RC_CONTROL_PRESSURE = 8
  integer(c_int32_t), parameter :: RC_CREEP_COMPLIANCES = 0, RC_CREEP_MODULI = 1
  integer(c_int32_t), parameter :: RC_BATCH_SHARED = -1
  integer(c_int32_t), parameter :: RC_CROSSES_NONE = 0, RC_CROSSES_X = 1, RC_CROSSES_Y = 2
  integer(c_int32_t), parameter :: RC_LAW_BULK_AUTO = 0, RC_LAW_BULK_NONE = 1, RC_LAW_BULK_GIVEN = 2, RC_LAW_BULK_MEAN = 3
  integer(c_int32_t), parameter :: RC_LAW_CONVEX = 1, RC_LAW_SLOPES = 2, RC_LAW_MONOTONE = 3
  integer(c_int32_t), parameter :: RC_LAW_CSV = 1, RC_LAW_CALCULIX = 2, RC_LAW_ABAQUS = 3, RC_LAW_MOOSE = 4, RC_LAW_TABLE = 5
  integer(c_int32_t), parameter :: RC_LOG_INFO = 1, RC_LOG_WARNING = 2
  integer(c_int32_t), parameter :: RC_CONTEXT_NO_PLUGINS = 1, RC_CONTEXT_NO_ENVIRONMENT = 2
  integer(c_int32_t), parameter :: RC_COMPONENT_SOLVER = 1, RC_COMPONENT_BACKEND = 2, RC_COMPONENT_KERNEL = 3, &
    RC_COMPONENT_OPTION = 4
  integer(c_int32_t), parameter :: RC_TYPE_INT = 1, RC_TYPE_REAL = 2, RC_TYPE_TEXT = 3
  character(*), parameter :: RC_OPT_SOLVER = 'solver', RC_OPT_BACKEND = 'backend', RC_OPT_KERNEL = 'kernel', RC_OPT_TOL = 'tol', &
    RC_OPT_MAX_ITER = 'max_iter', RC_OPT_TIME_LIMIT = 'time_limit', RC_OPT_THREADS = 'threads', RC_OPT_STIFFNESS = 'stiffness', &
    RC_OPT_ALLOW_FALLBACK = 'allow_fallback', RC_OPT_CERTIFY_BACKEND = 'certify_backend', RC_OPT_WARMUP = 'warmup', &
    RC_OPT_WARMUP_ITERATIONS = 'warmup.iterations', RC_OPT_BOUNDS = 'bounds', RC_OPT_RESUMABLE = 'resumable', &
    RC_OPT_ACCURACY = 'accuracy', RC_OPT_ACCURACY_OF = 'accuracy.of'
end module
