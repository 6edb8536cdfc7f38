-- expect: in one piece|instructions
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    -- Keys that all want the same place of a table of 1023 others.
    for i = 1, 1e9 do state.list[i * 1023 * 2047 * 4095] = i end
  end,
}
