! Without stat= an error ends the program with the library's message.
program error_stop
  use roughcontact
  implicit none
  type(rcf_contact) :: contact
  call rcf_contact_create(contact, rc_system(boundary=RC_BOUNDARY_FREE, nx=8, ny=8, hx=-1.0_c_double))
  print '(a)', 'went on'
end program
