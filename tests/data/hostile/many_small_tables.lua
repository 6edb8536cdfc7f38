-- expect: KiB|instructions
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    while true do state.list = { state.list, {}, {}, {} } end
  end,
}
