-- expect: string.rep
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    state.text = (""):rep(1e15)
  end,
}
