# Squared exponential
s/^autocorrelation = .*/autocorrelation = "squared exponential"/
