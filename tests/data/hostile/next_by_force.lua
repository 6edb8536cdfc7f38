-- expect: next is not there
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    for key in next, state do state[key] = nil end
  end,
}
