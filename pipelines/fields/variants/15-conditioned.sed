# Conditioned on two borings
s/^autocorrelation = .*/autocorrelation = "second-order Markov"\nmeasurements = "borings.tsv"/
s/^horizontal_scale = .*/horizontal_scale = "5 m"/
