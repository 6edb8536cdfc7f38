-- expect: not finite
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    out.force.x = 0 / 0
  end,
}
