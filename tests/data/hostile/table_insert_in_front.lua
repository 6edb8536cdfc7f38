-- expect: instructions
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    while true do table.insert(state.list, 1, 0) end
  end,
}
