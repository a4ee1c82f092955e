# Correlated with friction by -0.7
/^\[study\]/i\
[field.friction_angle]\
mean = "30 deg"\
cov = 0.1\
horizontal_scale = "2 m"\
vertical_scale = "1 m"\
cell = "0.1 m"\
\
[field.cross_correlation]\
parameters = ["friction_angle", "cohesion"]\
matrix = [[1, -0.7], [-0.7, 1]]\

