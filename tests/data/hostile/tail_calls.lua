-- expect: instructions
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    local function again() return again() end
    again()
  end,
}
