-- expect: instructions
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    for i = 1, 500 do state.list[i] = i end
    while true do table.sort(state.list, function() return true end) end
  end,
}
