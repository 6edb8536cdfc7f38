-- expect: in one piece
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    for i = 1, 1e9 do state.list[i] = i end
  end,
}
