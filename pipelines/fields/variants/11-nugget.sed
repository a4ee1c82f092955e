# Nugget of 0.3
s/^autocorrelation = .*/autocorrelation = "second-order Markov"\nnugget = 0.3/
