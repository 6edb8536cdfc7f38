-- Prints a table with its columns lined up; cells are texts and numbers.

local function width(text) return utf8.len(text) or #text end

return function(title, head, lines)
  local widths = {}
  for _, line in ipairs { head, table.unpack(lines) } do
    for i, cell in ipairs(line) do
      widths[i] = math.max(widths[i] or 0, width(tostring(cell)))
    end
  end
  local function text(line)
    local cells = {}
    for i, cell in ipairs(line) do
      cell = tostring(cell)
      cells[i] = (" "):rep(widths[i] - width(cell)) .. cell
    end
    return "  " .. table.concat(cells, "  ")
  end
  print(title)
  print(text(head))
  for _, line in ipairs(lines) do print(text(line)) end
  print()
end
