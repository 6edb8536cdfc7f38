-- expect: os is not there
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    os.execute("touch hostile")
  end,
}
