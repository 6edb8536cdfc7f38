-- expect: in one piece|overflow
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    local function deep() return 1 + deep() end
    deep()
  end,
}
