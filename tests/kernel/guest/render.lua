-- render.lua: the first tutorial's graph on the device, at args.rate, with what the way to the
-- device did to it. Runs inside of the kernel test.
dofile("/trocar/01_feel_a_wall.lua")
local args = trocar.args
local device = "laparoscope.device."
local requests = {}
if args.engage then
  requests = { { at = "0.2 s", ask = "home" }, { at = "0.6 s", ask = "engage" } }
end
local run = trocar.run {
  rate = args.rate, duration = args.duration, requests = requests,
  keep = {
    device .. "report_age", device .. "round_trip", device .. "write_time", device .. "reports_lost",
    device .. "reports_repeated", device .. "reports_refused", device .. "scale", "wall.force",
  },
}

-- From where it renders.
local settled = { from = "4 s" }
local function spread(signal)
  local all = run:samples(device .. signal, settled)
  table.sort(all)
  local function at(share) return all[math.max(1, math.ceil(share * #all))] end
  return { signal = signal, rows = #all, median = at(0.5), most = at(0.99), worst = all[#all] }
end
local function since_the_first_tick(signal) return run:last(device .. signal) - run:first(device .. signal) end
if args.engage then
  for _, signal in ipairs { "report_age", "round_trip", "write_time" } do
    trocar.publish("way", spread(signal))
  end
  trocar.publish("reports", {
    ticks = run.ticks, seconds = run.duration,
    lost = since_the_first_tick("reports_lost"), repeated = since_the_first_tick("reports_repeated"),
    refused = since_the_first_tick("reports_refused"),
    wall = -run:min("wall.force.z"), scale = run:last(device .. "scale"),
  })
end
