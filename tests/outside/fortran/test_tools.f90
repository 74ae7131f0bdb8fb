! Direct routines, analysis, listings and surfaces in the manner of Fortran.
program test_tools
  use roughcontact
  use roughcontact_surface
  use checks
  implicit none
  character(300) :: message
  integer :: stat

  call listings()
  call direct_routines()
  call analysis()
  call surfaces()
  call finish()

contains

  subroutine listings()
    type(rc_system) :: system
    type(rc_component) :: component
    type(c_ptr) :: context
    real(c_double) :: influence(3, 2)
    integer :: k
    logical :: found
    call check('a version: '//rcf_version(), index(rcf_version(), '.') > 0)
    found = .false.
    do k = 1, int(rc_component_count(c_null_ptr, RC_COMPONENT_BACKEND))
      call rcf_component_describe(RC_COMPONENT_BACKEND, k, component)
      found = found .or. rc_from_c(component%name) == 'dense'
    end do
    call check('backend dense', found)
    call rcf_component_describe(RC_COMPONENT_SOLVER, 1, component)
    call check('a solver', len(rc_from_c(component%summary)) > 0)
    k = int(rc_component_count(c_null_ptr, RC_COMPONENT_KERNEL))
    call rcf_component_describe(RC_COMPONENT_KERNEL, k + 1, component, stat=stat)
    call check('no kernel after the last', stat == RC_ERR_ARGUMENT)
    call rcf_component_describe(RC_COMPONENT_OPTION, 1, component)
    call check('an option', rc_from_c(component%name) == RC_OPT_SOLVER .and. len(rc_from_c(component%default_value)) > 0)
    system = rc_system(boundary=RC_BOUNDARY_FREE, nx=4, ny=4, hx=1.0_c_double, hy=1.0_c_double, modulus=1.0_c_double)
    call check('a pair', rcf_pair_supported('nnls', 'dense', system, RC_CONTROL_LOAD))
    call check('no pair', .not. rcf_pair_supported('nnls', 'absent', system, RC_CONTROL_LOAD, errmsg=message) &
      .and. index(message, 'absent') > 0)
    call rcf_context_create(context, plugins=.false., environment=.false.)
    k = int(rc_component_count(c_null_ptr, RC_COMPONENT_BACKEND))
    call check('no plugins', rc_component_count(context, RC_COMPONENT_BACKEND) <= k)
    call rcf_context_destroy(context)
    call rcf_context_create(context, plugin_path='/nowhere', environment=.false.)
    call check('a plugin path', rc_component_count(context, RC_COMPONENT_BACKEND) > 0)
    call rcf_context_destroy(context)
    call rcf_kernel_coefficients('love', 1.0_c_double, 1.0_c_double, influence)
    call check('coefficients', influence(1, 1) > influence(2, 1) .and. abs(influence(2, 1) - influence(1, 2)) < 1e-12)
  end subroutine

  subroutine direct_routines()
    real(c_double), parameter :: H(3, 3) = reshape([2d0, 1d0, 0.5d0, 1d0, 2d0, 1d0, 0.5d0, 1d0, 2d0], [3, 3])
    real(c_double), parameter :: u(3) = [1d0, 0.2d0, 1d0], expected(3) = [0.4d0, 0d0, 0.4d0]
    real(c_double) :: p(3), w(3), z(33, 33), pressure(33, 33), again(33, 33)
    type(rc_direct) :: result
    p = 0
    call rcf_direct(rc_nnls, H, u, p, w, result=result)
    call check('nnls', maxval(abs(p - expected)) < 1e-12 .and. abs(w(2) - 0.6) < 1e-6 .and. result%contacts == 2)
    p = 0
    w = 0
    call rcf_direct(rc_nnls, H, u, w)
    p = 0
    call rcf_direct(rc_nnls, H, u, p, tol=rcf_option_default(RC_OPT_TOL), max_iter=int(rcf_option_default(RC_OPT_MAX_ITER)))
    call check('absent limits are those of the options', all(p == w))
    call rcf_direct(rc_nnls, H, u(1:2), p, stat=stat)
    call check('u is too short', stat == RC_ERR_SHAPE)

    z = rough(33, 33)
    call rcf_cmr(z, 1.0_c_double, 1.0_c_double, 1.0_c_double, 0.5_c_double, 2, pressure, result=result)
    call check('cmr', result%load > 0 .and. count(pressure > 0) == result%contacts)
    call rcf_cmr(z, 1.0_c_double, 1.0_c_double, 1.0_c_double, 0.5_c_double, 2, again, radius=rcf_option_default('cmr.radius'))
    call check('an absent radius is that of the option', all(again == pressure))
  end subroutine

  subroutine analysis()
    real(c_double) :: p(6, 5), density(4)
    integer(c_int64_t) :: label(6, 5), counts(4)
    type(rc_area) :: area
    type(rc_histogram) :: histogram
    integer(c_int32_t) :: contact, gap
    type(rcf_patch), allocatable :: patches(:)
    p = 0
    p(1:2, 1) = [1, 3]
    p(3, 2) = 2
    p(6, 5) = 4
    call rcf_area_measure(p, 0.5_c_double, 2.0_c_double, RC_BOUNDARY_FREE, area)
    call check('area', area%contacts == 4 .and. area%area == 4)
    call rcf_patches_find(p, 1.0_c_double, 1.0_c_double, RC_BOUNDARY_FREE, patches, label)
    call check('three patches', size(patches) == 3 .and. label(2, 1) == 1 .and. label(3, 2) == 2 .and. label(6, 5) == 3)
    call check('their peaks', patches(1)%peak == 2 .and. patches(1)%max_pressure == 3 .and. patches(3)%peak == 30)
    call rcf_patches_find(p, 1.0_c_double, 1.0_c_double, RC_BOUNDARY_PERIODIC, patches, neighbours=8)
    call check('one patch across corners and sides', size(patches) == 1 .and. patches(1)%load == 10)
    call rcf_patches_find(p, 1.0_c_double, 1.0_c_double, RC_BOUNDARY_FREE, patches, mask=p < 4)
    call check('masked', size(patches) == 2)
    call rcf_patches_find(p, 1.0_c_double, 1.0_c_double, RC_BOUNDARY_FREE, patches, mask=reshape([.true.], [1, 1]), stat=stat)
    call check('mask of another shape', stat == RC_ERR_SHAPE .and. size(patches) == 0)
    call rcf_histogram_fill(p, counts, density, histogram=histogram)
    call check('a histogram', all(counts == 1) .and. histogram%width == 1 .and. all(density == 0.25))
    p(:, 3) = 1
    call rcf_crossing_find(p, RC_BOUNDARY_FREE, contact, gap, mask=p < 1)
    call check('a masked ridge does not', contact == RC_CROSSES_NONE .and. gap == RC_CROSSES_X)
  end subroutine

  subroutine surfaces()
    real(c_double) :: fractal(17, 17), cropped(16, 16), waves(32, 24)
    real(c_double), allocatable :: q(:), psd(:), coarse(:, :)
    integer(c_int64_t), allocatable :: modes(:)
    logical, allocatable :: coarse_mask(:, :)
    type(rc_surface_statistics) :: statistics
    type(rc_surface_power_law) :: law
    type(rc_surface_cmr) :: advice
    call rcf_surface_rmd(rc_surface_rmd_spec(levels=6), fractal)
    call rcf_surface_rmd(rc_surface_rmd_spec(levels=6), cropped)
    call check('midpoint displacement with and without the last row', all(fractal(1:16, 1:16) == cropped))
    call rcf_surface_rmd(rc_surface_rmd_spec(levels=6), waves, stat, message)
    call check('not 2^k points: '//trim(message), stat == RC_ERR_SHAPE)
    call rcf_surface_shape(rc_surface_shape_spec(shape=RC_SURFACE_WAVES, period_x=8.0_c_double, height=2.0_c_double), waves)
    call check('waves', waves(1, 1) == 2 .and. waves(9, 7) == 2)
    call rcf_surface_analyze(waves, 1.0_c_double, 1.0_c_double, statistics, periodic=.true.)
    call check('rms height', abs(statistics%rms_height - sqrt(2.0_c_double)) < 1e-12)
    call rcf_surface_spectral(rc_surface_spectral_spec(rms_height=0.1_c_double), waves)
    call rcf_surface_psd(waves, 1.0_c_double, 1.0_c_double, q, psd, modes, periodic=.true.)
    call check('the spectrum sums to the variance', abs(sum(psd * modes) / (32 * 24) / 0.01_c_double - 1) < 1e-9)
    call rcf_surface_fit(waves, 1.0_c_double, 1.0_c_double, law, periodic=.true.)
    call check('a fit', law%peaks >= 0)
    call rcf_surface_cmr_advice(waves, 1.0_c_double, 1.0_c_double, 1, advice, periodic=.true.)
    call check('advice', len(rc_from_c(advice%reason)) > 0 .and. advice%levels == 1)
    call rcf_surface_downsample(waves, RC_SURFACE_MAX, coarse, waves > minval(waves), coarse_mask)
    call check('maxima', all(shape(coarse) == [16, 12]) .and. maxval(coarse) == maxval(waves) .and. all(coarse_mask))
    call rcf_surface_downsample(waves, RC_SURFACE_SUBSAMPLE, coarse)
    call check('every second point', all(coarse == waves(1::2, 1::2)))
    call rcf_surface_fit(0 * waves, 1.0_c_double, 1.0_c_double, law, stat=stat, errmsg=message)
    call check('a flat map: '//trim(message), stat == RC_ERR_ARGUMENT .and. len_trim(message) > 0)
  end subroutine
end program
