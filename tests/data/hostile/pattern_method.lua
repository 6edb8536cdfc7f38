-- expect: string.gsub is not there
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    state.text = ("x"):gsub(".", function() return ("x"):rep(1000) end)
  end,
}
