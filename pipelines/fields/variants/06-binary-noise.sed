# Binary noise
s/^autocorrelation = .*/autocorrelation = "binary noise"/
