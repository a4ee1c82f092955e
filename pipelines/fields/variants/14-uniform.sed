# Uniform marginal
s/^marginal = .*/marginal = "uniform"/
s/^autocorrelation = .*/autocorrelation = "second-order Markov"/
