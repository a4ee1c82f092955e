# Second-order Markov
s/^autocorrelation = .*/autocorrelation = "second-order Markov"/
