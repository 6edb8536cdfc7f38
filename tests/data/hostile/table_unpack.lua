-- expect: table.unpack
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    state.n = select("#", table.unpack({}, 1, 1e7))
  end,
}
