s/^step = .*/step = "3e-3 s"/
s/^points_per_cell = .*/points_per_cell = 4/
