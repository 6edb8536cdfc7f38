-- expect: non-closable
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    local x <close> = {}
  end,
}
