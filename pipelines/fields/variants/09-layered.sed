# Layered: 10 m x 0.5 m
s/^horizontal_scale = .*/horizontal_scale = "10 m"/
s/^vertical_scale = .*/vertical_scale = "0.5 m"/
