-- expect: a text of more than
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    while true do state.text = state.text .. state.text end
  end,
}
