s/^step = .*/step = "3e-3 s"/
$a [method]\ndamping_rate = "1 1/s"
