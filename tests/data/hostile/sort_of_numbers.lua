-- expect: instructions
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    for i = 1, 2000 do state.list[i] = -i end
    table.sort(state.list)
  end,
}
