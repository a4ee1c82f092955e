s/^step = .*/step = "3e-3 s"/
s/^points_per_cell = .*/points_per_cell = 3/
s/^cell = .*/cell = "0.3 m"/
s/"10.4 m"/"10.5 m"/
