-- expect: instructions
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    math.max = function() while true do state.n = state.n + 1 end end
    math.max(1, 2)
  end,
}
