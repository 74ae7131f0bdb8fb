% What rc_surface_read takes, returns and refuses; its folder is on the path.
1;

function check (name, holds)
  if (! holds)
    error ("FAILED: %s", name);
  endif
endfunction

function e = refused (varargin)
  e = struct ("identifier", "", "message", "no error");
  try
    rc_surface_read (varargin{:});
  catch e
  end_try_catch
endfunction

path = [tempname(), ".txt"];
file = fopen (path, "w");
fprintf (file, "1 2 3\n2 nan 4\n");
fclose (file);
[z, info] = rc_surface_read (path, struct ("pitch", [2, 3], "unit", "um"));
check ("x is the first index", isequal (size (z), [3, 2]) && abs (z(3, 1) - 3e-6) < 1e-18);
check ("missing", isnan (z(2, 2)) && info.missing == 1 && nnz (isnan (z)) == 1);
check ("pitch", abs (info.hx - 2e-6) < 1e-18 && abs (info.hy - 3e-6) < 1e-18);
check (info.assumed, strcmp (info.assumed, "lengths without a unit are in um, as asked for"));
check ("format", strcmp (info.format, "text") && info.periodic == -1);
check ("one output", isequaln (rc_surface_read (path, struct ("unit", "um")), z));
check ("help", ! isempty (strfind (help ("rc_surface_read"), "opts")));
lastwarn ("", "");
rc_surface_read (path, struct ("unit", "m"));
check ("a given unit is not assumed", isempty (lastwarn ()));
[~, info] = rc_surface_read (path);
[text, identifier] = lastwarn ();
check (text, strcmp (identifier, "roughcontact:assumed_unit") && any (strfind (text, "m is taken")));
check ("no pitch", info.hx == 0 && any (strfind (info.assumed, "the pitch is not known")));
e = refused ("absent.txt");
check (e.message, strcmp (e.identifier, "roughcontact:RC_ERR_ARGUMENT") && any (strfind (e.message, "No such file")));
e = refused (path, struct ("pich", 1));
check (e.message, any (strfind (e.message, "opts.pich is not pitch, height_range, unit or format")));
e = refused (path, struct ("pitch", "one"));
check (e.message, any (strfind (e.message, "opts.pitch must be")));
e = refused (path, struct ("unit", 1));
check (e.message, any (strfind (e.message, "opts.unit must be a text")));
e = refused ();
check (e.message, any (strfind (e.message, "usage")));
delete (path);
disp ("all checks hold");
