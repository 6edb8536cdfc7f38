-- expect: a text of more than
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    for i = 1, 200 do state.list[i] = "0123456789" end
    state.text = table.concat(state.list)
  end,
}
