-- expect: KiB|instructions
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    for _ = 1, 400 do state.list = { state.list, {}, {} } end
  end,
}
