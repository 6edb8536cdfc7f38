-- expect: instructions
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    local ok
    repeat ok = pcall(function() while true do state.n = state.n + 1 end end) until ok
  end,
}
