% [p, info] = rc_solve(z, opts)
%
% Press the height map z into an elastic half-space: pressures p and what is certified of them.
%
% The first index of z runs along x. Fields of opts: the words of docs/words.md, as numbers or texts with units (load = '1mN'); hx, hy
% or pitch; mask; p0; and every option of the library, such as solver, backend, kernel, tol, with _ for the dots of its name.
function varargout = rc_solve(varargin)
  error('rc_solve:binary', 'compile rc_solve.c, and put rc_solve.m and what comes out in one folder');
end
