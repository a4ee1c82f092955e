s/^step = .*/step = "3e-3 s"/
s/^protocol = .*/protocol = "k0"/
