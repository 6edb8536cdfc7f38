-- expect: instructions
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    while true do state.text = string.format("%99.99f%99.99f", 1e308, 1e308) end
  end,
}
