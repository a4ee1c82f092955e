# Matern, smoothness 0.25
s/^autocorrelation = .*/autocorrelation = "Matern"\nsmoothness = 0.25/
