% [z, info] = rc_surface_read(path, opts)
%
% Read a surface file: heights z in metres, the first index along x, NaN where a point is missing.
%
% Fields of opts: pitch, a number or [hx, hy]; unit ('um') of pitch, height_range and lengths whose unit the file does not name;
% height_range of pictures of whole numbers (TIFF, PNG); format. Fields of info: hx, hy (0 where nobody says them), missing (points), periodic, format, assumed.
function varargout = rc_surface_read(varargin)
  error('rc_surface_read:binary', 'compile rc_surface_read.c, and put rc_surface_read.m and what comes out in one folder');
end
