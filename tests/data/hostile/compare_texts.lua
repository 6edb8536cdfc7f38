-- expect: instructions
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    local zeros = ("\0"):rep(1024)
    local other = ("\0"):rep(1023) .. "x"
    while true do if zeros > other then state.n = 1 end end
  end,
}
