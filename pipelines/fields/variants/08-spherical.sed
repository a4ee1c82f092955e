# Spherical, elliptical lag
s/^autocorrelation = .*/autocorrelation = "spherical"\nlag = "elliptical"/
