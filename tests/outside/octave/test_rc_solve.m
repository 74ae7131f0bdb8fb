% What rc_solve takes, returns and refuses; its folder is on the path.
1;

function check (name, holds)
  if (! holds)
    error ("FAILED: %s", name);
  endif
endfunction

function e = refused (z, opts)
  e = struct ("identifier", "", "message", "no error");
  try
    rc_solve (z, opts);
  catch e
  end_try_catch
endfunction

printf ("testing %s\n", which ("rc_solve"));
nx = 40; ny = 28;
[ix, iy] = ndgrid (1:nx, 1:ny);
z = cos (0.9 * ix) .* cos (0.5 * iy) + cos (0.21 * ix + 0.17 * iy);
opts = struct ("hx", 0.5, "hy", 0.25, "modulus", 3, "boundary", "free", "approach", 0.4);

[p, info] = rc_solve (z, opts);
check ("shape of p", isequal (size (p), [nx, ny]) && isequal (size (info.gap), [nx, ny]));
check ("explained", ! isempty (strfind (info.explanation, [info.solver, " on ", info.backend, ": "])));
check ("certified", info.status == 0 && strcmp (info.status_name, "RC_OK") && isempty (info.message));
check ("load", abs (sum (p(:)) * 0.5 * 0.25 / info.load - 1) < 1e-12);
check ("the highest point is in contact", p(z == max (z(:))) > 0);
check ("help", ! isempty (strfind (help ("rc_solve"), "opts")));
check ("one output", isequal (rc_solve (z, opts), p));
check ("single heights", norm (rc_solve (single (z), opts) - p) < 1e-4 * norm (p));

% x is the first index
turned = opts; turned.hx = opts.hy; turned.hy = opts.hx;
check ("transposed", norm (rc_solve (z', turned)' - p) < 1e-6 * norm (p));
periodic = opts; periodic.boundary = "periodic";

by_name = opts;
by_name.solver = "nnls"; by_name.backend = "dense"; by_name.kernel = "galerkin"; by_name.tol = 1e-10;
by_name.stiffness = true; by_name.nnls_pivoting = "single"; by_name.max_iter = 5000;
[~, info] = rc_solve (z, by_name);
check ("names", strcmp ({info.solver, info.backend, info.kernel}, {"nnls", "dense", "galerkin"}));
check ("options", info.stiffness > 0 && info.tolerance == 1e-10);

% flow through the gap, and the pressure at which it ends
leaking = periodic; leaking.leak = "viscosity=1,drop=12";
if (isempty (strfind (refused (z, leaking).message, "-DRC_SOLVE_FLOW")))
  [~, along_x] = rc_solve (z, leaking);
  leaking.leak = "viscosity=1,drop=12,along=y";
  turned = periodic; turned.hx = opts.hy; turned.hy = opts.hx; turned.leak = leaking.leak;
  [~, info] = rc_solve (z', turned);
  check ("leak", along_x.flow.lower > 0 && along_x.flow.lower <= along_x.flow.flow && along_x.flow.constriction_x >= 1);
  check ("leak of the transposed", abs (info.flow.flow / along_x.flow.flow - 1) < 1e-3);
  closing = rmfield (periodic, "approach"); closing.closing_pressure = "x";
  [~, info] = rc_solve (z, closing);
  check ("closing pressure", info.flow.lower > 0 && info.flow.upper < 1.02 * info.flow.lower);
  by_pressure = rmfield (leaking, "approach"); by_pressure.pressure = 1;
  by_pressure.leak = "viscosity=1";
  e = refused (z, by_pressure);
  check ("a leak without a drop", ! isempty (strfind (e.message, "opts.leak: \"viscosity=1\" needs both")));
endif

masked = opts;
masked.mask = z < 1.9;
holes = z; holes(! masked.mask) = NaN;
masked.approach = 0.2;
p = rc_solve (holes, masked);
check ("masked points carry nothing", all (p(! masked.mask) == 0) && any (p(:) > 0));
masked.mask = int32 (5 * masked.mask);
check ("a mask of integers", isequal (rc_solve (holes, masked), p));
masked.mask = sparse (masked.mask != 0);
check ("a sparse mask", isequal (rc_solve (holes, masked), p));
warning ("off", "roughcontact:assumed");
lastwarn ("");
[~, info] = rc_solve (z, rmfield (setfield (opts, "load", 1), {"boundary", "approach"}));
check ("a boundary that nobody names is periodic, with a warning", info.status == 0);

started = opts; started.p0 = rc_solve (z, opts);
[p, info] = rc_solve (z, started);
check ("an explicit start", info.status == 0);
started.p0 = sparse (started.p0);
check ("a sparse start", isequal (rc_solve (sparse (z), started), p));

e = refused (z, struct ("approach", 0.4, "solvr", "nnls"));
check (["nearest option: ", e.message], strcmp (e.identifier, "roughcontact:RC_ERR_OPTION"));
check (["nearest option: ", e.message], any (strfind (e.message, "solver")));
e = refused (z, setfield (opts, "mask", true));
check (e.message, strcmp (e.identifier, "roughcontact:RC_ERR_SHAPE"));
e = refused (z, setfield (opts, "p0", 1));
check (e.message, strcmp (e.identifier, "roughcontact:RC_ERR_SHAPE"));
e = refused (z, setfield (opts, "tol", {1}));
check (e.message, any (strfind (e.message, "opts.tol must be a number or a text")));
e = refused ("heights", opts);
check (e.message, any (strfind (e.message, "z must be a real matrix")));
e = refused (z, 1);
check (e.message, any (strfind (e.message, "opts must be a struct")));

steep = opts; steep.gradient = true; steep.dJ_dp = 2 * ones (size (z)); steep.dJ_dgap = zeros (size (z));
[~, info] = rc_solve (z, steep);
check ("a gradient", isequal (size (info.gradient.undeformed_gap), [nx, ny]) && info.gradient.target > 0);
[~, info] = rc_solve (z, opts);
check ("no gradient where none is asked for", isempty (info.gradient));
e = refused (z, setfield (steep, "dJ_dgap", 1));
check (e.message, strcmp (e.identifier, "roughcontact:RC_ERR_SHAPE") && any (strfind (e.message, "opts.dJ_dgap")));

% An answer that is not certified is given, with a warning that can be switched off by its name.
warning ("off", "roughcontact:RC_STOP_MAX_ITER");
short = opts; short.max_iter = 1; short.solver = "polonsky-keer";
lastwarn ("", "");
[p, info] = rc_solve (z, short);
check ("stopped early", info.status == 101 && ! isempty (info.message) && any (p(:) > 0));
warning ("on", "roughcontact:RC_STOP_MAX_ITER");
rc_solve (z, short);
[~, id] = lastwarn ();
check ("a warning", strcmp (id, "roughcontact:RC_STOP_MAX_ITER"));

% Bodies that creep, through their times: at a constant approach the load falls as the modulus does.
soft = opts;
soft.creep = "0.5:1s,1.5:1min"; soft.time = [0, logspace(-2, 4, 37)];
[p, info] = rc_solve (z, soft);
check ("a row for each time", isequal (info.history.time, soft.time') && all (info.history.status == 0));
check ("the answer is of the last step", info.load == info.history.load(end));
printf ("all checks hold\n");
