# Single exponential
s/^autocorrelation = .*/autocorrelation = "single exponential"/
