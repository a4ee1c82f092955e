s/^step = .*/step = "3e-3 s"/
$a [method]\nprecision = "single"
