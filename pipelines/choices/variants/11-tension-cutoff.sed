s/^step = .*/step = "3e-3 s"/
s/^cohesion = .*/&\ntension_cutoff = "0 kPa"/
