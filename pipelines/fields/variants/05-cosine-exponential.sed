# Cosine exponential
s/^autocorrelation = .*/autocorrelation = "cosine exponential"/
