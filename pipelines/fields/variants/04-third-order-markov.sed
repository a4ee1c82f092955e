# Third-order Markov
s/^autocorrelation = .*/autocorrelation = "third-order Markov"/
