-- expect: string.rep
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    state.text = ("x"):rep(1e9)
  end,
}
