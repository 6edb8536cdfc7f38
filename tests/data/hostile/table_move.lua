-- expect: table.move is not there
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    table.move({}, 1, 1e15, 2)
  end,
}
