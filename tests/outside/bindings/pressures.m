% As pressures.c.
words = argv ();
[nx, ny] = deal (str2double (words{2}), str2double (words{3}));
file = fopen (words{1}, "rb");
z = fread (file, [nx, ny], "double");
fclose (file);
pitch = str2double (words{4});
opts = struct ("hx", pitch, "hy", pitch, "modulus", str2double (words{5}), "boundary", "free", "approach", str2double (words{6}));
p = rc_solve (z, opts);
file = fopen (words{7}, "wb");
fwrite (file, p, "double");
fclose (file);
