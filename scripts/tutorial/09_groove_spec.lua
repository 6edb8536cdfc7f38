-- 09_groove_spec.lua: what the groove of tutorial 05 has to do, as a spec.
--
-- Teaches: tests of a fixture. `trocar test` runs each `it` in virtual time, in a process of its
-- own; `expect` takes signals of a run, and speaks of them with units. When one fails you see the
-- place, what was expected and found, and the signal around it: change a number and try.

describe("groove", function()
  local run
  before_each(function()
    run = trocar.load("05_first_fixture.lua", { ["groove.stiffness"] = "2 N/mm" }):run { duration = "3 s" }
    expect(run.faults):empty()
  end)

  it("is a spring towards the axis", function()
    local line = run:fit { x = "laparoscope.tool.tip.position.x", y = "groove.force.x" }
    expect(line.slope):near("-2 N/mm", { within = "0.1 %" })
  end)

  it("leaves the tool free along the axis", function()
    expect(run["groove.force.z"]):always("==", "0 N")
  end)

  it("keeps the tip within a millimetre of the axis", function()
    expect(run["groove.distance"]):within("0 mm", "1 mm")
  end)

  it("gives the hand no energy", function()
    expect(run["groove.force"]):energy("<=", "1 mJ", { velocity = run["laparoscope.tool.tip.velocity"] })
  end)
end)

-- Try it:
--   trocar test scripts/tutorial/09_groove_spec.lua
--> scripts/tutorial/09_groove_spec.lua
--> 4 tests: 4 passed, 0 failed
