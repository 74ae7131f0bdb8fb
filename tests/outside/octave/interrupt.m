% Solves again and again until Ctrl-C ends it; says when it has begun, and that it was unwound.
[ix, iy] = ndgrid (1:512, 1:512);
z = cos (0.9 * ix) .* cos (0.5 * iy) + cos (0.021 * ix + 0.017 * iy);
unwind_protect
  opts = struct ("hx", 1, "hy", 1, "modulus", 1, "boundary", "free", "approach", 1, "solver", "gp", "tol", 1e-16, "max_iter", 1e8, "time_limit", 60);
  disp ("solving");
  fflush (stdout);
  rc_solve (z, opts);
  disp ("went on");
unwind_protect_cleanup
  disp ("unwound");
end_unwind_protect
