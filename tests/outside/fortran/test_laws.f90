! Contact laws in the manner of Fortran.
program test_laws
  use roughcontact
  use checks
  implicit none
  character(300) :: message
  character(*), parameter :: file = 'test_laws.law'
  type(rc_system) :: system
  type(rc_law_spec) :: spec
  type(c_ptr) :: law
  real(c_double) :: p, slope, energy, conductance, of_it, ps(2), slopes(2), energies(2)
  integer :: stat
  type(rc_law_slip_state) :: state

  system = rc_system(op=RC_OPERATOR_HALFSPACE, boundary=RC_BOUNDARY_PERIODIC, nx=24, ny=20, hx=1, hy=1, modulus=1)
  spec = rc_law_spec(p_lower=1e-3_c_double, p_upper=5e-2_c_double, tolerance=1e-2_c_double)
  call rcf_law_create(law, system, rcf_gap_from_heights(rough(24, 20)), spec)
  call rcf_law_save(law, file)
  call check('p', rc_law_pressure(law, 0.5_c_double, of_it) >= 0)
  call rcf_law_open('law1', file, 1)
  call rcf_law_at(1, 0.5_c_double, p, slope, energy, stat)
  call check('a law by number', stat >= 0 .and. p == of_it .and. p > 0 .and. slope > 0 .and. energy > 0)
  call rcf_law_at(1, [-1._c_double, 0.5_c_double], ps, slopes, energies, stat)
  call check('a law at a vector', stat >= 0 .and. all(ps == [0._c_double, p]) .and. all(slopes == [0._c_double, slope]) .and. &
    all(energies == [0._c_double, energy]))
  call rcf_law_at(1, [0.5_c_double, 1e3_c_double], ps, slopes, energies, stat)
  call check('one of them outside', stat == RC_OUTSIDE .and. ps(1) == p)
  call rcf_law_at(1, [0.5_c_double], ps, slopes, energies, stat)
  call check('vectors of two lengths', stat == RC_ERR_ARGUMENT)
  call rcf_law_at(1, ps(:0), ps(:0), slopes(:0), energies(:0), stat)
  call check('no points', stat == RC_OK)
  call rcf_law_gap_conductance(1, p, 0.5_c_double, 0.5_c_double, conductance, stat)
  call check('its conductance', stat >= 0 .and. abs(conductance / (2 * slope) - 1) < 1e-9)
  state = rc_law_slip_state(mu=0.5_c_double, nu=0.25_c_double)
  call rcf_law_slip(1, state, 0.5_c_double, [0._c_double, 0._c_double], stat)
  call check('pressed', stat >= 0 .and. state%p == of_it .and. all(state%shear == 0))
  state%nu = 0.6_c_double
  call rcf_law_slip(1, state, 0.5_c_double, [0._c_double, 0._c_double], stat)
  call check('a bad nu', stat == RC_ERR_ARGUMENT)
  call rcf_law_at(2, [0.5_c_double, 1._c_double], ps, slopes, energies, stat)
  call check('no such law for a vector', stat == RC_ERR_ARGUMENT)
  call rcf_law_open('law2', 'no such file', 2, stat, message)
  call check('no file: '//trim(message), stat == RC_ERR_ARGUMENT .and. index(message, 'cannot be read') > 0)
  call rcf_law_destroy(law)
  spec%max_nodes = 3
  spec%tolerance = 1e-4_c_double
  call rcf_law_create(law, system, rcf_gap_from_heights(rough(24, 20)), spec, stat=stat, errmsg=message)
  call check('too few nodes', stat == RC_STOP_MAX_ITER .and. c_associated(law))
  call rcf_law_save(law, file)
  call rcf_law_open('law3', file, 3, stat, message)
  call check('its status: '//trim(message), stat == RC_STOP_MAX_ITER .and. index(message, 'rc_law_spec.max_nodes') > 0)
  call rcf_law_at(3, 0.5_c_double, p, slope, energy, stat)
  call check('it is there', stat >= 0 .and. p > 0)
  call rcf_law_destroy(law)
  call rcf_law_create(law, system, rcf_gap_from_heights(rough(20, 20)), spec, stat=stat, errmsg=message)
  call check('shapes', stat == RC_ERR_SHAPE)
  open (unit=7, file=file)
  close (7, status='delete')
  call finish()
end program
