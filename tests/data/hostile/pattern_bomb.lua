-- expect: string.find is not there
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    string.find(("a"):rep(500), ("a?"):rep(500) .. ("a"):rep(500))
  end,
}
