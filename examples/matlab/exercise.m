% The course exercise in MATLAB or Octave; writes mine.csv with the columns t, xr, yr, xb, yb and no header.
L = 1; r = 0.075; alpha = 0.8; dt = 0.03; T = 5; x = [0.1 0.5; 0.1 1.0]; v = [3 0; 4 0]; rows = [0 x(:)'];
for k = 1:ceil(T / dt)
  h = min(dt, T - rows(end, 1)); wall = [L; 2 * L] .* (v > 0) - r * sign(v); crosses = (x + v * h - wall) .* v > 0;
  times = (wall - x) ./ v; times(~crosses) = h; [time, axis] = min(max(times, 0)); hit = find(any(crosses));
  factor = ones(2); factor(:, hit) = alpha; factor(axis(hit) + 2 * (hit - 1)) = -alpha;
  d = x(:, 1) - x(:, 2); c = v(:, 1) - v(:, 2); n = d / norm(d); meet = max(0, (norm(d) - 2 * r) / norm(c));
  met = norm(d + c * h) <= 2 * r && d' * c < 0 && meet <= min(time);
  if met, x = x + v * meet; v = v + n * (n' * c) * [-1 1]; else, x = x + v .* time; v = v .* factor; end
  rows(k + 1, :) = [min(k * dt, T) x(:)'];
end, dlmwrite('mine.csv', rows, 'precision', '%.17g');
