! roughcontact for Fortran: the C interface name for name (rc_...), and procedures in the manner of Fortran (rcf_...). Compile
! the files with your program, in the order that `pkg-config --variable=fortran_source roughcontact-fortran` prints: module files
! are not portable between compilers.
module roughcontact
  use roughcontact_functions
  use roughcontact_strings
  use roughcontact_errors
  use roughcontact_arrays, only: rcf_gap_from_heights
  use roughcontact_options
  use roughcontact_contacts
  use roughcontact_histories
  use roughcontact_derivatives
  use roughcontact_direct
  use roughcontact_products
  use roughcontact_laws
  use roughcontact_analysis
  implicit none
end module
