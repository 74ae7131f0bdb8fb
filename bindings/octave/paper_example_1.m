% paper_example_1 ()  or  paper_example_1 (draws)
% Example 1 of Bemporad & Paggi (2015): heights that are independent and uniform on (0, 1), spacing 1, modulus 1, pressed until
% the lowest possible point would touch. How often does greedy elimination (Algorithm 1) end with points that overlap? With the
% paper's influence coefficients (kernel eq9) often, and the more so the more points; with consistent ones never. Every answer
% is checked by the library, and compared with the exact one of nnls.
function failures = paper_example_1(draws)
  if nargin < 1
    draws = 200;
  end
  rand('twister', 1);
  kernels = {'eq9', 'eq9', 'eq9', 'love', 'punch'};
  sides = [5, 10, 20, 10, 10];
  failures = zeros(size(sides));
  expected = {'roughcontact:RC_UNCERTIFIED', 'roughcontact:RC_STOP_STALLED'};
  before = cellfun(@(id) warning('off', id), expected);
  fprintf('kernel   points   draws   greedy fails   largest pressure error\n');
  for k = 1:numel(sides)
    worst = 0;
    for draw = 1:draws
      z = rand(sides(k));
      opts = struct('hx', 1, 'hy', 1, 'modulus', 1, 'boundary', 'free', 'approach', max(z(:)), 'kernel', kernels{k}, 'backend', 'dense', 'tol', 1e-10);
      greedy = opts;
      greedy.solver = 'greedy';
      greedy.greedy_inner = 'cholesky';
      [p, info] = rc_solve(z, greedy);
      if ~strcmp(info.status_name, 'RC_OK')
        failures(k) = failures(k) + 1;
        opts.solver = 'nnls';
        exact = rc_solve(z, opts);
        worst = max(worst, max(abs(p(:) - exact(:))) / max(exact(:)));
      end
    end
    fprintf('%-6s   %6d   %5d   %11.1f%%   %21.1f%%\n', kernels{k}, sides(k)^2, draws, 100 * failures(k) / draws, 100 * worst);
  end
  arrayfun(@(state) warning(state), before);
  if nargout == 0
    clear failures
  end
end
