-- expect: setmetatable is not there
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    setmetatable({}, { __gc = function() while true do state.n = state.n + 1 end end })
  end,
}
