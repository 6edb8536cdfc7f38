-- expect: io is not there
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    state.text = io.open("/etc/hostname"):read()
  end,
}
