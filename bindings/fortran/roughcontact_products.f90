! Products u = H p with the influence matrix of a system, for programs that have a solver of their own.
module roughcontact_products
  use roughcontact_arrays
  use roughcontact_errors
  use roughcontact_functions
  use roughcontact_options, only: rcf_or_null
  implicit none
  private
  public :: rcf_product, rcf_product_create, rcf_product_apply, rcf_product_destroy

  ! Not to be copied: one variable, destroyed once. One thread at a time.
  type :: rcf_product
    type(c_ptr) :: handle = c_null_ptr  ! for the rc_ functions
    integer(c_int64_t) :: nx = 0, ny = 0
  end type

contains

  ! system%dense and what system%user points to must be targets that outlive the product.
  subroutine rcf_product_create(product, system, options, stat, errmsg)
    type(rcf_product), intent(out) :: product
    type(rc_system), intent(in) :: system
    type(c_ptr), intent(in), optional :: options
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    product%nx = system%nx
    product%ny = system%ny
    call rcf_check(rc_product_create(system, rcf_or_null(options), product%handle), stat, errmsg)
  end subroutine

  subroutine rcf_product_destroy(product)
    type(rcf_product), intent(inout) :: product
    call rc_product_destroy(product%handle)
    product = rcf_product()
  end subroutine

  ! Deflections u(nx, ny) under pressures p(nx, ny) of any sign.
  subroutine rcf_product_apply(product, p, u, stat, errmsg)
    type(rcf_product), intent(in) :: product
    real(c_double), intent(in), target, contiguous :: p(:, :)
    real(c_double), intent(inout), target, contiguous :: u(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    if (.not. rcf_shaped('rcf_product_apply', 'p', p, product%nx, product%ny, stat, errmsg)) return
    if (.not. rcf_shaped('rcf_product_apply', 'u', u, product%nx, product%ny, stat, errmsg)) return
    call rcf_check(rc_product_apply(product%handle, rcf_in(p), rcf_out(u)), stat, errmsg)
  end subroutine
end module
