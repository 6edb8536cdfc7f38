-- What the paper reports of its device, as it prints it.
return {
  table1 = {
    { axis = "x", desired = 5, slope = 4.9, error = 3.0, r2 = 0.993 },
    { axis = "x", desired = 15, slope = 14.4, error = 3.8, r2 = 0.974 },
    { axis = "y", desired = 6, slope = 5.8, error = 3.7, r2 = 0.992 },
    { axis = "y", desired = 18, slope = 17.5, error = 3.0, r2 = 0.988 },
  }, -- N/mm, N/mm, %
  chirp = { amplitude = 40, highest = 1, rms = 0.3 }, -- mm, Hz, % of something that is not stated
  workspace = { tool = 150, radius = 60, stroke = 120, roll = 480 }, -- mm, mm, mm, deg
}
