-- Means and spreads of lists of numbers.

local statistics = {}

function statistics.mean(values, first, last)
  first, last = first or 1, last or #values
  local sum = 0
  for k = first, last do sum = sum + values[k] end
  return sum / (last - first + 1)
end

-- Standard deviation of a sample; 0 for a single value.
function statistics.spread(values)
  if #values < 2 then return 0 end
  local mean, squares = statistics.mean(values), 0
  for _, value in ipairs(values) do squares = squares + (value - mean) ^ 2 end
  return math.sqrt(squares / (#values - 1))
end

function statistics.rms(values)
  local squares = 0
  for _, value in ipairs(values) do squares = squares + value ^ 2 end
  return math.sqrt(squares / #values)
end

-- A field of each row of a list.
function statistics.column(rows, field)
  local values = {}
  for i, row in ipairs(rows) do values[i] = row[field] end
  return values
end

return statistics
