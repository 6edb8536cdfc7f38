-- expect: setmetatable is not there
return trocar.fixture {
  state = { list = {}, text = "x", n = 0 },
  step = function(p, at, out, state)
    local t = {}
    for _ = 1, 1000 do t = setmetatable({}, { __index = t }) end
    out.force.x = t.missing
  end,
}
