-- Accelerations from positions that an encoder counts, without a filter's lag.
--
-- (p(k+h) - 2 p(k) + p(k-h)) / (h T)² is the acceleration, weighted by a triangle of ±h ticks. What is
-- to be compared with it, a force or a speed, is weighted alike: then the two agree exactly.

local second_difference = {}

-- @return [unit/s²] of values at `rate` [Hz]
function second_difference.of(values, k, h, rate)
  return (values[k + h] - 2 * values[k] + values[k - h]) * (rate / h) ^ 2
end

-- sum over |j| < h of (h - |j|) values[k + j] / h²
function second_difference.weighted(values, k, h)
  local sum = h * values[k]
  for j = 1, h - 1 do sum = sum + (h - j) * (values[k - j] + values[k + j]) end
  return sum / (h * h)
end

return second_difference
