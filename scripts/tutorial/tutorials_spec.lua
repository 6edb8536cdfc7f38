-- What the tutorials show, as assertions over signals. Run: trocar test scripts/tutorial

describe("01_feel_a_wall", function()
  local run
  before_each(function()
    run = trocar.load("01_feel_a_wall.lua"):run { duration = "5 s" }
    expect(run.faults):empty()
  end)

  it("pushes back against the hand, and never pulls", function()
    expect(run["wall.force.z"]):always("<=", "0 N")
    expect(run["wall.force.z"]):crosses("-1 N", { times = 1, way = "down", before = "1.5 s" })
  end)

  it("is a spring of the stiffness that was asked for", function()
    local line = run:fit { x = "wall.depth", y = "wall.load", from = "1.5 s" }
    expect(line.slope):near("2.2 N/mm", { within = "0.1 %" })
  end)

  it("gives the hand no energy", function()
    expect(run["wall.force"]):energy("<=", "0.1 mJ", { velocity = run["laparoscope.tool.tip.velocity"] })
  end)
end)

describe("02_incision", function()
  it("renders springs that are softer than asked for, as drives and friction make them", function()
    local rows = trocar.experiment("02_incision.lua").published.table1
    expect(#rows):equals(4)
    for i, stiffness in ipairs { "5 N/mm", "15 N/mm", "6 N/mm", "18 N/mm" } do
      expect(rows[i].desired):equals(stiffness)
      expect(rows[i].slope):near(stiffness, { within = "6 %" })
      expect(rows[i].r2):is(">=", 0.97)
    end
  end)
end)

describe("03_tilted", function()
  it("does not sag", function()
    local done = trocar.experiment("03_tilted.lua")
    expect(done.runs[1].faults):empty()
    expect(done.published.drift[1].tip):near(0, { within = "10 um" })
  end)

  it("sags where the mount is not known to the compensation", function()
    local rig = trocar.load("03_tilted.lua", { ["gravity_compensation.mount"] = { pitch = "0 deg" } })
    local run = rig:run { duration = "2 s" }
    expect(run.faults):empty()
    expect(run:drift("laparoscope_kinematics.tip.position")):is(">", "5 mm")
  end)
end)

describe("04_two_rates", function()
  local run
  before_each(function()
    run = trocar.load("04_two_rates.lua"):run { duration = "8 s" }
    expect(run.faults):empty()
  end)

  it("moves the surface with the breath, and lets it yield", function()
    expect(run["surface.value"]):within("-5 mm", "3 mm")
    expect(run["creep.depth"]):always(">=", "0 mm")
    expect(run["creep.depth"]):eventually(">", "0.4 mm")
  end)

  it("reads no surface that is stale", function()
    expect(run["wall.offset_valid"]):always("==", true, { from = "0.05 s" })
  end)
end)

describe("05_first_fixture", function()
  it("feels like the wall of C++ beside the groove of Lua", function()
    local run = trocar.load("05_first_fixture.lua"):run { duration = "3 s" }
    expect(run.faults):empty()
    expect(run["wall.force.z"]):settles("-8.15 N", { before = "2 s", within = "1 %" })
    expect(run["groove.script.allocations"]):always("==", 0)
  end)
end)

describe("06_parameters", function()
  it("is harder to cross when the fluid is thicker", function()
    local rows = trocar.experiment("06_parameters.lua").published.fluid
    expect(rows[2].force):is("<", 4 * rows[1].force)
    expect(rows[2].speed):is("<", rows[1].speed)
  end)

  it("never pushes more than its limit", function()
    local run = trocar.experiment("06_parameters.lua").runs[2]
    expect(run["fluid.force"]:norm()):always("<=", "6.000001 N")
    expect(run["fluid.force"]):energy("<=", 0, { velocity = run["laparoscope.tool.tip.velocity"] })
  end)
end)

describe("07_state", function()
  it("passes teeth one way only", function()
    local run = trocar.experiment("07_state.lua").runs[1]
    expect(run.faults):empty()
    expect(run["ratchet.teeth"]):settles(27, { within = 0.5 })
    expect(run["ratchet.force.z"]):always(">=", "0 N")
  end)
end)

describe("08_moving_fixture", function()
  it("takes the tool along", function()
    local run = trocar.experiment("08_moving_fixture.lua").runs[1]
    expect(run["laparoscope.tool.tip.position.x"]):crosses("0 mm", { times = 3 })
    expect(run["moving_groove.distance"]):within("0 mm", "0.6 mm")
  end)
end)

describe("10_group", function()
  it("adds what its layers bear", function()
    local run = trocar.experiment("10_group.lua").runs[1]
    local parts = run:last("layers.skin.load") + run:last("layers.bone.load")
    expect(run:last("layers.sum.value")):near(parts, { within = 1e-9 })
    expect(run["layers.bone.depth"]):eventually(">", "2 mm")
  end)
end)

describe("11_sweep", function()
  it("finds devices that differ, all softer than asked for", function()
    local published = trocar.experiment("11_sweep.lua").published
    expect(#published.device):equals(5)
    expect(published.all[1].spread):is(">", 0)
    for _, row in ipairs(published.device) do
      expect(row.slope):near("5 N/mm", { within = "6 %" })
    end
  end)
end)

describe("12_reload", function()
  it("takes one version over, and refuses the other", function()
    local run = trocar.experiment("12_reload.lua").runs[1]
    expect(run.faults):empty()
    expect(#run.reloads):equals(2)
    expect(run.reloads[1].trouble):equals("")
    expect(run.reloads[2].trouble):contains("the output \"distance\" has gone")
    expect(run["groove.force.x"]):within("-0.8 N", "0.2 N")
  end)
end)

describe("13_spacemouse", function()
  local run
  before_each(function()
    run = trocar.load("13_spacemouse.lua"):run { duration = "4 s" }
    expect(run.faults):empty()
  end)

  it("moves the goal while the cap is pushed, and keeps it when nobody pushes", function()
    local goal = run["steer.goal.x"]
    expect(goal):within("0.3 mm", "0.5 mm", { to = "0.49 s" })
    expect(run:at("steer.goal.x", "1 s") - run:at("steer.goal.x", "0.49 s")):near("30 mm", { within = "1 %" })
    expect(run["mouse.translation.x"]):always("==", 0, { from = "1.1 s" })
  end)

  it("takes the tool along", function()
    expect(run["laparoscope.tool.tip.position.x"]):settles("35.4 mm", { before = "2.5 s", within = "0.5 mm" })
  end)

  it("is held up by the wall, as a hand is", function()
    expect(run["wall.force.z"]):settles("-4.9 N", { before = "3 s", within = "0.1 N" })
    expect(run["steer.force"]:norm()):always("<=", "6.5 N")
  end)

  it("knows that the mouse is there, and when it sends", function()
    expect(run["mouse.status"]):crosses(1.5, { times = 4 })
    expect(run["mouse.connections"]):always("==", 1)
  end)
end)
