# Averages over cells of 0.5 m
s/^cell = "0.1 m"/cell = "0.5 m"\naverage = "cell"/
