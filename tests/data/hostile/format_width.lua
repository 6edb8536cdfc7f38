-- expect: invalid conversion
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    state.text = string.format("%99999d", 1)
  end,
}
