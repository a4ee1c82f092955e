# Bedded at 20 degrees, 10 m x 0.5 m
s/^autocorrelation = .*/autocorrelation = "second-order Markov"\nbedding_angle = "20 deg"/
s/^horizontal_scale = .*/horizontal_scale = "10 m"/
s/^vertical_scale = .*/vertical_scale = "0.5 m"/
