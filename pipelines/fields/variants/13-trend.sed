# Mean that grows by 4 kPa/m
s/^mean = .*/mean = "10 kPa"\nmean_gradient = "4 kPa\/m"/
