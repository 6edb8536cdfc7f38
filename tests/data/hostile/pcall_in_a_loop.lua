-- expect: instructions
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    while true do pcall(function() while true do state.n = state.n + 1 end end) end
  end,
}
