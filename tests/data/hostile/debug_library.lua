-- expect: debug is not there
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    debug.sethook()
  end,
}
